#include "host/cli/common.hpp"

#include <cstdio>

#include "host/manifest/read.hpp"

namespace riffle {

std::filesystem::path program_directory() {
  std::error_code error;
  const auto self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::current_path() : self.parent_path();
}

// Installed <prefix>/lib/riffle/plugins, in the build tree <build>/plugins.
std::filesystem::path shipped_plugins() {
  const auto here = program_directory();
  const auto installed = here / ".." / "lib" / "riffle" / "plugins";
  if (std::filesystem::is_directory(installed)) return installed;
  return here / ".." / ".." / "plugins";
}

Registry open_registry(const std::vector<std::filesystem::path>& plugin_path, const std::filesystem::path& manifest) {
  std::filesystem::path folder;
  if (!manifest.empty()) folder = std::filesystem::absolute(manifest).parent_path();
  return Registry(plugin_search_path(plugin_path, folder, shipped_plugins()));
}

std::optional<Case> open_case(const std::filesystem::path& manifest, const std::vector<std::string>& overrides,
                              const Registry& registry) {
  try {
    return read_case(manifest, overrides, registry);
  } catch (const ManifestError& error) {
    for (const auto& line : error.lines()) std::fprintf(stderr, "%s\n", line.c_str());
    return std::nullopt;
  }
}

}  // namespace riffle
