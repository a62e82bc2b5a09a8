// Dam break on a wet bed, after Stoker (1957): the dam at x_d vanishes at t = 0 between two depths of water at rest on
// a horizontal, frictionless bed. A rarefaction runs into the deeper water (depth H), a shock into the shallower (L),
// and between them stands the depth h* at which both give the same velocity (flow towards the shallower side):
//
//   u* = 2 (sqrt(g H) - sqrt(g h*)) = (h* - L) sqrt(g/2 (h* + L) / (h* L)),   shock speed S = h* u* / (h* - L)
//
// With s = (distance from the dam towards the shallower side) / t and C = sqrt(g H), c* = sqrt(g h*):
//   s <= -C: H, 0;   s < u* - c*: h = (2 C - s)^2 / (9 g), u = 2/3 (C + s);   s < S: h*, u*;   beyond: L, 0
//
// At t = 0 it is the initial state. Errors are relative to h in depth and to sqrt(g h) in velocity, after eq. 17 of
// Diwakar & Mohapatra (2023). Not in it: friction and the ends of the channel: valid until a wave meets one.
#include <algorithm>
#include <cmath>
#include <riffle/sdk.hpp>
#include <sstream>
#include <utility>

namespace f = riffle::fields;

struct Stoker {
  static constexpr auto id = "stoker", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Exact dam break on a wet, horizontal, frictionless bed";
  static constexpr auto source =
      "Stoker (1957) section 10.8; Delestre et al. (2013) section 4.1.1; scales after Diwakar "
      "& Mohapatra (2023) eq. 17";
  static constexpr auto leaves_out = "friction; waves that come back from the ends of the channel; a dry bed (ritter)";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("dam_position", "m", -1e6, 1e6, "x of the dam"),
      riffle::required_real("depth_left", "m", 0, 1e4, "depth at rest where x < dam_position; above 0"),
      riffle::required_real("depth_right", "m", 0, 1e4, "depth at rest where x > dam_position; above 0"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit Stoker(const riffle::Values& v) : x_dam(v.number("dam_position")), g(v.number("gravity")) {
    const double left = v.number("depth_left"), right = v.number("depth_right");
    for (const auto& [name, depth] : {std::pair("depth_left", left), std::pair("depth_right", right)}) {
      if (depth > 0) continue;
      std::ostringstream text;
      text << name << " is " << depth
           << " m, but stoker needs water on both sides; a dry bed is the reference \"ritter\"";
      throw std::invalid_argument(text.str());
    }
    direction = left >= right ? 1 : -1;
    deep = std::max(left, right);
    shallow = std::min(left, right);
    h_star = deep * star(shallow / deep);
    u_star = 2 * (std::sqrt(g * deep) - std::sqrt(g * h_star));
    shock = std::sqrt(g * h_star * (h_star + shallow) / (2 * shallow));
  }

  // h* / H for r = L / H: the root in [r, 1] of 2 (1 - sqrt(y)) = (y - r) sqrt((y + r) / (2 y r)), whose left side falls
  // and right side rises. Newton, kept inside a shrinking bracket; it stops where round-off does.
  static double star(double r) {
    double low = r, high = 1, y = 0.25 * (1 + std::sqrt(r)) * (1 + std::sqrt(r));
    for (int i = 0; i < 200 && low < high; ++i) {
      const double root = std::sqrt((y + r) / (2 * y * r));
      const double residual = 2 * (1 - y) / (1 + std::sqrt(y)) - (y - r) * root;
      if (residual == 0) return y;
      (residual > 0 ? low : high) = y;
      const double slope = -1 / std::sqrt(y) - root + (y - r) / (4 * y * y * root);
      double next = y - residual / slope;
      if (next == y) return y;
      if (!(next > low && next < high)) next = std::sqrt(low * high);
      if (!(next > low && next < high)) return y;
      y = next;
    }
    return y;
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const double c = std::sqrt(g * deep), t = points.time, tail = u_star - std::sqrt(g * h_star);
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double x = direction * (points.x[0][k] - x_dam);  // compared with speeds times t: right at t = 0, too
      double h = shallow, u = 0;
      if (x < -c * t) {
        h = deep;
      } else if (x < tail * t) {
        h = (2 * c - x / t) * (2 * c - x / t) / (9 * g);
        u = 2 * (c + x / t) / 3;
      } else if (x < shock * t) {
        h = h_star;
        u = u_star;
      }
      values[0][k] = h;
      values[1][k] = direction * u;
      scales[0][k] = h;
      scales[1][k] = std::sqrt(g * h);
      defined[k] = 1;
    }
  }
  double x_dam, g, direction = 1, deep = 0, shallow = 0, h_star = 0, u_star = 0, shock = 0;
};

RIFFLE_PLUGIN(Stoker)
