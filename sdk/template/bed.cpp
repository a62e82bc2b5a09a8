// What the bed is, in one line; author (year), equation. This one is a hump with a round top:
//
//   b = height * exp(-((x - centre) / half_width)^2)
//
// A bed gives its level and its slope at any x: equations, inflow, outflow and reference solutions ask it.
#include <algorithm>
#include <cmath>
#include <riffle/sdk.hpp>

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "bed", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equation; here made up";
  static constexpr auto leaves_out = "what it does not contain";

  static constexpr riffle_parameter parameters[] = {
      riffle::real("height", "m", 0.2, -1e4, 1e4, "of the top over the level at rest"),
      riffle::real("centre", "m", 5, -1e6, 1e6, "x of the top"),
      riffle::real("half_width", "m", 1, 0, 1e6, "distance at which the height has fallen to 1/e", RIFFLE_ABOVE_MIN)};

  explicit MyPlugin(const riffle::Values& v)
      : height(v.number("height")), centre(v.number("centre")), half_width(v.number("half_width")) {}

  // level [m] and its derivatives along x and y, which may be null; y is null where the scene has only x.
  void profile(std::int64_t n, const double* x, const double* /*y*/, double* level, double* slope_x,
               double* slope_y) const {
    for (std::int64_t k = 0; k < n; ++k) {
      const double s = (x[k] - centre) / half_width;
      level[k] = height * std::exp(-s * s);
      if (slope_x != nullptr) slope_x[k] = -2 * s / half_width * level[k];
    }
    if (slope_y != nullptr) std::fill_n(slope_y, n, 0.0);
  }
  double height, centre, half_width;
};

RIFFLE_PLUGIN(MyPlugin)
