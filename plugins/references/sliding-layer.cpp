// A layer of water let go on a slope at t = 0, deep beside the part of it that the bed has slowed down:
//
//   u = g S0 t (1 - 4 i2erfc(eta)),   4 i2erfc(eta) = (1 + 2 eta^2) erfc(eta) - 2 eta exp(-eta^2) / sqrt(pi),   eta = z / (2 sqrt(nu t))
//
// above a bed at rest at z = 0: the solution of du/dt = g S0 + nu d2u/dz2 (Carslaw & Jaeger 1959, section 2.5, for a half
// space whose face has a temperature that grows with time). Without a viscosity u = g S0 t everywhere: what the lock test asks
// for. Errors are relative to g S0 t.
// Not in it: eddies, drag, surface waves; layers so thin that their bed is felt at the surface, 5 sqrt(nu t).
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct SlidingLayer {
  static constexpr auto id = "sliding-layer", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "A layer of water let go on a slope, with or without the viscosity of the water";
  static constexpr auto source = "Newton's second law; Carslaw & Jaeger (1959) section 2.5";
  static constexpr auto leaves_out = "eddies, drag; layers thinner than 5 sqrt(nu t)";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("slope", "1", -0.999, 0.999, "S0, sine of the angle by which the x axis descends"),
      riffle::real("viscosity", "m2.s-1", 0, 0, 1e3, "nu above a bed that the water sticks to; 0: it slides"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::velocity};

  explicit SlidingLayer(const riffle::Values& v)
      : drive(v.number("gravity") * v.number("slope")), nu(v.number("viscosity")) {}
  void connect(const riffle_services& s) { bed = s.low[s.dim - 1]; }

  // Share of g S0 t that the bed has taken, at the height z.
  [[nodiscard]] double held_back(double z, double t) const {
    if (nu == 0 || t == 0) return 0;
    const double eta = std::max(z, 0.0) / (2 * std::sqrt(nu * t));
    constexpr double two_over_root_pi = 1.1283791670955126;
    return (1 + 2 * eta * eta) * std::erfc(eta) - two_over_root_pi * eta * std::exp(-eta * eta);
  }
  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const int up = points.dim - 1;
    const double all = drive * points.time;
    for (std::int64_t k = 0; k < points.n; ++k) {
      for (int c = 0; c <= up; ++c) {
        values[c][k] = 0;
        scales[c][k] = std::abs(all);
      }
      const double z = points.x[up] != nullptr ? points.x[up][k] - bed : riffle::infinity;
      values[0][k] = all * (1 - held_back(z, points.time));
      defined[k] = std::isfinite(values[0][k]) ? 1 : 0;
    }
  }
  double drive, nu, bed = 0;
};

RIFFLE_PLUGIN(SlidingLayer)
