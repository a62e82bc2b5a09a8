// The dissipation of a Lax-Friedrichs flux, as Ata & Soulaimani (2005) brought it to particles.
//
//   Pi_ij h_ij = alpha h_ij max(c_i, c_j) w / h_ij,   w = -(u_ij . x_ij) / r   the speed at which the pair closes
//
// It acts on the whole difference of velocities, so it is of first order: robust, and smeared where the flow is smooth.
// It takes energy out of closing and of parting pairs alike; with approaching_only the latter are left alone, which
// spares rarefactions and, above all, flow over a step of the bed.
// Not in it: a reconstruction; riemann-muscl has one, and a fifth of the error.
#include <riffle/viscous_limit.hpp>

namespace f = riffle::fields;

struct LaxFriedrichs {
  static constexpr auto id = "lax-friedrichs", kind = "viscosity", version = "1.0.0";
  static constexpr auto summary = "Dissipation of a Lax-Friedrichs flux, first order";
  static constexpr auto source = "Ata & Soulaimani (2005), A stabilized SPH method for inviscid shallow water flows";
  static constexpr auto leaves_out = "a reconstruction: smooth flow is smeared at first order";
  static constexpr riffle_parameter parameters[] = {
      riffle::real("alpha", "1", 1.0, 0, 100, "1: the flux of Lax and Friedrichs; less rings, more smears"),
      riffle::boolean("approaching_only", false, "leave parting pairs alone: for beds with steps")};
  static constexpr riffle_read reads[] = {riffle::pair(f::approach), riffle::pair(f::distance),
                                          riffle::at_i(f::wave_speed), riffle::at_j(f::wave_speed)};
  static constexpr riffle_write writes[] = {riffle::set(f::viscous_pressure)};

  explicit LaxFriedrichs(const riffle::Values& v) : alpha(v.number("alpha")), parting(!v.flag("approaching_only")) {}

  void run(const riffle::Block& b) const {
    const double *approach = b.in(0), *r = b.in(1), *ci = b.in(2), *cj = b.in(3);
    double* pi = b.out(0);
    const double least = parting ? -riffle::infinity : 0.0;
    RIFFLE_EACH(k, b) {
      const double c = ci[k] > cj[k] ? ci[k] : cj[k];
      const double speed = r[k] > 0 ? -approach[k] / r[k] : 0.0;
      pi[k] = alpha * c * (speed > least ? speed : least);
    }
  }

  struct Viscous : riffle::ViscousLimit<LaxFriedrichs> {};
  using votes = riffle::Votes<Viscous>;
  double alpha;
  bool parting;
};

RIFFLE_PLUGIN(LaxFriedrichs)
