// Numbers of a scene along a channel.
#pragma once

#include "host/study/advise/advice.hpp"
#include "host/study/advise/dispersion.hpp"
#include "host/study/advise/scout.hpp"

namespace riffle {

struct ChannelScales {
  double depth = 0, deepest = 0;  // m: mean where it is wet, largest at any time
  double speed = 0;               // m/s, largest at any time
  double froude = 0;              // largest at any time
  double slope_length = 0;        // m: over which the level changes by a depth, at its steepest outside of fronts
  double moved = 0;               // share of the water that moved or rose, at any time
  double steady_from = 0;         // s, from which on the depth stays within a quarter of the tolerance of the last
  double reynolds = 0;            // speed times depth over viscosity
};

ChannelScales scales_of(const Scout& scout, const Case& scene, double tolerance);
std::vector<SceneFigure> figures_of(const ChannelScales& scales, const DispersionEstimate& dispersion,
                                    const Case& scene);

// Roughness height [m] of the drag of the case, by Strickler's n = k^(1/6) / 21.1 where it gives Manning's n or Chezy's C;
// NaN when it gives none.
double roughness_of(const Case& scene, double depth);

}  // namespace riffle
