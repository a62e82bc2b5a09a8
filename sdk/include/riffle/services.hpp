// What a scene offers to its plugins beyond functions of place: riffle_services in abi.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

#include "riffle/abi.h"

namespace riffle {

// One sentence about a scene that can be computed and yet is doubtful; of the plugin `Plugin`, in its connect().
template <class Plugin>
void warn(const riffle_services& scene, const std::string& sentence) {
  if (scene.size < sizeof scene || scene.warn == nullptr) return;
  scene.warn(scene.context, (std::string(Plugin::kind) + " " + Plugin::id + ": " + sentence).c_str());
}

// Whether there is a scene with particles in a lattice; there is none where a plugin is only tried.
inline bool has_lattice(const riffle_services& scene) {
  return scene.size >= sizeof scene && scene.spacing > 0 && scene.dim > 1;
}

// Refuses a length that the whole domain cannot hold: nearly always millimetres taken for metres.
inline void require_within_domain(const riffle_services& scene, const char* what, double length) {
  if (!has_lattice(scene)) return;
  double largest = 0;
  for (int a = 0; a < scene.dim; ++a) largest = std::max(largest, scene.high[a] - scene.low[a]);
  if (length <= largest) return;
  std::ostringstream text;
  text << what << " of " << length << " m is larger than the domain, " << largest << " m: millimetres?";
  throw std::invalid_argument(text.str());
}

// The same of a level along the last axis.
inline void require_level_within_domain(const riffle_services& scene, const char* what, double level) {
  if (!has_lattice(scene)) return;
  const double low = scene.low[scene.dim - 1], high = scene.high[scene.dim - 1];
  if (level >= low && level <= high) return;
  std::ostringstream text;
  text << what << " at " << level << " m lies outside the domain, z from " << low << " to " << high << " m"
       << (level > 50 * high ? ": millimetres?" : "");
  throw std::invalid_argument(text.str());
}

// Spacing of the particles [m], from the measure of a cell where the scene does not say.
inline double particle_spacing(const riffle_services* scene, double cell_measure, int dim) {
  if (scene != nullptr && scene->size >= sizeof *scene && scene->spacing > 0) return scene->spacing;
  return dim == 2 ? std::sqrt(cell_measure) : dim == 3 ? std::cbrt(cell_measure) : cell_measure;
}

}  // namespace riffle
