// Solitary wave over a level bed, which travels without change of shape: the exact one of the Serre equations,
//
//   h = h0 + A sech^2(kappa s),   kappa = sqrt(3 A / (4 h0^2 (h0 + A))),   c = sqrt(g (h0 + A)),   u = c (1 - h0 / h)
//
// and two expansions of that of Euler's equations in e = A / h0, with u = c (1 - h0 / h) from the conservation of water:
//   first order (Boussinesq 1872):   kappa h0 = sqrt(3 e / 4),   c^2 = g h0 (1 + e)
//   third order (Fenton 1972):       kappa h0 = sqrt(3 e / 4) (1 - 5/8 e + 71/128 e^2),
//     h / h0 = 1 + e S - 3/4 e^2 S T + e^3 (5/8 S T - 101/80 S^2 T),  S = sech^2(kappa s), T = 1 - S,
//     c^2 = g h0 (1 + e - e^2/20 - 3/70 e^3)
//
// s = x - x0 - c t, or its mirror for a wave that runs to the left. Errors are relative to h in depth and to sqrt(g h) in
// velocity. Not in it: ends of the channel, friction; the third order is good up to about e = 0.6, waves break near 0.8.
#include <algorithm>
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct SolitaryWave {
  static constexpr auto id = "solitary-wave", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Solitary wave over a level bed: exact for the Serre equations, or expanded";
  static constexpr auto source =
      "Serre (1953); Boussinesq (1872); Fenton (1972) third order, as in Kazemi (2017) section 5.3";
  static constexpr auto leaves_out = "ends of the channel, friction, breaking (near A = 0.8 h0)";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("depth", "m", 0, 1e4, "h0: depth of the water at rest", RIFFLE_ABOVE_MIN),
      riffle::required_real("amplitude", "m", 0, 1e4, "A: height of the crest above the water at rest",
                            RIFFLE_ABOVE_MIN),
      riffle::required_real("position", "m", -1e6, 1e6, "x0: of the crest at t = 0"),
      riffle::choice("direction", "right|left", "right", "where it runs to"),
      riffle::choice("form", "serre|first-order|third-order", "serre", "which solution or expansion"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit SolitaryWave(const riffle::Values& v)
      : h0(v.number("depth")),
        amplitude(v.number("amplitude")),
        x0(v.number("position")),
        g(v.number("gravity")),
        direction(v.number("direction") == 0 ? 1 : -1),
        third(v.number("form") == 2) {
    const double e = amplitude / h0, first = std::sqrt(0.75 * e) / h0;
    if (v.number("form") == 0) {
      kappa = first / std::sqrt(1 + e);
      c = std::sqrt(g * h0 * (1 + e));
    } else if (!third) {
      kappa = first;
      c = std::sqrt(g * h0 * (1 + e));
    } else {
      kappa = first * (1 - 0.625 * e + 71.0 / 128 * e * e);
      c = std::sqrt(g * h0 * (1 + e - e * e / 20 - 3.0 / 70 * e * e * e));
    }
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const double e = amplitude / h0;
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double s = direction * (points.x[0][k] - x0) - c * points.time;
      const double q = 1 / std::cosh(std::min(std::abs(kappa * s), 300.0)), S = q * q, T = 1 - S;
      const double rise =
          third ? e * S - 0.75 * e * e * S * T + e * e * e * (0.625 * S * T - 101.0 / 80 * S * S * T) : e * S;
      const double h = h0 * (1 + rise);
      values[0][k] = h;
      values[1][k] = direction * c * (1 - h0 / h);
      scales[0][k] = h;
      scales[1][k] = std::sqrt(g * h);
      defined[k] = 1;
    }
  }
  double h0, amplitude, x0, g, direction;
  bool third;
  double kappa = 0, c = 0;
};

RIFFLE_PLUGIN(SolitaryWave)
