// A column of water in place of a scene that is the same everywhere along x: which, and with which parameters.
#pragma once

#include <string>

#include "host/study/advise/model_notes.hpp"
#include "host/study/advise/plane_probe.hpp"

namespace riffle {

// The plugin of that kind, nullptr when the case has none or "none".
const PluginChoice* chosen(const Case& scene, const std::string& kind);

// Every drag and turbulence of the case is one that the column contains ("drag roughness-layer"), and a column with eddies is
// no model of water without.
bool has_closures_of(const ModelNotes& model, const Case& scene);

// The value that the case has for a parameter of the column, as for --set: by what its notes say, else by its name in any
// closure; "" when there is none.
std::string column_value(const ModelNotes& model, const ParameterDescription& wanted, const Case& scene,
                         const PlaneScales& scales);

}  // namespace riffle
