#include "host/cli/new_plugin.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>

#include "host/manifest/nearest.hpp"
#include "host/plugins/description.hpp"

namespace riffle {
namespace fs = std::filesystem;
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

std::string filled_in(const std::string& name, const std::string& id, const fs::path& sdk) {
  std::string text = plugin_templates().at(name);
  replace_all(text, "my-plugin", id);
  replace_all(text, "MyPlugin", class_name(id));
  replace_all(text, "@sdk@", sdk.generic_string());
  return text;
}

void write_file(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(fmt::format("{} cannot be written", path.string()));
}

void require_kind(const std::string& kind) {
  const auto& kinds = plugin_kinds();
  if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) return;
  throw std::runtime_error(
      fmt::format("there is no kind \"{}\"; kinds are {}{}", kind, fmt::join(kinds, ", "), did_you_mean(kind, kinds)));
}

void require_id(const std::string& id) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
  const bool good = !id.empty() && id.front() >= 'a' && id.front() <= 'z' && id.back() != '-' &&
                    std::all_of(id.begin(), id.end(), allowed);
  if (!good) {
    throw std::runtime_error(
        fmt::format("\"{}\" is no name for a plugin: small letters, digits and hyphens, such as "
                    "my-drag",
                    id));
  }
}

}  // namespace

std::string class_name(const std::string& id) {
  std::string name;
  bool upper = true;
  for (const char c : id) {
    if (c == '-') {
      upper = true;
    } else {
      name += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      upper = false;
    }
  }
  return name;
}

void write_plugin_project(const std::string& kind, const std::string& id, const fs::path& folder, const fs::path& sdk) {
  require_kind(kind);
  require_id(id);
  if (fs::exists(folder)) throw std::runtime_error(fmt::format("{} exists already", folder.string()));
  const fs::path aside = folder.string() + fmt::format(".partial-{}", getpid());
  try {
    fs::create_directories(aside);
    write_file(aside / (id + ".cpp"), filled_in(kind + ".cpp", id, sdk));
    write_file(aside / "CMakeLists.txt", filled_in("CMakeLists.txt", id, sdk));
    write_file(aside / "case.toml", filled_in(kind + ".toml", id, sdk));
    fs::rename(aside, folder);
  } catch (const std::exception& error) {
    std::error_code ignored;
    fs::remove_all(aside, ignored);
    throw std::runtime_error(fmt::format("{} cannot be made: {}", folder.string(), error.what()));
  }
}

}  // namespace riffle
