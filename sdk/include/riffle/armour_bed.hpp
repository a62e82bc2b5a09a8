// A bed of packed grains under an armour layer, after chapter 6 of Kazemi (2017): its porosity by level, its drag, and its
// mixing length, as a column of riffle/column.hpp.
//
//   phi = phi0 below the trough z_t, 1 above the crest z_c; between, a linear ramp over the part f of the layer about z_m,
//   smoothed with cubic splines that reach from its ends to z_t and to z_c (section 6.2.1; the reach is a choice of ours):
//   phi = phi0 + (1 - phi0) / T [ R(z - z_lo; h_t) - R(z - z_hi; h_c) ],   T = f (z_c - z_t),   z_lo, z_hi = z_m -+ T/2
//   R(x; h) = h/120 [ (s+2)+^5 - 4 (s+1)+^5 + 6 (s)+^5 - 4 (s-1)+^5 + (s-2)+^5 ],   s = x / h
//   drag: Ergun (eq. 6.1) at and below the trough, C_d (1 - phi) / d (eq. 6.2) above it; mixing length of eq. 6.7
//
// Whatever z_m, phi0 is exact at the trough and 1 at the crest, and the grains of the layer fill a height of
// int (1 - phi) dz = (1 - phi0) [ z_m - z_t + (h_c^2 - h_t^2) / (6 T) ], the last term being 0 for a ramp in the middle.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "riffle/column.hpp"
#include "riffle/mixing_length.hpp"
#include "riffle/porous_drag.hpp"

namespace riffle {

struct ArmourBed {
  double bottom = 0, trough = 0, crest = 0;  // m: z_b, z_t, z_c
  double middle = 0;                         // m: z_m, within [trough + ramp/2, crest - ramp/2]
  double ramp_fraction = 0.5;                // f: thickness of the ramp over that of the layer
  double porosity = 0.22;                    // phi0, in the bed
  double diameter = 0;                       // m: d50
  double drag_coefficient = 0.9;             // C_d of the layer, with whatever factor 1/2 belongs to it
  double c1 = 150, c2 = 1.75;                // of Ergun
  double in_bed = 0.002, offset = 0, kappa_rough = 0, kappa_free = 0.22;  // l_mb [m], Delta z_0 [m], slopes of l_m
  double gravity = 9.81, viscosity = 1e-6;
  std::function<double(double)> profile;  // phi(z) in place of the ramp; none: the ramp

  [[nodiscard]] double half_ramp() const { return 0.5 * ramp_fraction * (crest - trough); }
  [[nodiscard]] double porosity_at(double z) const {
    if (profile) return profile(z);
    if (z >= crest) return 1;
    if (z <= trough) return porosity;
    const double low = middle - half_ramp(), high = middle + half_ramp();
    const double phi =
        porosity + (1 - porosity) / (2 * half_ramp()) *
                       (smooth_ramp(z - low, (low - trough) / 2) - smooth_ramp(z - high, (crest - high) / 2));
    return std::min(std::max(phi, porosity), 1.0);
  }
  [[nodiscard]] porous_drag::Coefficients drag_at(double z) const {
    const double phi = porosity_at(z);
    return z <= trough ? porous_drag::ergun(phi, diameter, viscosity, c1, c2)
                       : porous_drag::layer(phi, diameter, drag_coefficient);
  }
  // int (k1 u + k2 u^2) = g S0 far below the trough, where no stress comes down.
  [[nodiscard]] double velocity_in_bed(double slope) const {
    const auto k = porous_drag::ergun(porosity_at(bottom), diameter, viscosity, c1, c2);
    const double force = gravity * slope;
    return 2 * force / (k.linear + std::sqrt(k.linear * k.linear + 4 * k.quadratic * force));
  }
  [[nodiscard]] Column column(int cells = 400) const {
    Column c;
    c.gravity = gravity;
    c.viscosity = viscosity;
    c.bottom = bottom;
    c.interfaces = {trough, crest};
    c.cells = cells;
    const ArmourBed bed = *this;
    c.porosity = [bed](double z) { return bed.porosity_at(z); };
    c.linear_drag = [bed](double z) { return bed.drag_at(z).linear; };
    c.quadratic_drag = [bed](double z) { return bed.drag_at(z).quadratic; };
    const mixing_length::ThreeLayer length{trough - bottom, crest - bottom, offset, in_bed, kappa_rough, kappa_free};
    c.mixing_length = [length, z_b = bottom](double z, double level) { return length(z - z_b, level - z_b); };
    return c;
  }

 private:
  // int of the integral of the cubic spline of smoothing length h: 0 for x <= -2 h, x for x >= 2 h.
  static double smooth_ramp(double x, double h) {
    if (x <= -2 * h) return 0;
    if (x >= 2 * h) return x;
    const double s = x / h;
    const auto part = [](double t) { return t > 0 ? t * t * t * t * t : 0.0; };
    return h / 120 * (part(s + 2) - 4 * part(s + 1) + 6 * part(s) - 4 * part(s - 1) + part(s - 2));
  }
};

// Throws std::invalid_argument with one sentence when there is no such bed.
inline void check_armour_bed(const ArmourBed& bed, std::optional<double> level) {
  std::ostringstream text;
  const double thickness = bed.crest - bed.trough, z0 = bed.trough + bed.offset;
  if (!(bed.bottom < bed.trough && bed.trough < bed.crest)) {
    text << "levels: need bottom < trough < crest, got bottom = " << bed.bottom << " m, trough = " << bed.trough
         << " m, crest = " << bed.crest << " m";
  } else if (level && !(*level > bed.crest)) {
    text << "level: the water at " << *level << " m must stand above the crest at " << bed.crest
         << " m, below which the mixing length (eq. 6.7) is not defined";
  } else if (bed.diameter > thickness) {
    text << "grain_diameter of " << bed.diameter << " m is larger than the roughness layer of " << thickness
         << " m: millimetres?";
  } else if (z0 >= bed.crest) {
    text << "length_offset: the mixing length would begin to grow at " << z0 << " m, above the crest at " << bed.crest
         << " m";
  } else if (!bed.profile && std::abs(bed.middle - 0.5 * (bed.trough + bed.crest)) >
                                 0.5 * thickness - bed.half_ramp() + 1e-12 * thickness) {
    text << "middle of " << bed.middle << " m is outside [" << bed.trough + bed.half_ramp() << ", "
         << bed.crest - bed.half_ramp() << "] m: the ramp of the porosity would leave the roughness layer";
  } else {
    return;
  }
  throw std::invalid_argument(text.str());
}

}  // namespace riffle
