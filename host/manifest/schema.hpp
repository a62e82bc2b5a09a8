// JSON Schema (draft-07) of the manifest, for editors that complete and check TOML (Even Better TOML, taplo).
#pragma once

#include <nlohmann/json.hpp>

#include "host/plugins/description.hpp"

namespace riffle {

// The whole manifest with the parameters of every plugin of the catalogue. Every manifest that read_case accepts is valid
// under it; what only the reader can know (units of texts, formulas, files) is not in it.
nlohmann::json manifest_schema(const PluginCatalogue& catalogue);

}  // namespace riffle
