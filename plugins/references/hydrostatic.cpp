// Water at rest in the vertical plane or in space, free or in the pores of grains, with a level surface:
//
//   u = 0,   p = rho0 c0^2 (exp(g (level - z) / c0^2) - 1),   rho = rho0 + p / c0^2
//
// which is rho0 g (level - z) for water that does not yield (sound_speed = 0). Pores do not change it: the grains carry their
// own weight. Errors of the pressure are relative to that at the bottom of the domain, of the density to rho0 g H / c0^2 (to
// rho0 without a sound speed), of the velocity to sqrt(g H).
// Not in it: basins that are not connected, capillary water above the level.
#include <algorithm>
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct Hydrostatic {
  static constexpr auto id = "hydrostatic", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Water at rest under a level surface, also in the pores of a bed";
  static constexpr auto source = "hydrostatics, with the linear equation of state";
  static constexpr auto leaves_out = "basins that are not connected; capillary water";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("level", "m", -1e6, 1e6, "level of the surface"),
      riffle::real("sound_speed", "m.s-1", 0, 0, 1e5, "c0 of the equations; 0: water that does not yield"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity"),
      riffle::real("density", "kg.m-3", 1000, 0, 1e5, "of the water at the surface", RIFFLE_ABOVE_MIN,
                   "fluid.density")};
  static constexpr const riffle_field* gives[] = {&f::velocity, &f::pressure, &f::density};

  explicit Hydrostatic(const riffle::Values& v)
      : level(v.number("level")), c0(v.number("sound_speed")), g(v.number("gravity")), rho0(v.number("density")) {}
  void connect(const riffle_services& s) { bottom = s.low[s.dim - 1]; }

  [[nodiscard]] double pressure(double below) const {
    return c0 > 0 ? rho0 * c0 * c0 * std::expm1(std::min(g * below / (c0 * c0), 300.0)) : rho0 * g * below;
  }
  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const int dim = points.dim;
    const double deep = std::max(level - bottom, 0.0), yields = c0 > 0 ? 1 / (c0 * c0) : 0;
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double below = points.x[dim - 1] != nullptr ? level - points.x[dim - 1][k] : -1;
      for (int c = 0; c < dim; ++c) {
        values[c][k] = 0;
        scales[c][k] = std::sqrt(g * deep);
      }
      values[dim][k] = pressure(below);
      scales[dim][k] = pressure(deep);
      values[dim + 1][k] = rho0 + yields * values[dim][k];
      scales[dim + 1][k] = c0 > 0 ? yields * scales[dim][k] : rho0;
      defined[k] = below >= 0 && std::isfinite(values[dim][k]) ? 1 : 0;
    }
  }
  double level, c0, g, rho0, bottom = 0;
};

RIFFLE_PLUGIN(Hydrostatic)
