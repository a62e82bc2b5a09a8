// The dissipation of a linearised Riemann problem between the two particles, with constant states.
//
//   Pi_ij h_ij = alpha c_ij w + beta max(w, 0)^2,   w = -(u_ij . x_ij) / r   the speed at which the pair closes
//
// To first order the pressure between two states is their mean plus impedance / 2 times w; beta adds the square of w, which
// strong shocks need. Independent of the spacing, so of first order: for smooth flow take riemann-muscl.
// It takes energy out of closing and of parting pairs alike; with approaching_only the latter are left alone.
// Not in it: a reconstruction, and the pressure difference's part in the contact speed.
#include <riffle/viscous_limit.hpp>

namespace f = riffle::fields;

struct RiemannDissipation {
  static constexpr auto id = "riemann", kind = "viscosity", version = "1.0.0";
  static constexpr auto summary = "Dissipation of a linearised Riemann problem, first order";
  static constexpr auto source = "Monaghan (1997), SPH and Riemann solvers; Toro (2001) ch. 5";
  static constexpr auto leaves_out = "a reconstruction: smooth flow is smeared at first order";
  static constexpr riffle_parameter parameters[] = {
      riffle::real("alpha", "1", 1.0, 0, 100, "1: the linearised Riemann problem; less rings, more smears"),
      riffle::real("beta", "1", 1.0, 0, 100, "quadratic coefficient, for strong shocks"),
      riffle::boolean("approaching_only", false, "leave parting pairs alone: for beds with steps")};
  static constexpr riffle_read reads[] = {riffle::pair(f::approach), riffle::pair(f::distance),
                                          riffle::mean(f::wave_speed)};
  static constexpr riffle_write writes[] = {riffle::set(f::viscous_pressure)};

  explicit RiemannDissipation(const riffle::Values& v)
      : alpha(v.number("alpha")), beta(v.number("beta")), parting(!v.flag("approaching_only")) {}

  void run(const riffle::Block& b) const {
    const double *approach = b.in(0), *r = b.in(1), *c = b.in(2);
    double* pi = b.out(0);
    const double least = parting ? -riffle::infinity : 0.0;
    RIFFLE_EACH(k, b) {
      const double speed = r[k] > 0 ? -approach[k] / r[k] : 0.0;
      const double closing = speed > 0 ? speed : 0.0, acting = speed > least ? speed : least;
      pi[k] = alpha * c[k] * acting + beta * closing * closing;
    }
  }

  struct Viscous : riffle::ViscousLimit<RiemannDissipation> {};
  using votes = riffle::Votes<Viscous>;
  double alpha, beta;
  bool parting;
};

RIFFLE_PLUGIN(RiemannDissipation)
