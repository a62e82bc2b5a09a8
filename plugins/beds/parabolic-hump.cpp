// A parabolic hump on a level bed, eq. 18 of Diwakar & Mohapatra (2023) with height 0.2 m, centre 5 m, half length 2 m:
//
//   b = b_0 (1 - (x - x_0)^2 / a^2)  where |x - x_0| < a,  else 0
//
// The slope jumps at both feet, from 0 to 2 b_0 / a; at a foot itself it is 0.
#include <cmath>
#include <riffle/profile.hpp>
#include <riffle/sdk.hpp>

struct ParabolicHump {
  static constexpr auto id = "parabolic-hump", kind = "bed", version = "1.0.0";
  static constexpr auto summary = "A parabolic hump on a level bed";
  static constexpr auto source = "Goutal & Maurel (1997); Diwakar & Mohapatra (2023) eq. 18";
  static constexpr riffle_parameter parameters[] = {
      riffle::real("height", "m", 0.2, -1e4, 1e4, "b_0 at the crest; negative for a hollow"),
      riffle::required_real("center", "m", -1e6, 1e6, "x_0 of the crest"),
      riffle::real("half_length", "m", 2, 0, 1e6, "a: distance from crest to foot", RIFFLE_ABOVE_MIN),
      riffle::real("level", "m", 0, -1e4, 1e4, "bed level beside the hump")};

  explicit ParabolicHump(const riffle::Values& v)
      : height(v.number("height")),
        center(v.number("center")),
        half(v.number("half_length")),
        level(v.number("level")) {}

  void profile(std::int64_t n, const double* x, const double*, double* b, double* slope_x, double* slope_y) const {
    riffle::profile_along_x(n, x, b, slope_x, slope_y, [this](double at) {
      const double s = (at - center) / half;
      if (!(std::abs(s) < 1)) return riffle::ProfilePoint{level, 0};
      return riffle::ProfilePoint{level + height * (1 - s * s), -2 * height * s / half};
    });
  }
  double height, center, half, level;
};

RIFFLE_PLUGIN(ParabolicHump)
