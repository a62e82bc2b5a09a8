// Measurements on the particles of a scene that resolves the depth: how deep it is, what drives it, what holds it back.
#pragma once

#include <vector>

#include "host/plugins/registry.hpp"
#include "host/study/advise/advice.hpp"
#include "host/study/advise/as_channel.hpp"

namespace riffle {

struct PlaneScales {
  std::int64_t particles = 0;
  WaterColumns columns;
  double spacing = 0, depth = 0, length = 0;  // m: between particles, mean of columns, extent of the water along x
  double bottom = 0;                          // m: level of the lowest water
  double drop = 0;                            // m: highest less lowest level
  double unevenness = 0;                      // deviation of the columns' heights over their mean
  double driving = 0;                         // m/s2: mean of the magnitude of what accelerates columns along x
  double initial_speed = 0;                   // m/s: mean over the water
  double speed = 0;                           // m/s: that this drives the water to
  double step = 0;                            // s: of time
  double sound_speed = 0;                     // m/s; 0: none
  double smallest_porosity = 1;
  bool porous = false;
  double grain = 0;                         // m, from a drag's parameters; 0: none
  double drag_share = 0;                    // share of the water on which drag acts
  double viscous_drag = 0, whole_drag = 0;  // 1/s, there, at rest and at `speed`; velocity rates of decay
  double eddy_stress = 0;                   // of a parabola of `speed` over the driving force times depth
  double laminar_stress = 0;                // the same of the water's own viscosity
  [[nodiscard]] bool has_drag() const { return drag_share > 0; }
};

// Throws what the simulation throws.
PlaneScales probe_plane(const Case& scene, const Registry& registry);

}  // namespace riffle
