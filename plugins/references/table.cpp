// Measured or tabulated fields: depth and velocity as functions of x (and t), usually two columns of a CSV file:
//
//   [reference]
//   id = "table"
//   depth = { csv = "measured.csv", x = "x_m", value = "h_m" }
//   region = ["0.3 m", "4.27 m"]        # where there are measurements
//
// Between rows values are linear, beyond the first and last row they would go on as they are: say with `region` where the
// table holds. Of depth and velocity one may be left out. Errors are relative to h in depth and to sqrt(g h) in velocity,
// after eq. 17 of Diwakar & Mohapatra (2023); to |u| where no depth is given.
#include <algorithm>
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct Table {
  static constexpr auto id = "table", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Measured or tabulated depth and velocity, from CSV files";
  static constexpr auto source = "the file that the case names";
  static constexpr auto leaves_out = "what the table does not cover: limit it with reference.region";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::function("depth", "m", 0, "depth; zero or less means that there is no value"),
      riffle::function("velocity", "m.s-1", 0, "velocity"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit Table(const riffle::Values& v)
      : depth(v.given("depth") ? v.function("depth") : nullptr),
        velocity(v.given("velocity") ? v.function("velocity") : nullptr),
        g(v.number("gravity")) {}

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    for (const int c : {0, 1}) {
      const riffle_function* function = c == 0 ? depth : velocity;
      std::fill(values[c], values[c] + points.n, 0.0);
      std::fill(scales[c], scales[c] + points.n, 0.0);  // a scale of 0: not to be compared
      if (function != nullptr) {
        function->evaluate(function->context, points.n, points.x[0], nullptr, nullptr, points.time, values[c]);
      }
    }
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double h = values[0][k], u = values[1][k];
      defined[k] = std::isfinite(h) && std::isfinite(u) && (depth != nullptr ? h > 0 : velocity != nullptr) ? 1 : 0;
      if (defined[k] == 0) continue;
      scales[0][k] = h;
      if (velocity != nullptr) scales[1][k] = depth != nullptr ? std::sqrt(g * h) : std::abs(u);
    }
  }
  const riffle_function *depth, *velocity;
  double g;
};

RIFFLE_PLUGIN(Table)
