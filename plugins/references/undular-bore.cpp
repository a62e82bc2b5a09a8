// Dam break that becomes an undular bore, by modulation theory of the Serre equations: El, Grimshaw & Smyth (2006). The dam
// vanishes at t = 0 between two depths H > L of water at rest. A rarefaction runs into the deeper water, a train of waves
// into the shallower, and between them stands, with D = h_b / L and speeds in sqrt(g L),
//
//   h_b = (sqrt H + sqrt L)^2 / 4,   u_b = 2 (sqrt(g H) - sqrt(g h_b))
//   leading edge s+ (a solitary wave, so that the first crest is L s+^2 deep):
//                  D / sqrt(s+) = (3 / (4 - s+))^(21/10) (2 / (1 + s+))^(2/5)
//   trailing edge: s- = 2 sqrt D - 2 + beta^3 sqrt D,   D sqrt(beta) = ((4 - beta) / 3)^(21/10) ((1 + beta) / 2)^(2/5)
//
// Inside the train, and `margin` depths L around it, the theory knows averages only and this reference is not defined; at
// t = 0 that leaves room for a smoothed dam. It is the leading order of a closure for t -> infinity: plateau and crest are
// good to 0.1 % at D = 1.2, the crest is 1.3 % low at D = 1.37 and 2.4 % at D = 1.46. Above D = 1.43 it is refused unless
// `beyond_range = true`. Errors are relative to h in depth and to sqrt(g h) in velocity, after eq. 17 of Diwakar &
// Mohapatra (2023). Not in it: friction, ends of the channel, waves at the corners of the rarefaction, breaking.
#include <algorithm>
#include <cmath>
#include <riffle/sdk.hpp>
#include <sstream>
#include <stdexcept>

namespace f = riffle::fields;

struct UndularBore {
  static constexpr auto id = "undular-bore", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Dam break with dispersion: all but the waves, from modulation theory";
  static constexpr auto source =
      "El, Grimshaw & Smyth (2006), Phys. Fluids 18, 027104; range after the comparisons there";
  static constexpr auto leaves_out = "the waves themselves; friction; ends of the channel; breaking; early times";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr double range = 1.43;  // of D
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("dam_position", "m", -1e6, 1e6, "x of the dam"),
      riffle::required_real("depth_left", "m", 0, 1e4, "depth at rest where x < dam_position", RIFFLE_ABOVE_MIN),
      riffle::required_real("depth_right", "m", 0, 1e4, "depth at rest where x > dam_position", RIFFLE_ABOVE_MIN),
      riffle::real("margin", "1", 10, 0, 1e6, "of the smaller depth: how far around the waves nothing is compared"),
      riffle::boolean("beyond_range", false, "use the theory for bores of h_b above 1.43 L, too"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit UndularBore(const riffle::Values& v) : x_dam(v.number("dam_position")), g(v.number("gravity")) {
    const double left = v.number("depth_left"), right = v.number("depth_right");
    direction = left >= right ? 1 : -1;
    deep = std::max(left, right);
    shallow = std::min(left, right);
    margin = v.number("margin") * shallow;
    plateau = 0.25 * (std::sqrt(deep) + std::sqrt(shallow)) * (std::sqrt(deep) + std::sqrt(shallow));
    u_plateau = 2 * (std::sqrt(g * deep) - std::sqrt(g * plateau));
    const double jump = plateau / shallow;
    if (jump > range && v.number("beyond_range") == 0) {
      std::ostringstream text;
      text << "depth_left and depth_right make a bore of " << jump
           << " times the depth in front, and this theory holds up to " << range
           << " (1.3 % of the crest at 1.37, 2.4 % at 1.46); set beyond_range = true to use it all the same";
      throw std::invalid_argument(text.str());
    }
    const double unit = std::sqrt(g * shallow);
    leading = unit * root(1, 4, [&](double s) {
                return std::sqrt(s) * std::pow(3 / (4 - s), 2.1) * std::pow(2 / (1 + s), 0.4) - jump;
              });
    const double beta = root(
        0, 1, [&](double b) { return jump * std::sqrt(b) - std::pow((4 - b) / 3, 2.1) * std::pow((1 + b) / 2, 0.4); });
    trailing = unit * (2 * std::sqrt(jump) - 2 + beta * beta * beta * std::sqrt(jump));
  }

  // Where a function that rises from below 0 on (low, high) passes it, to the last bit.
  template <class Function>
  static double root(double low, double high, Function rising) {
    while (true) {
      const double middle = low + 0.5 * (high - low);
      if (!(middle > low && middle < high)) return middle;
      (rising(middle) < 0 ? low : high) = middle;
    }
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const double c = std::sqrt(g * deep), t = points.time, tail = u_plateau - std::sqrt(g * plateau);
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double x = direction * (points.x[0][k] - x_dam);  // compared with speeds times t: right at t = 0, too
      double h = shallow, u = 0;
      if (x < -c * t) {
        h = deep;
      } else if (x < tail * t) {
        h = (2 * c - x / t) * (2 * c - x / t) / (9 * g);
        u = 2 * (c + x / t) / 3;
      } else if (x < trailing * t) {
        h = plateau;
        u = u_plateau;
      }
      values[0][k] = h;
      values[1][k] = direction * u;
      scales[0][k] = h;
      scales[1][k] = std::sqrt(g * h);
      defined[k] = x < trailing * t - margin || x > leading * t + margin ? 1 : 0;
    }
  }
  double x_dam, g, direction = 1, deep = 0, shallow = 0, margin = 0, plateau = 0, u_plateau = 0, leading = 0,
                   trailing = 0;
};

RIFFLE_PLUGIN(UndularBore)
