// A channel that narrows and widens again along a cosine, smooth at both ends and in the throat:
//
//   B = B_0 - (B_0 - B_t)/2 (1 + cos(pi (x - x_0) / a))  where |x - x_0| < a,  else B_0
#include <cmath>
#include <riffle/profile.hpp>
#include <riffle/sdk.hpp>

struct Contraction {
  static constexpr auto id = "contraction", kind = "width", version = "1.0.0";
  static constexpr auto summary = "A cosine-shaped contraction of the channel";
  static constexpr auto source = "geometry";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::real("width", "m", 1, 0, 1e5, "B_0 up- and downstream", RIFFLE_ABOVE_MIN),
      riffle::required_real("throat_width", "m", 0, 1e5, "B_t; more than the width makes an expansion",
                            RIFFLE_ABOVE_MIN),
      riffle::required_real("center", "m", -1e6, 1e6, "x_0 of the throat"),
      riffle::required_real("half_length", "m", 0, 1e6, "a: distance from the throat to the parallel walls",
                            RIFFLE_ABOVE_MIN)};

  explicit Contraction(const riffle::Values& v)
      : width(v.number("width")),
        narrowing(v.number("width") - v.number("throat_width")),
        center(v.number("center")),
        half(v.number("half_length")) {}

  void profile(std::int64_t n, const double* x, const double*, double* b, double* slope_x, double* slope_y) const {
    constexpr double pi = 3.14159265358979323846;
    riffle::profile_along_x(n, x, b, slope_x, slope_y, [this](double at) {
      const double s = (at - center) / half;
      if (!(std::abs(s) < 1)) return riffle::ProfilePoint{width, 0};
      return riffle::ProfilePoint{width - narrowing / 2 * (1 + std::cos(pi * s)),
                                  narrowing / 2 * pi / half * std::sin(pi * s)};
    });
  }
  double width, narrowing, center, half;
};

RIFFLE_PLUGIN(Contraction)
