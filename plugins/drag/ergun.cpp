// Drag of a packed bed of grains after Ergun, on the intrinsic velocity u of the water in its pores:
//
//   A = -c1 (1-phi)^2 / phi^2 nu / d_s^2 u - c2 (1-phi) / phi u |u| / d_s                 Kazemi (2017) eqs 4.29, 6.1
//   lambda = c1 (1-phi)^2 / phi^2 nu / d_s^2 + c2 (1-phi) / phi |u| / d_s   [1/s]
//
// With the filter velocity U = phi u it is Ergun's law for the hydraulic gradient, g i = a U + b U^2. Where phi = 1 there is
// no drag. Eq. 4.57 prints "- A" with an A that is negative already; as a rate it can only brake, and fine grains, whose
// lambda is thousands per second, bound no time step.
// 150 and 1.75 are Ergun's; Liu et al. (1999) took 200 and 1.1, van Gent (1995) 1000 and 1.1: compare them with the same word.
// Not in it: the inertia of water that moves around grains in waves (van-gent names it), turbulence within pores.
#include <riffle/porous_drag.hpp>
#include <riffle/sdk.hpp>
#include <riffle/services.hpp>

namespace f = riffle::fields;

struct Ergun {
  static constexpr auto id = "ergun", kind = "drag", version = "1.0.0";
  static constexpr auto summary = "Drag of packed grains after Ergun, viscous and form drag";
  static constexpr auto source = "Ergun (1952); Kazemi (2017) eqs 4.26-4.29, 6.1";
  static constexpr auto leaves_out = "added mass in unsteady flow; anisotropic beds";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("grain_diameter", "m", 0, 1e3, "d_s: mean diameter of the grains", RIFFLE_ABOVE_MIN),
      riffle::real("c1", "1", 150, 0, 1e5, "viscous coefficient"),
      riffle::real("c2", "1", 1.75, 0, 1e3, "form coefficient"),
      riffle::inherited("viscosity", "m2.s-1", "fluid.viscosity", 0, 1e3, "nu of the water")};
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::porosity)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit Ergun(const riffle::Values& v)
      : diameter(v.number("grain_diameter")), c1(v.number("c1")), c2(v.number("c2")), nu(v.number("viscosity")) {}

  void connect(const riffle_services& s) const { riffle::require_within_domain(s, "grain_diameter", diameter); }
  void run(const riffle::Block& b) const {
    riffle::porous_drag::add(b, [&](std::int64_t k, double speed) {
      return riffle::porous_drag::ergun(b.in(1)[k], diameter, nu, c1, c2).rate(speed);
    });
  }
  double diameter, c1, c2, nu;
};

RIFFLE_PLUGIN(Ergun)
