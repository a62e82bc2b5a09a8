// What a model knows about itself that its tables have no word for: which parts of a flow it keeps and how it is best run.
// It stands in a file beside the library, <library>.model.toml, so that a model from outside this tree brings its own:
//
//   keeps = ["change along the flow", "vertical acceleration"]
//   preference = 1                  # among models that keep the same: the least first
//   cells_per_depth = 4             # spacing that it needs, where it needs one
//   contains = ["drag roughness-layer"]      # of a column: closures of a case that it has too
//   from = { slope = "equations.bed_slope" } # and its parameters that other plugins of the case have under another name, or what is
//                                 # measured: "depth of the water", "bottom of the water", "level of the water", "smallest porosity",
//                                 # "driving over gravity"
//   remark_where_water_breaks = "a sentence for those who run it so"
//   [set]                           # as --set; plugins.<kind> stands for the table of that kind, whatever its name
//   plugins.viscosity.id = "none"
//   [set_where_water_breaks]        # further ones
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/plugins/registry.hpp"
#include "host/study/advise/advice.hpp"

namespace riffle {

inline constexpr const char* along_the_flow = "change along the flow";
inline constexpr const char* over_the_depth = "velocity over the depth";
inline constexpr const char* vertical_acceleration = "vertical acceleration";

struct ModelNotes {
  const PluginDescription* plugin = nullptr;
  std::vector<std::string> keeps;
  double preference = 100, cells_per_depth = 0;
  bool needs_water_everywhere = false;  // it cannot wet what was dry at t = 0
  Overrides set, set_where_water_breaks;
  std::string remark_where_water_breaks;
  std::vector<std::string> contains;
  std::vector<std::pair<std::string, std::string>> from;
  [[nodiscard]] bool keeps_term(const std::string& term) const;
};

// Of all equation sets and references that have such a file, those first that keep least. Throws ManifestError when a file is wrong.
std::vector<ModelNotes> known_models(const PluginCatalogue& catalogue);

// The overrides that turn this case into that model: its plugin, then [set], with the tables of this case.
Overrides overrides_for(const ModelNotes& model, const Case& scene, bool water_breaks);

// "plugins.<kind>.key" with the slot that the case has for that kind.
std::string in_slots(const std::string& change, const Case& scene);

}  // namespace riffle
