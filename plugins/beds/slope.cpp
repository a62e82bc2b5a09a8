// A bed of constant slope:  b = level - S_0 (x - origin).
//
// S_0 is counted as in hydraulics: positive where the bed falls along +x.
#include <riffle/profile.hpp>
#include <riffle/sdk.hpp>

struct Slope {
  static constexpr auto id = "slope", kind = "bed", version = "1.0.0";
  static constexpr auto summary = "A bed of constant slope";
  static constexpr auto source = "geometry";
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("slope", "1", -10, 10, "S_0, positive where the bed falls along +x: 0.001 is 1 m per km"),
      riffle::real("origin", "m", 0, -1e6, 1e6, "x where the bed has its level"),
      riffle::real("level", "m", 0, -1e4, 1e4, "bed level at the origin")};

  explicit Slope(const riffle::Values& v)
      : fall(v.number("slope")), origin(v.number("origin")), level(v.number("level")) {}

  void profile(std::int64_t n, const double* x, const double*, double* b, double* slope_x, double* slope_y) const {
    riffle::profile_along_x(n, x, b, slope_x, slope_y, [this](double at) {
      return riffle::ProfilePoint{level - fall * (at - origin), -fall};
    });
  }
  double fall, origin, level;
};

RIFFLE_PLUGIN(Slope)
