// Drag of grains on the water between them, A = k1 u + k2 u |u| per mass of water, u being the intrinsic velocity: the
// coefficients k1 [1/s] and k2 [1/m] by the porosity phi and the grain diameter d [m]. Kazemi (2017), signs and factors put
// right: A always acts against the velocity, so what a drag plugin adds to the rate is k1 + k2 |u|.
//
//   ergun        k1 = c1 (1 - phi)^2 / phi^2 nu / d^2,   k2 = c2 (1 - phi) / (phi d)                       eq. 4.29
//   darcy_forchheimer   k1 = phi nu / K,   k2 = C_F phi^2 / sqrt(K), K scaled by Kozeny and Carman         eq. 2.21
//   layer        k1 = 0,   k2 = C_d (1 - phi) / d, of single grains in a roughness layer                   eq. 6.2
//   spheres      k1 = 0,   k2 = 1/2 C_d W_d / d, of spheres whose crest is at R_d above the bed      eqs 3.3, 3.4, 3.17
//
// W_d is the share of a slice of width d that lies in the sphere: the chord at that height over the diameter, averaged over
// the thickness of the slice. Over half a sphere its mean is pi/4. The force of eq. 3.4 on a slice of height l0 over the area d l0 of eq. 3.3 is one per volume.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "riffle/block.hpp"

namespace riffle::porous_drag {

struct Coefficients {
  double linear = 0, quadratic = 0;  // k1 [1/s], k2 [1/m]
  [[nodiscard]] double rate(double speed) const { return linear + quadratic * speed; }
};

inline Coefficients ergun(double porosity, double diameter, double viscosity, double c1 = 150, double c2 = 1.75) {
  const double solid = std::max(1 - porosity, 0.0) / (porosity * diameter);
  return {c1 * solid * solid * viscosity, c2 * solid};
}

// K [m2] and C_F were measured at the porosity `at`; elsewhere K phi^3 / (1 - phi)^2 over its value there.
inline Coefficients darcy_forchheimer(double porosity, double permeability, double form_coefficient, double at,
                                      double viscosity) {
  const double pores = at / porosity, solid = std::max(1 - porosity, 0.0) / (1 - at);
  const double inverse = solid * solid * pores * pores * pores / permeability;  // 1 / K here
  return {porosity * viscosity * inverse, form_coefficient * porosity * porosity * std::sqrt(inverse)};
}

inline Coefficients layer(double porosity, double diameter, double drag_coefficient) {
  return {0, drag_coefficient * std::max(1 - porosity, 0.0) / diameter};
}

// W_d of a slice of water of a thickness [m] about a height above the numerical bed: the mean of the chord over it, or the
// chord itself for no thickness. 0 above the crest, and below the sphere where it stands clear of the bed.
inline double sphere_shape(double height, double roughness_height, double diameter, double thickness = 0) {
  const auto from_centre = [&](double z) {
    return std::min(std::max(2 * (z - roughness_height) / diameter + 1, -1.0), 1.0);
  };
  const double s = from_centre(height);
  if (!(thickness > 0)) return std::sqrt(1 - s * s);
  const auto area = [](double t) { return 0.5 * (t * std::sqrt(1 - t * t) + std::asin(t)); };
  return 0.5 * diameter / thickness *
         (area(from_centre(height + 0.5 * thickness)) - area(from_centre(height - 0.5 * thickness)));
}

inline Coefficients spheres(double height, double roughness_height, double diameter, double drag_coefficient,
                            double thickness = 0) {
  return {0, 0.5 * drag_coefficient * sphere_shape(height, roughness_height, diameter, thickness) / diameter};
}

// drag_rate += law(k, speed [m/s]) [1/s] for each particle k; reads velocity as in(0), adds to out(0).
template <class Law>
void add(const Block& b, Law law) {
  double* rate = b.out(0);
  for (std::int64_t k = 0; k < b.size(); ++k) {
    double square = 0;
    for (int c = 0; c < b.dim(); ++c) square += b.in(0, c)[k] * b.in(0, c)[k];
    rate[k] += law(k, std::sqrt(square));
  }
}

}  // namespace riffle::porous_drag
