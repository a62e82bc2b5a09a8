#include "host/plugins/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <stdexcept>

#include "host/plugins/check/checks.hpp"
#include "host/plugins/check/child.hpp"

namespace riffle {
namespace {

using check::Findings;
using KindAndId = std::pair<std::string, std::string>;

struct Check {
  const char* name;
  Findings (*run)(const Plugin&);
  const char* on_crash = "";  // what a crash here most likely means
};
constexpr std::array<Check, 10> checks{{
    {"creation", check::check_creation, ""},
    {"contract", check::check_contract, ""},
    {"bounds", check::check_bounds, ""},
    {"writes", check::check_writes, ""},
    {"inputs", check::check_inputs, "; its inputs are read-only here, so it probably writes to them"},
    {"blocks", check::check_blocks, ""},
    {"threads", check::check_threads, ""},
    {"dimensions", check::check_dimensions, ""},
    {"votes", check::check_votes, ""},
    {"speed", check::check_speed, ""},
}};

// True when passed.
bool report(std::ostream& out, const std::string& name, const Findings& findings) {
  for (const std::string& line : findings.failures) out << fmt::format("  FAIL  {:<11} {}\n", name, line);
  for (const std::string& line : findings.warnings) out << fmt::format("  warn  {:<11} {}\n", name, line);
  if (findings.failures.empty() && findings.warnings.empty()) {
    out << fmt::format("  ok    {:<11} {}\n", name, findings.summary);
  }
  out.flush();
  return findings.failures.empty();
}

// The library loaded in a child tells its plugins as a summary: one "kind id" after the other.
Findings load_in_child(const std::filesystem::path& file, std::vector<KindAndId>& plugins,
                       std::chrono::milliseconds limit) {
  Findings findings = check::in_child(
      [&] {
        std::vector<KindAndId> found;
        Findings inside = check::check_loading(file, found);
        for (const auto& [kind, id] : found) inside.summary += fmt::format("|{}|{}", kind, id);
        return inside;
      },
      limit);
  std::string& text = findings.summary;
  while (true) {
    const std::size_t id = text.rfind('|');
    if (id == std::string::npos) break;
    const std::size_t kind = text.rfind('|', id - 1);
    plugins.emplace(plugins.begin(), text.substr(kind + 1, id - kind - 1), text.substr(id + 1));
    text.resize(kind);
  }
  return findings;
}

Findings check_plugin(const std::filesystem::path& file, const KindAndId& wanted, const Check& check,
                      std::chrono::milliseconds limit) {
  return check::in_child(
      [&] {
        const Library library(file);
        for (const Plugin& plugin : library.plugins()) {
          if (plugin.description.kind == wanted.first && plugin.description.id == wanted.second) {
            return check.run(plugin);
          }
        }
        throw std::runtime_error("gives other plugins each time it is loaded");
      },
      limit);
}

}  // namespace

int check_library(const std::filesystem::path& file, std::ostream& out, std::chrono::milliseconds limit) {
  out << file.string() << '\n';
  std::vector<KindAndId> plugins;
  bool good = report(out, "library", load_in_child(file, plugins, limit));
  for (const KindAndId& plugin : plugins) {
    out << fmt::format("{} \"{}\"\n", plugin.first, plugin.second);
    for (const Check& check : checks) {
      Findings findings = check_plugin(file, plugin, check, limit);
      for (std::string& line : findings.failures) {
        if (line.starts_with("crashes") || line.starts_with("ends the whole")) line += check.on_crash;
      }
      good = report(out, check.name, findings) && good;
    }
  }
  return good ? 0 : 1;
}

}  // namespace riffle
