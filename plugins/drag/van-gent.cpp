// Drag of rock and gravel under waves after van Gent, on the intrinsic velocity u of the water in the pores:
//
//   i = a U + b U |U|,   a = alpha (1-phi)^2 / phi^3 nu / (g d^2),   b = beta (1 + 7.5 / KC) (1-phi) / phi^3 / (g d),   U = phi u
//   lambda = alpha (1-phi)^2 / phi^2 nu / d^2 + beta (1 + 7.5 / KC) (1-phi) / phi |u| / d   [1/s]
//
// The Keulegan-Carpenter number KC = U_m T / (phi d) says how far the water goes, in grains, in a wave; in steady flow there
// is none, and the factor is 1. alpha = 1000 and beta = 1.1 are van Gent's; 500 and 2.0 with KC = 128 are in use for breakwaters.
// Not in it: his third term, c dU/dt, the added mass of water that is accelerated around the grains (0.34 (1-phi)/phi of it).
#include <riffle/porous_drag.hpp>
#include <riffle/sdk.hpp>
#include <riffle/services.hpp>

namespace f = riffle::fields;

struct VanGent {
  static constexpr auto id = "van-gent", kind = "drag", version = "1.0.0";
  static constexpr auto summary = "Drag of rock and gravel under waves after van Gent, with KC";
  static constexpr auto source = "van Gent (1995); Liu et al. (1999)";
  static constexpr auto leaves_out = "added mass c dU/dt; a KC that changes with place and time";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("grain_diameter", "m", 0, 1e3, "d, of half the grains by weight", RIFFLE_ABOVE_MIN),
      riffle::real("alpha", "1", 1000, 0, 1e5, "viscous coefficient"),
      riffle::real("beta", "1", 1.1, 0, 1e3, "form coefficient"),
      riffle::real("keulegan_carpenter", "1", 0, 0, 1e9, "KC of the waves in the pores; 0: steady flow, factor 1"),
      riffle::inherited("viscosity", "m2.s-1", "fluid.viscosity", 0, 1e3, "nu of the water")};
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::porosity)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit VanGent(const riffle::Values& v)
      : diameter(v.number("grain_diameter")),
        alpha(v.number("alpha")),
        beta(v.number("beta") * (v.number("keulegan_carpenter") > 0 ? 1 + 7.5 / v.number("keulegan_carpenter") : 1)),
        nu(v.number("viscosity")) {}

  void connect(const riffle_services& s) const { riffle::require_within_domain(s, "grain_diameter", diameter); }
  void run(const riffle::Block& b) const {
    riffle::porous_drag::add(b, [&](std::int64_t k, double speed) {
      return riffle::porous_drag::ergun(b.in(1)[k], diameter, nu, alpha, beta).rate(speed);
    });
  }
  double diameter, alpha, beta, nu;
};

RIFFLE_PLUGIN(VanGent)
