// Steady flow in a rectangular section: what a discharge q per unit width [m2/s] does at a depth h [m] under gravity g
// [m/s2]. Chow (1959) chapters 3 and 15. All of it is algebra, good to round-off (next to the critical depth to its root,
// which is the condition of the problem, not of the formula).
#pragma once

#include <algorithm>
#include <cmath>

namespace riffle::open_channel {

// h_c = (q^2 / g)^(1/3): the depth of least energy and of least momentum.
inline double critical_depth(double q, double g) {
  return std::cbrt(q * q / g);
}

// E = h + q^2 / (2 g h^2), the head above the bed [m].
inline double specific_energy(double h, double q, double g) {
  return h + q * q / (2 * g * h * h);
}

// M = q^2 / h + g h^2 / 2, momentum flux and thrust [m3/s2]; equal on both sides of a jump on a level bed.
inline double momentum_function(double h, double q, double g) {
  return q * q / h + g * h * h / 2;
}

// The two depths of one specific energy E: roots of h^3 - E h^2 + q^2 / (2 g) = 0. Where E is below the 3/2 h_c that the
// discharge needs there is none, and the critical depth is returned.
//   h = E/3 (1 + 2 cos(phi/3)) subcritical,  E/3 (1 + 2 cos((phi - 2 pi)/3)) supercritical,  cos phi = 1 - 27 q^2/(4 g E^3)
// The half angle keeps the digits that 1 - cos phi would lose at small q; one step of Newton's those of the second cosine.
inline double depth_of_energy(double energy, double q, double g, bool supercritical) {
  const double hc = critical_depth(q, g), sine_squared = 27 * q * q / (8 * g * energy * energy * energy);
  if (!(energy > 1.5 * hc) || !(sine_squared < 1)) return hc;
  const double phi = 2 * std::asin(std::sqrt(sine_squared)), third_of_turn = 2.0943951023931953;
  double h = energy / 3 * (1 + 2 * std::cos(phi / 3 - (supercritical ? third_of_turn : 0.0)));
  for (int i = 0; i < 2; ++i) {
    const double slope = h * (3 * h - 2 * energy);
    const double next = h - ((h - energy) * h * h + q * q / (2 * g)) / slope;
    if (!std::isfinite(next) || (supercritical ? next > hc : next < hc) || next <= 0) break;
    h = next;
  }
  return supercritical ? std::min(h, hc) : std::max(h, hc);
}

// Belanger (1828): the depth on the other side of a jump on a level bed, h2 = h1/2 (sqrt(1 + 8 Fr1^2) - 1); written so
// that no digits cancel at small Froude numbers.
inline double conjugate_depth(double h, double q, double g) {
  const double froude_squared = q * q / (g * h * h * h);
  return 4 * froude_squared * h / (1 + std::sqrt(1 + 8 * froude_squared));
}

}  // namespace riffle::open_channel
