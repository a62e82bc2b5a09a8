// The tables of a study that hold keys of the manifest: [set], [vary], [resolution], [closures.*].
#pragma once

#include "host/manifest/document.hpp"
#include "host/study/study.hpp"

namespace riffle {

// Reads them into `study`; a table that is absent leaves it as it is.
void read_variations(const TomlNode& root, Study& study, Mistakes& mistakes);

// "viscosity" for plugins.viscosity.id, "alpha" for plugins.viscosity.alpha.
std::string short_name(const std::string& key);

}  // namespace riffle
