// Steady seepage through a rectangular block of grains between two levels of water, after Dupuit and Forchheimer:
//
//   -dh/dx = a Q / h + b Q^2 / h^2,   h = h_up at the upstream face, h_down at the other
//   u = Q / (phi h),   w = u (z / h) dh/dx,   p = rho g (h - z)                          riffle/seepage.hpp, Ergun's a and b
//
// z from the bottom of the block, x from its upstream face. It is compared inside the block alone. The field `local_depth` is
// h(x), the level of the water in the block. A dam break through the block comes to it when the levels change slowly, and then
// the discharge in the middle of the block is within 2 % of Q.
// Not in it: curved flow near the faces, a seepage face, storage in a block that drains.
#include <algorithm>
#include <cmath>
#include <memory>
#include <riffle/sdk.hpp>
#include <riffle/seepage.hpp>

namespace f = riffle::fields;

struct DupuitForchheimer {
  static constexpr auto id = "dupuit-forchheimer", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Steady seepage through a rectangular block between two levels of water";
  static constexpr auto source = "Dupuit (1863); Forchheimer (1901); Ergun (1952), as in Kazemi (2017) eq. 4.29";
  static constexpr auto leaves_out = "curved flow at the faces; a seepage face; storage in the block";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::real("position", "m", 0, -1e6, 1e6, "x of the upstream face of the block; flow along +x"),
      riffle::required_real("length", "m", 0, 1e6, "of the block along x", RIFFLE_ABOVE_MIN),
      riffle::required_real("depth_upstream", "m", 0, 1e4, "of the water before the block", RIFFLE_ABOVE_MIN),
      riffle::required_real("depth_downstream", "m", 0, 1e4, "of the water behind it, the smaller", RIFFLE_ABOVE_MIN),
      riffle::real("bottom", "m", 0, -1e6, 1e6, "level of the bottom"),
      riffle::required_real("grain_diameter", "m", 0, 1e3, "d_s of the block", RIFFLE_ABOVE_MIN),
      riffle::required_real("porosity", "1", 0, 1, "phi of the block", RIFFLE_ABOVE_MIN | RIFFLE_BELOW_MAX),
      riffle::real("c1", "1", 150, 0, 1e5, "viscous coefficient"),
      riffle::real("c2", "1", 1.75, 0, 1e3, "form coefficient"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity"),
      riffle::real("density", "kg.m-3", 1000, 0, 1e5, "of the water", RIFFLE_ABOVE_MIN, "fluid.density"),
      riffle::real("viscosity", "m2.s-1", 1e-6, 0, 1e3, "nu of the water", 0, "fluid.viscosity")};
  static constexpr const riffle_field* gives[] = {&f::velocity, &f::pressure, &f::local_depth};

  explicit DupuitForchheimer(const riffle::Values& v)
      : position(v.number("position")),
        length(v.number("length")),
        bottom(v.number("bottom")),
        phi(v.number("porosity")),
        g(v.number("gravity")),
        density(v.number("density")),
        up(v.number("depth_upstream")),
        law(riffle::porous_drag::ergun(phi, v.number("grain_diameter"), v.number("viscosity"), v.number("c1"),
                                       v.number("c2")),
            phi, g),
        block(law, length, up, v.number("depth_downstream")) {}

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const int dim = points.dim;
    const double q = block.discharge();
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double x = points.x[0][k] - position, z = points.x[dim - 1] != nullptr ? points.x[dim - 1][k] - bottom : -1;
      const double h = block.depth(x), u = q / (phi * h);
      for (int c = 0; c < dim; ++c) {
        values[c][k] = c == 0 ? u : c + 1 == dim ? -u * z / h * law(q / h) : 0;
        scales[c][k] = q / (phi * up);
      }
      values[dim][k] = density * g * (h - z);
      scales[dim][k] = density * g * up;
      values[dim + 1][k] = h;
      scales[dim + 1][k] = up;
      defined[k] = x >= 0 && x <= length && z >= 0 && z <= h ? 1 : 0;
    }
  }
  double position, length, bottom, phi, g, density, up;
  riffle::HydraulicGradient law;
  riffle::BlockSeepage block;
};

RIFFLE_PLUGIN(DupuitForchheimer)
