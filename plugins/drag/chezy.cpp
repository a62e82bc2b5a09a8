// Bed friction after Chezy, the oldest of the laws for uniform flow u = C sqrt(R S):
//
//   S_f = u |u| / (C^2 h),   du/dt = -g S_f = -lambda u   with   lambda = g |u| / (C^2 h)   [1/s]
//
// Given as a rate, it can only dissipate; applied point-implicitly (the default) it bounds no time step.
// Not in it: the side walls (h stands for the hydraulic radius R), and the growth of C with depth, C = h^(1/6) / n,
// which Manning's law has: choose C for the depths of the scene.
#include <riffle/bed_friction.hpp>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct Chezy {
  static constexpr auto id = "chezy", kind = "drag", version = "1.0.0";
  static constexpr auto summary = "Bed friction after Chezy, for shallow-water sets";
  static constexpr auto source = "Chezy (1775); Chow (1959) section 5-4, eq. 5-4";
  static constexpr auto leaves_out = "side walls: h stands for the hydraulic radius; the growth of C with depth";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;

  static constexpr riffle_parameter parameters[] = {
      riffle::real("coefficient", "m1/2.s-1", 50, 0, 1e4,
                   "Chezy's C: 30 for gravel, 50 for earth, 80 for smooth concrete, 100 for glass", RIFFLE_ABOVE_MIN),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN)};
  static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::depth)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit Chezy(const riffle::Values& v)
      : factor(v.number("gravity") / (v.number("coefficient") * v.number("coefficient"))) {}

  void run(const riffle::Block& b) const {
    riffle::add_bed_friction(b, [scale = factor](double speed, double depth) { return scale * speed / depth; });
  }
  double factor;
};

RIFFLE_PLUGIN(Chezy)
