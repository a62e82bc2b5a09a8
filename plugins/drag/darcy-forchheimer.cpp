// Drag of a porous medium whose permeability K and form coefficient C_F were measured, by Darcy's and Forchheimer's law:
//
//   -grad P = mu / K u_D + C_F / sqrt(K) rho u_D |u_D|,   u_D = phi u                          Kazemi (2017) eq. 2.21
//   lambda = phi nu / K + C_F phi^2 |u| / sqrt(K)   [1/s], on the intrinsic velocity u
//
// K holds at the porosity phi0 at which it was measured. Elsewhere, as in the transition to free water, it is scaled after
// Kozeny and Carman (eq. 4.27 of the source): K phi^3 / (1-phi)^2 over its value at phi0, so that there is no drag at phi = 1.
// With K of eq. 4.27 and C_F = c2 / sqrt(c1 phi0^3) it is Ergun's law at phi0.
// Not in it: added mass in unsteady flow, anisotropic media, Brinkman's term (that is the viscous stress of the equations).
#include <riffle/porous_drag.hpp>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct DarcyForchheimer {
  static constexpr auto id = "darcy-forchheimer", kind = "drag", version = "1.0.0";
  static constexpr auto summary = "Drag of a porous medium of known permeability and form coefficient";
  static constexpr auto source = "Darcy (1856); Forchheimer (1901); Kazemi (2017) eqs 2.20, 2.21, 4.27";
  static constexpr auto leaves_out = "added mass in unsteady flow; anisotropic media";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("permeability", "m2", 0, 1, "K: 1e-10 for sand, 1e-8 for gravel", RIFFLE_ABOVE_MIN),
      riffle::real("form_coefficient", "1", 0.5, 0, 1e3, "C_F"),
      riffle::required_real("porosity", "1", 0, 1, "phi0 at which they were measured",
                            RIFFLE_ABOVE_MIN | RIFFLE_BELOW_MAX),
      riffle::inherited("viscosity", "m2.s-1", "fluid.viscosity", 0, 1e3, "nu of the water")};
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::porosity)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit DarcyForchheimer(const riffle::Values& v)
      : permeability(v.number("permeability")),
        form(v.number("form_coefficient")),
        at(v.number("porosity")),
        nu(v.number("viscosity")) {}

  void run(const riffle::Block& b) const {
    riffle::porous_drag::add(b, [&](std::int64_t k, double speed) {
      return riffle::porous_drag::darcy_forchheimer(b.in(1)[k], permeability, form, at, nu).rate(speed);
    });
  }
  double permeability, form, at, nu;
};

RIFFLE_PLUGIN(DarcyForchheimer)
