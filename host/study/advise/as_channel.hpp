// A scene in the vertical plane as a channel: the same columns of water with their depth alone, for the rules that know what
// depth-averaged flow leaves out.
#pragma once

#include <string>
#include <vector>

#include "host/study/advise/model_notes.hpp"

namespace riffle {

// The water of the plane at t = 0, by columns of equal width from low to high: the level of its bottom and its height, 0
// where there is none.
struct WaterColumns {
  double low = 0, high = 0, spacing = 0;  // m; spacing: of the particles
  std::vector<double> bottom, height;
};

struct ChannelManifest {
  std::string text;      // a manifest, or
  std::string obstacle;  // why there is none
};

// `model`: the equation set that it names. What it cannot express is the obstacle: drag, eddies, pores, an uneven bottom, moving or
// shaped walls, open ends.
ChannelManifest as_channel(const Case& scene, const WaterColumns& columns, const ModelNotes& model,
                           const PluginCatalogue& catalogue);

}  // namespace riffle
