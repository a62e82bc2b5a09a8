#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>

#include "host/plugins/check/checks.hpp"
#include "host/plugins/elf.hpp"

namespace riffle::check {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> other_symbols(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::vector<std::string> names;
  for (const ExportedSymbol& symbol : exported_symbols(std::as_bytes(std::span(text.data(), text.size())))) {
    // Marks of the linker and of sanitizers are no symbols of the author's.
    const bool mark = symbol.size == 0 || symbol.name.starts_with("__");
    if (symbol.name != "riffle_plugin_entry" && !mark) names.push_back(symbol.name);
  }
  return names;
}

std::ptrdiff_t threads() {
  return std::distance(fs::directory_iterator("/proc/self/task"), fs::directory_iterator());
}

}  // namespace

Findings check_loading(const fs::path& file, std::vector<std::pair<std::string, std::string>>& plugins) {
  Findings findings;
  const std::ptrdiff_t threads_before = threads();
  const auto start = std::chrono::steady_clock::now();
  try {
    const Library library(file);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const std::string& warning : library.warnings()) findings.fail(warning);
    for (const Plugin& plugin : library.plugins()) plugins.emplace_back(plugin.description.kind, plugin.description.id);
    if (threads() != threads_before) findings.fail("starts a thread when loaded");
    if (seconds > 0.1) findings.warn(fmt::format("takes {:.2f} s to load", seconds));
  } catch (const LibraryError& error) {
    for (const std::string& line : error.lines()) findings.fail(line);
    return findings;
  }
  const std::vector<std::string> others = other_symbols(file);
  if (!others.empty()) {
    findings.fail(
        fmt::format("exports {} symbol(s) besides riffle_plugin_entry ({}{}); hidden visibility keeps them "
                    "from mixing with those of other libraries",
                    others.size(), others.front(), others.size() > 1 ? ", ..." : ""));
  }
  findings.summary = "one exported symbol; arithmetic and threads untouched; descriptors good";
  return findings;
}

}  // namespace riffle::check
