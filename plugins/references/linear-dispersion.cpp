// Sinusoidal waves of small amplitude over a level bed, and the speed that each theory gives them:
//
//   h = h0 + a cos(k x - omega t),   u = a omega / (k h0) cos(k x - omega t)            running (or its mirror)
//   h = h0 + a cos(k x) cos(omega t),   u = a omega / (k h0) sin(k x) sin(omega t)      standing
//   shallow water:   omega^2 = g h0 k^2
//   Serre:           omega^2 = g h0 k^2 / (1 + (k h0)^2 / 3)          Serre (1953); all of B1, B2, B3
//   Airy:            omega^2 = g k tanh(k h0)                         Airy (1845), what water does
//   split:           omega^2 = g h0 k^2 (1 - (k h0)^2 / 3)            one explicit correction by B1, as in eqs 6 to 11 of
//                                                                     Diwakar & Mohapatra (2024); no wave above sqrt 3
// with u the mean over the depth, from the conservation of water. x counts from `position`. Errors are relative to a in
// depth, to a sqrt(g / h0) in velocity. Not in it: what is of second order in a / h0, which is at most 0.1; ends of the
// channel, unless walls stand at antinodes of the depth of a standing wave.
#include <cmath>
#include <riffle/sdk.hpp>
#include <sstream>
#include <stdexcept>

namespace f = riffle::fields;

struct LinearDispersion {
  static constexpr auto id = "linear-dispersion", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Sinusoidal waves with the phase speed of Serre, Airy, shallow water or the split";
  static constexpr auto source = "Airy (1845); Serre (1953); Diwakar & Mohapatra (2024) eqs 6-11 for the split";
  static constexpr auto leaves_out = "second order in the amplitude; ends of the channel that are not at antinodes";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("depth", "m", 0, 1e4, "h0: depth of the water at rest", RIFFLE_ABOVE_MIN),
      riffle::required_real("relative_amplitude", "1", 0, 0.1, "a / h0: half the height of the wave over the depth",
                            RIFFLE_ABOVE_MIN),
      riffle::required_real("wave_length", "m", 0, 1e6, "2 pi / k", RIFFLE_ABOVE_MIN),
      riffle::real("position", "m", 0, -1e6, 1e6, "x of a crest at t = 0"),
      riffle::choice("direction", "right|left|standing", "right", "where it runs to"),
      riffle::choice("theory", "serre|airy|shallow-water|split", "serre", "which phase speed"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit LinearDispersion(const riffle::Values& v)
      : h0(v.number("depth")),
        a(v.number("relative_amplitude") * h0),
        k(2 * 3.14159265358979323846 / v.number("wave_length")),
        x0(v.number("position")),
        g(v.number("gravity")),
        standing(v.number("direction") == 2),
        direction(v.number("direction") == 1 ? -1 : 1) {
    const double kh = k * h0, shallow = g * h0 * k * k;
    switch (static_cast<int>(v.number("theory"))) {
      case 0: omega = std::sqrt(shallow / (1 + kh * kh / 3)); break;
      case 1: omega = std::sqrt(g * k * std::tanh(kh)); break;
      case 2: omega = std::sqrt(shallow); break;
      default:
        if (kh * kh >= 3) {
          std::ostringstream text;
          text << "the split has no waves of k h0 above sqrt 3 = 1.732, they grow; k h0 is " << kh << " here";
          throw std::invalid_argument(text.str());
        }
        omega = std::sqrt(shallow * (1 - kh * kh / 3));
    }
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const double speed = a * omega / (k * h0);
    for (std::int64_t n = 0; n < points.n; ++n) {
      const double x = direction * (points.x[0][n] - x0), phase = k * x - omega * points.time;
      values[0][n] = h0 + a * (standing ? std::cos(k * x) * std::cos(omega * points.time) : std::cos(phase));
      values[1][n] = speed * (standing ? std::sin(k * x) * std::sin(omega * points.time) : direction * std::cos(phase));
      scales[0][n] = a;
      scales[1][n] = a * std::sqrt(g / h0);
      defined[n] = 1;
    }
  }

  double h0, a, k, x0, g;
  bool standing;
  double direction, omega = 0;
};

RIFFLE_PLUGIN(LinearDispersion)
