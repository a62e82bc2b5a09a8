// From a TOML manifest to a checked case. docs/manifest.md explains the manifest to its users.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/manifest/case.hpp"
#include "host/manifest/mistakes.hpp"
#include "host/plugins/description.hpp"

namespace riffle {

// Reads and checks `file`; writes nothing. `overrides` are "dotted.key=value", applied in order before the check; setting
// the id of a plugin drops those of the file's parameters for the former plugin that the new one does not have. Throws
// ManifestError with every mistake. The case points into the catalogue, which must outlive it.
Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides,
               const PluginCatalogue& catalogue);

}  // namespace riffle
