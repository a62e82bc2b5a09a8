// What the commands share: where plugins are, how mistakes are shown, exit codes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/manifest/case.hpp"
#include "host/plugins/registry.hpp"

namespace riffle {

inline constexpr int exit_good = 0, exit_failed = 1, exit_bad_input = 2, exit_suspect = 3;

// Of the running executable.
std::filesystem::path program_directory();

// Where the plugins that come with the program are.
std::filesystem::path shipped_plugins();

// All plugins that the search path gives; `manifest` may be empty.
Registry open_registry(const std::vector<std::filesystem::path>& plugin_path, const std::filesystem::path& manifest);

// A checked case, or nothing: then every mistake has been printed to stderr, a line each.
std::optional<Case> open_case(const std::filesystem::path& manifest, const std::vector<std::string>& overrides,
                              const Registry& registry);

}  // namespace riffle
