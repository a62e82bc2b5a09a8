// Hydraulic jump on a level, frictionless bed, after Belanger (1828): a supercritical depth h1 and its conjugate h2,
//
//   h2 = h1/2 (sqrt(1 + 8 Fr1^2) - 1),   Fr1 = q / sqrt(g h1^3),   u = q / h on either side
//
// which carry the same momentum q^2/h + g h^2/2. Nothing in the equations says where such a jump stands: the place is a
// parameter, and a computed jump that stays near it has not drifted. With friction the place is determined: steady-flow.
// Errors are relative to h in depth and to sqrt(g h) in velocity, after eq. 17 of Diwakar & Mohapatra (2023).
// Not in it: the roller, and with it the length of the jump, some six times h2.
#include <cmath>
#include <riffle/open_channel.hpp>
#include <riffle/sdk.hpp>
#include <sstream>

namespace f = riffle::fields;

struct HydraulicJump {
  static constexpr auto id = "hydraulic-jump", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Jump between conjugate depths on a level, frictionless bed, at a given place";
  static constexpr auto source = "Belanger (1828); Chow (1959) eq. 3-21";
  static constexpr auto leaves_out = "friction, which determines where the jump stands (steady-flow); its length";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("discharge", "m2.s-1", 0, 1e6, "q per unit width, along +x", RIFFLE_ABOVE_MIN),
      riffle::required_real("jump_position", "m", -1e6, 1e6, "x of the jump"),
      riffle::required_real("depth_upstream", "m", 0, 1e4, "h1, below the critical depth", RIFFLE_ABOVE_MIN),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit HydraulicJump(const riffle::Values& v)
      : q(v.number("discharge")),
        h1(v.number("depth_upstream")),
        x_jump(v.number("jump_position")),
        g(v.number("gravity")) {
    const double critical = riffle::open_channel::critical_depth(q, g);
    if (h1 >= critical) {
      std::ostringstream text;
      text << "depth_upstream is " << h1
           << " m, but only supercritical flow can jump: it must be below the critical depth " << critical << " m";
      throw std::invalid_argument(text.str());
    }
    h2 = riffle::open_channel::conjugate_depth(h1, q, g);
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double h = points.x[0][k] < x_jump ? h1 : h2;
      values[0][k] = h;
      values[1][k] = q / h;
      scales[0][k] = h;
      scales[1][k] = std::sqrt(g * h);
      defined[k] = 1;
    }
  }
  double q, h1, x_jump, g, h2 = 0;
};

RIFFLE_PLUGIN(HydraulicJump)
