// What can be said of a scene before its first step: plugins that do nothing, and in two and three dimensions walls that are
// missing, beds that are thicker than the water, sound that is too slow and rows that are too few.
#pragma once

#include <string>
#include <vector>

#include "host/manifest/case.hpp"
#include "host/particles/store.hpp"
#include "host/schedule/graph.hpp"

namespace riffle {

struct SceneWarning {
  std::string name, text;  // as those of a verdict: "rows", and a sentence
  double value = 0, bound = 0;
};

// A sentence for each drag, turbulence, viscosity or filter of which no pass is left because nobody uses what it writes.
std::vector<std::string> idle_plugins(const Graph& graph);

// The deepest column of water, m: columns are two spacings wide in x and y; half a spacing is added at either end.
double deepest_water(const ParticleStore& store, double spacing);

// The plugin that reads a field which the host itself offers, such as `turbulence "mixing-length"`; empty: none does.
std::string reader_of_host_field(const Graph& graph, const std::string& field);

// Drags whose roughness_height [m] is not below the depth of the water: a sentence each.
std::vector<std::string> drowned_by_roughness(const Case& scene, double depth);

// What will make the result doubtful, a sentence each: sound slower than 1 % of compression needs, fewer than 20 rows. For
// equations whose speed of waves is a constant: that of sound.
std::vector<SceneWarning> doubtful_resolution(const Case& scene, const ParticleStore& store, double depth);

}  // namespace riffle
