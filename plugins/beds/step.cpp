// A vertical step of the bed:  b = level before x_s,  level + height from x_s on.
//
// The slope of a step is no number: it is given as that of the flat parts, 0, and whoever needs the step itself looks at
// the level. A pointwise slope therefore does not see it at all; equation sets reconstruct the levels of a pair, or take
// the bed smoothed with the kernel of the depth.
#include <riffle/profile.hpp>
#include <riffle/sdk.hpp>

struct Step {
  static constexpr auto id = "step", kind = "bed", version = "1.0.0";
  static constexpr auto summary = "A vertical step of the bed";
  static constexpr auto source = "geometry";
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("position", "m", -1e6, 1e6, "x of the step"),
      riffle::required_real("height", "m", -1e4, 1e4, "rise of the bed along +x; negative for a drop"),
      riffle::real("level", "m", 0, -1e4, 1e4, "bed level before the step")};

  explicit Step(const riffle::Values& v)
      : position(v.number("position")), height(v.number("height")), level(v.number("level")) {}

  void profile(std::int64_t n, const double* x, const double*, double* b, double* slope_x, double* slope_y) const {
    riffle::profile_along_x(n, x, b, slope_x, slope_y, [this](double at) {
      return riffle::ProfilePoint{at < position ? level : level + height, 0};
    });
  }
  double position, height, level;
};

RIFFLE_PLUGIN(Step)
