// What a bed that is not level adds to the vertical acceleration of shallow water. Water over a bed b(x) rises at
// w(z) = db/dt + (z - b)/h dh/dt, with db/dt = b' u, so that its vertical motion holds per unit of mass
//
//   1/2 [ 1/3 (dh/dt + 3/2 db/dt)^2 + 1/4 (db/dt)^2 ]
//
// In the Lagrangian of riffle/dispersion_system.hpp that is: 3/2 b' on the diagonal of D, 3/2 b'' u^2 in its source, an inertia
// of b'^2/4 per unit of mass and a push of b' b'' u^2/4 against the water. Green & Naghdi (1976); in conservation form
// Zoppou, Roberts & Pitt (2017). The slope b' is the one that gravity sees, and b'' its curvature.
#pragma once

#include <cstdint>

#include "riffle/sdk.hpp"

namespace riffle::bed_motion {

inline constexpr riffle_field gradient =
    riffle::scalar_field("bed_rise_gradient", "1", "3/2 db/dx, which a bed adds to dh_i / dx_i");
inline constexpr riffle_field source = riffle::scalar_field(
    "bed_rise_source", "m.s-2", "3/2 d2b/dx2 u^2: what velocities over a bed give of the vertical acceleration");
inline constexpr riffle_field inertia =
    riffle::scalar_field("bed_rise_inertia", "1", "(db/dx)^2 / 4: inertia of water that follows a bed, over its mass");
inline constexpr riffle_field push =
    riffle::scalar_field("bed_rise_push", "m.s-2", "db/dx d2b/dx2 u^2 / 4: deceleration of water that follows a bed");

// `Plugin` says by `with_bed_terms` when the pass runs.
template <class Plugin>
struct Pass {
  static constexpr auto pass_name = "motion over the bed";
  static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED | RIFFLE_STEADY;
  static constexpr auto when = Plugin::with_bed_terms;
  static constexpr riffle_read reads[] = {riffle::at_i(fields::smoothed_bed_slope),
                                          riffle::at_i(fields::smoothed_bed_curvature), riffle::at_i(fields::velocity)};
  static constexpr riffle_write writes[] = {riffle::set(gradient), riffle::set(source), riffle::set(inertia),
                                            riffle::set(push)};
  static void run(const Plugin&, const riffle::Block& b) {
    const double *slope = b.in(0), *curvature = b.in(1), *u = b.in(2);
    double *rise = b.out(0), *rise_source = b.out(1), *heavier = b.out(2), *against = b.out(3);
    RIFFLE_EACH(k, b) {
      const double bend = curvature[k] * u[k] * u[k];
      rise[k] = 1.5 * slope[k];
      rise_source[k] = 1.5 * bend;
      heavier[k] = 0.25 * slope[k] * slope[k];
      against[k] = 0.25 * slope[k] * bend;
    }
  }
};

}  // namespace riffle::bed_motion
