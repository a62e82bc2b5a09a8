// Drag of a gravel bed under an armour layer: packed grains below the trough of the layer, single grains above it.
//
//   z <= z_t:   lambda = c1 (1-phi)^2 / phi^2 nu / d50^2 + c2 (1-phi) / phi |u| / d50   [1/s]      Kazemi (2017) eq. 6.1
//   z >  z_t:   lambda = C_d (1-phi) |u| / d50                                                                 eq. 6.2
//
// together eq. 6.3, and eq. 6.9 where the layer begins at some x only: upstream of it all is packed. C_2 = C_d phi there is
// eq. 6.2 written as eq. 6.1. Eq. 6.2 has lost the factor 1/2 of eq. 3.4, from which it comes: `half` puts it back.
// At the trough the coefficient of u |u| jumps by c2 / (C_d phi0), nearly 9 for phi0 = 0.22.
// Not in it: viscous drag in the roughness layer, grains one by one.
#include <riffle/porous_drag.hpp>
#include <riffle/sdk.hpp>
#include <riffle/services.hpp>

namespace f = riffle::fields;

struct ArmourLayer {
  static constexpr auto id = "armour-layer", kind = "drag", version = "1.0.0";
  static constexpr auto summary = "Drag of an armoured gravel bed: packed below the trough, single grains above";
  static constexpr auto source = "Ergun (1952); Schmeckle et al. (2007); Kazemi (2017) eqs 6.1-6.3, 6.9";
  static constexpr auto leaves_out = "viscous drag in the roughness layer; single grains";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("trough", "m", -1e6, 1e6, "z_t: level of the lowest point of the roughness layer"),
      riffle::required_real("grain_diameter", "m", 0, 1e3, "d50 of the bed", RIFFLE_ABOVE_MIN),
      riffle::real("drag_coefficient", "1", 0.9, 0, 1e6, "C_d of the layer: 0.76 spheres, 0.91 gravel, 1.36 cubes"),
      riffle::boolean("half", false, "multiply C_d by the 1/2 of eq. 3.4, which eq. 6.2 has lost"),
      riffle::real("c1", "1", 150, 0, 1e5, "viscous coefficient of the packed bed"),
      riffle::real("c2", "1", 1.75, 0, 1e3, "form coefficient of the packed bed"),
      riffle::real("from_x", "m", -1e6, -1e6, 1e6, "where the layer begins; upstream all is packed (X2 of eq. 6.9)"),
      riffle::inherited("viscosity", "m2.s-1", "fluid.viscosity", 0, 1e3, "nu of the water")};
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::porosity),
                                          riffle::at_i(f::position)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit ArmourLayer(const riffle::Values& v)
      : trough(v.number("trough")),
        diameter(v.number("grain_diameter")),
        coefficient(v.number("drag_coefficient") * (v.flag("half") ? 0.5 : 1)),
        c1(v.number("c1")),
        c2(v.number("c2")),
        from_x(v.number("from_x")),
        nu(v.number("viscosity")) {}

  void connect(const riffle_services& s) const { riffle::require_within_domain(s, "grain_diameter", diameter); }
  void run(const riffle::Block& b) const {
    const double *x = b.in(2, 0), *z = b.in(2, b.dim() - 1), *phi = b.in(1);
    riffle::porous_drag::add(b, [&](std::int64_t k, double speed) {
      const bool packed = z[k] <= trough || x[k] <= from_x;
      return (packed ? riffle::porous_drag::ergun(phi[k], diameter, nu, c1, c2)
                     : riffle::porous_drag::layer(phi[k], diameter, coefficient))
          .rate(speed);
    });
  }
  double trough, diameter, coefficient, c1, c2, from_x, nu;
};

RIFFLE_PLUGIN(ArmourLayer)
