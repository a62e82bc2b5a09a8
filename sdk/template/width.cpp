// What the width is, in one line; author (year), equation. This one is a round narrowing:
//
//   B = width - narrowing * exp(-((x - centre) / half_length)^2)
//
// A width gives B and dB/dx at any x, above 0 throughout the domain: equations, inflow and references ask it.
#include <algorithm>
#include <cmath>
#include <riffle/sdk.hpp>
#include <stdexcept>

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "width", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equation; here made up";
  static constexpr auto leaves_out = "what it does not contain";
  static constexpr std::uint32_t dims = 1u << 1;

  static constexpr riffle_parameter parameters[] = {
      riffle::real("width", "m", 1, 0, 1e4, "far from the narrowing", RIFFLE_ABOVE_MIN),
      riffle::real("narrowing", "m", 0.2, 0, 1e4, "how much is missing at its middle"),
      riffle::real("centre", "m", 5, -1e6, 1e6, "x of the narrowest place"),
      riffle::real("half_length", "m", 1, 0, 1e6, "distance at which the narrowing has fallen to 1/e",
                   RIFFLE_ABOVE_MIN)};

  explicit MyPlugin(const riffle::Values& v)
      : width(v.number("width")),
        narrowing(v.number("narrowing")),
        centre(v.number("centre")),
        half_length(v.number("half_length")) {
    if (!(narrowing < width)) throw std::invalid_argument("narrowing must be smaller than width");
  }

  // B [m] and dB/dx, which may be null; y and slope_y are for beds.
  void profile(std::int64_t n, const double* x, const double* /*y*/, double* value, double* slope_x,
               double* /*slope_y*/) const {
    for (std::int64_t k = 0; k < n; ++k) {
      const double s = (x[k] - centre) / half_length, missing = narrowing * std::exp(-s * s);
      value[k] = width - missing;
      if (slope_x != nullptr) slope_x[k] = 2 * s / half_length * missing;
    }
  }
  double width, narrowing, centre, half_length;
};

RIFFLE_PLUGIN(MyPlugin)
