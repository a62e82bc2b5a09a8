// Mixing lengths of open channels [m], by the height above the bed and the depth of the water [m]. Kazemi (2017):
//
//   prandtl      kappa z                                                                                  eq. 2.6
//   nezu_rodi    H kappa sqrt(1 - xi) / (1 / xi + pi Pi sin(pi xi)),  xi = z / H                          eq. 2.9
//                without the wake (Pi = 0) it is kappa z sqrt(1 - z / H)                                  eq. 3.8
//   van_driest   1 - exp(-z u* / (nu A+)), a factor for smooth walls                                      eq. 2.7
//   ThreeLayer   constant in the bed, linear in the roughness layer, as eq. 3.8 above its crest           eq. 6.7
//
// Outside of the water they are those of its nearest boundary. With any of them nu_t = l_m^2 |S|, |S| = sqrt(2 S:S).
#pragma once

#include <algorithm>
#include <cmath>

namespace riffle::mixing_length {

inline constexpr double pi = 3.14159265358979323846;

inline double prandtl(double height, double depth, double kappa) {
  return kappa * std::clamp(height, 0.0, depth);
}

inline double nezu_rodi(double height, double depth, double kappa, double coles = 0) {
  if (!(depth > 0)) return 0;
  const double xi = std::clamp(height / depth, 0.0, 1.0);
  return depth * kappa * xi * std::sqrt(1 - xi) / (1 + pi * coles * xi * std::sin(pi * xi));
}

// u* [m/s], nu [m2/s]; A+ is 26.
inline double van_driest(double height, double shear_velocity, double viscosity, double damping = 26) {
  return 1 - std::exp(-std::max(height, 0.0) * shear_velocity / (viscosity * damping));
}

// Levels as heights above the bed; z_0 = trough + offset is where the length begins to grow.
struct ThreeLayer {
  double trough = 0, crest = 0, offset = 0;
  double in_bed = 0;                       // l_mb [m]
  double kappa_rough = 0, kappa_free = 0;  // slopes below and above the crest
  [[nodiscard]] double at_crest() const { return in_bed + kappa_rough * std::max(crest - trough - offset, 0.0); }
  double operator()(double height, double depth) const {
    if (height <= crest) return in_bed + kappa_rough * std::max(height - trough - offset, 0.0);
    return at_crest() + nezu_rodi(height - crest, depth - crest, kappa_free);
  }
};

}  // namespace riffle::mixing_length
