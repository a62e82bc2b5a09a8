// Water at rest with a level surface over any bed:  h = max(level - b, 0),  u = 0.
//
// The plainest exact solution, and one that many schemes miss: pressure and bed push against each other along the whole
// channel and must cancel. Errors are relative to h in depth and to sqrt(g h) in velocity, after eq. 17 of Diwakar &
// Mohapatra (2023). A particle that has not moved and one that has drifted are compared where they are.
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct StillWater {
  static constexpr auto id = "still-water", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Water at rest with a level surface over the bed of the scene";
  static constexpr auto source = "hydrostatics";
  static constexpr auto leaves_out = "ponds of different levels";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("level", "m", -1e4, 1e4, "level of the surface"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit StillWater(const riffle::Values& v) : level(v.number("level")), g(v.number("gravity")) {}
  void connect(const riffle_services& s) { services = s; }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    for (std::int64_t k = 0; k < points.n; ++k) {
      double bed = 0, slope = 0;
      if (services.bed != nullptr) services.bed(services.context, 1, points.x[0] + k, nullptr, &bed, &slope, nullptr);
      const double h = level - bed;
      values[0][k] = scales[0][k] = h > 0 ? h : 0.0;
      values[1][k] = 0;
      scales[1][k] = std::sqrt(g * values[0][k]);
      defined[k] = h > 0 ? 1 : 0;
    }
  }
  double level, g;
  riffle_services services{};
};

RIFFLE_PLUGIN(StillWater)
