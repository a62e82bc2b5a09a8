// What the solution is, in one line; author (year), equation. This one is a small standing wave in a closed channel:
//
//   h = h0 + a cos(k x) cos(omega t),   u = a omega / (k h0) sin(k x) sin(omega t),   k = pi n / L,  omega = k sqrt(g h0)
//
// which solves the shallow-water equations where a << h0. A reference gives exact or measured values at any place and
// time, and for each value the scale that makes its error relative.
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;  // what there is to give: riffle/fields.h

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "reference", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equation; here Lamb (1932), section 175";
  static constexpr auto leaves_out = "what it does not contain: terms of the order of (a / h0)^2";
  static constexpr std::uint32_t dims = 1u << 1;

  static constexpr riffle_parameter parameters[] = {
      riffle::real("depth", "m", 1, 0, 1e4, "h0: depth of the water at rest", RIFFLE_ABOVE_MIN),
      riffle::real("amplitude", "m", 0.01, 0, 1e4, "a"),
      riffle::real("length", "m", 10, 0, 1e6, "L: length of the channel, from x = 0", RIFFLE_ABOVE_MIN),
      riffle::integer("half_waves", 1, 1, 1000, "n: half waves along the channel"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN)};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit MyPlugin(const riffle::Values& v)
      : h0(v.number("depth")),
        a(v.number("amplitude")),
        k(3.14159265358979323846 * v.number("half_waves") / v.number("length")),
        speed(std::sqrt(v.number("gravity") * h0)) {}

  // values[g][p] is gives[g] at point p; defined[p] = 0 says that there is no answer there.
  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const double omega = k * speed;
    for (std::int64_t p = 0; p < points.n; ++p) {
      const double x = points.x[0][p];
      values[0][p] = h0 + a * std::cos(k * x) * std::cos(omega * points.time);
      values[1][p] = a * speed / h0 * std::sin(k * x) * std::sin(omega * points.time);
      scales[0][p] = h0;
      scales[1][p] = speed;
      defined[p] = 1;
    }
  }
  double h0, a, k, speed;
};

RIFFLE_PLUGIN(MyPlugin)
