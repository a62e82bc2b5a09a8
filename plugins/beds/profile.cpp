// A bed of any shape: its level is a function of x in the manifest, as a constant, a formula, piecewise values or a table.
//
// Its slope is taken by differences. A step is a jump between piecewise values; it has no slope, and what becomes of the
// force on it is the equation set's business.
// Not in it: beds that move.
#include <riffle/profile.hpp>
#include <riffle/sdk.hpp>

struct ProfileBed {
  static constexpr auto id = "profile", kind = "bed", version = "1.0.0";
  static constexpr auto summary = "Bed level as any function of x: formula, piecewise values or table";
  static constexpr auto source = "Given by the manifest";
  static constexpr auto leaves_out = "beds that change in time";
  static constexpr riffle_parameter parameters[] = {
      riffle::function("level", "m", 0, "level of the bed along x, positive upwards", RIFFLE_REQUIRED)};

  explicit ProfileBed(const riffle::Values& v) : level(*v.function("level")) {}

  void profile(std::int64_t n, const double* x, const double* y, double* value, double* slope_x,
               double* slope_y) const {
    const auto at = [&](std::int64_t count, const double* place, double* out) {
      level.evaluate(level.context, count, place, nullptr, nullptr, 0, out);
    };
    (void)y;
    at(n, x, value);
    if (slope_x != nullptr) riffle::slope_by_differences(n, x, slope_x, at);
    if (slope_y != nullptr) std::fill_n(slope_y, n, 0.0);
  }
  const riffle_function& level;
};

RIFFLE_PLUGIN(ProfileBed)
