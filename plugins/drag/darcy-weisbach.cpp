// Bed friction after Darcy and Weisbach, with the friction factor f of pipes at four times the hydraulic radius:
//
//   S_f = f u |u| / (8 g h),   du/dt = -g S_f = -lambda u   with   lambda = f |u| / (8 h)   [1/s]
//
// Gravity drops out of the rate: of the three laws it is the one whose coefficient is a number. Given as a rate, it can
// only dissipate; applied point-implicitly (the default) it bounds no time step.
// Not in it: the side walls (h stands for the hydraulic radius), and the law by which f depends on roughness and
// Reynolds number (Colebrook and White): f is a constant of the scene.
#include <riffle/bed_friction.hpp>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct DarcyWeisbach {
  static constexpr auto id = "darcy-weisbach", kind = "drag", version = "1.0.0";
  static constexpr auto summary = "Bed friction after Darcy and Weisbach, for shallow-water sets";
  static constexpr auto source = "Weisbach (1845); Chow (1959) section 1-3, eq. 1-3";
  static constexpr auto leaves_out =
      "side walls: h stands for the hydraulic radius; how f depends on roughness and Reynolds number";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;

  static constexpr riffle_parameter parameters[] = {riffle::real(
      "friction_factor", "1", 0.03, 0, 100, "f: 0.015 for smooth walls, 0.03 for concrete, 0.1 for gravel")};
  static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::depth)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit DarcyWeisbach(const riffle::Values& v) : factor(v.number("friction_factor") / 8) {}

  void run(const riffle::Block& b) const {
    riffle::add_bed_friction(b, [scale = factor](double speed, double depth) { return scale * speed / depth; });
  }
  double factor;
};

RIFFLE_PLUGIN(DarcyWeisbach)
