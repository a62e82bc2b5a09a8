// Bed friction after Manning, eq. 11 of Diwakar & Mohapatra (2023):
//
//   S_f = n^2 u |u| / h^(4/3),   du/dt = -g S_f = -lambda u   with   lambda = g n^2 |u| / h^(4/3)   [1/s]
//
// Given as a rate, it can only dissipate; applied point-implicitly (the default) it bounds no time step, however thin
// the water.
// Not in it: the side walls (h stands for the hydraulic radius), and the laminar limit of very thin water, where n is
// no constant and the friction of a front is overestimated.
#include <cmath>
#include <riffle/bed_friction.hpp>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct Manning {
  static constexpr auto id = "manning", kind = "drag", version = "1.0.0";
  static constexpr auto summary = "Bed friction after Manning, for shallow-water sets";
  static constexpr auto source = "Manning (1891); Diwakar & Mohapatra (2023) eq. 11";
  static constexpr auto leaves_out = "side walls: h stands for the hydraulic radius; laminar flow in very thin water";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;

  static constexpr riffle_parameter parameters[] = {
      riffle::real("roughness", "s.m-1/3", 0.03, 0, 1,
                   "Manning's n: 0.01 for glass, 0.013 for concrete, 0.03 for gravel"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN)};
  static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::depth)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit Manning(const riffle::Values& v)
      : factor(v.number("gravity") * v.number("roughness") * v.number("roughness")) {}

  void run(const riffle::Block& b) const {
    riffle::add_bed_friction(
        b, [scale = factor](double speed, double depth) { return scale * speed / (depth * std::cbrt(depth)); });
  }
  double factor;
};

RIFFLE_PLUGIN(Manning)
