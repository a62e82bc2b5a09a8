// Overrides that take the place of something: a plugin, or the way particles are counted.
#pragma once

#include <string>
#include <vector>

#include "host/manifest/document.hpp"
#include "host/plugins/description.hpp"

namespace riffle {

// Applies "dotted.key=value" overrides in order. Then, so that one --set is enough to swap:
// - where the id of a plugin was overridden, keys of the file for the former plugin that the new one does not have go;
// - where the count of particles was overridden, the file's spacing goes, and the other way round.
// What came with --set itself always stays.
void apply_overrides(const std::vector<std::string>& overrides, TomlNode& root, const PluginCatalogue& catalogue,
                     Mistakes& mistakes);

}  // namespace riffle
