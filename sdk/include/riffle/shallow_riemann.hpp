// riffle/shallow_riemann.hpp: the Riemann problem of the shallow-water equations between two states, solved
// approximately by its two outermost waves (HLL), in a frame that moves with the face.
//
// Harten, Lax & van Leer (1983). Speeds of the waves from the state between two rarefactions (Toro 2001, section 10.5)
// and, where one side is dry, from the front of a dam break on a dry bed: u_L + 2 c_L or u_R - 2 c_R.
// Made for vectorised loops: selected values instead of branches; the only function called is sqrt.
#pragma once

#include <cmath>

namespace riffle {

struct ShallowState {
  double h, u;  // depth [m] >= 0, velocity [m/s]
};

struct ShallowFlux {
  double volume;    // h (u - w) [m2/s]
  double momentum;  // h u (u - w) + g (h^2 - still^2) / 2 [m3/s2]
};

// Flux through a face that moves with `w`, L to the left of it and R to the right. Pressures count from that of still
// water of depth `still`, so that with the depth of one side equal depths at rest give exactly 0. A side is dry when its
// depth is at or below `dry`.
inline ShallowFlux hll_flux(double g, ShallowState L, ShallowState R, double w, double still, double dry) {
  const double c_l = std::sqrt(g * L.h), c_r = std::sqrt(g * R.h);
  const double between = 0.5 * (c_l + c_r) + 0.25 * (L.u - R.u), c_star = between > 0 ? between : 0.0;
  const double u_star = 0.5 * (L.u + R.u) + c_l - c_r;
  const double first = L.u - c_l, first_star = u_star - c_star, last = R.u + c_r, last_star = u_star + c_star;
  double s_l = first < first_star ? first : first_star, s_r = last > last_star ? last : last_star;
  s_l = R.h <= dry ? first : s_l;
  s_r = R.h <= dry ? L.u + 2 * c_l : s_r;
  s_r = L.h <= dry ? last : s_r;
  s_l = L.h <= dry ? R.u - 2 * c_r : s_l;
  const double a = s_l - w < 0 ? s_l - w : 0.0, b = s_r - w > 0 ? s_r - w : 0.0;
  const double inverse = b - a > 0 ? 1 / (b - a) : 0.0;
  const double q_l = L.h * L.u, q_r = R.h * R.u, v_l = L.u - w, v_r = R.u - w;
  const double p_l = 0.5 * g * (L.h - still) * (L.h + still), p_r = 0.5 * g * (R.h - still) * (R.h + still);
  return {(b * (L.h * v_l) - a * (R.h * v_r) + a * b * (R.h - L.h)) * inverse,
          (b * (q_l * v_l + p_l) - a * (q_r * v_r + p_r) + a * b * (q_r - q_l)) * inverse};
}

}  // namespace riffle
