// Logarithmic velocities of uniform turbulent flow over a fully rough bed, and the stress that carries its weight:
//
//   u = u* (ln(z_w / k_s) / kappa + B_r)        Kazemi (2017) eq. 3.20, B_r = 8.5
//   tau = rho g S0 (H - z_w)                    eq. 3.21
//
// z_w is measured from the level `datum` and H is the depth above it; u* = sqrt(g H S0). It holds above the
// roughness, from the level `from` on, and strictly in the lower fifth of the depth alone. Errors are relative to the velocity
// at the surface and to rho g S0 H.
// Not in it: the wake of the outer layer, flow among the grains, secondary currents: in water as shallow as a few grains it is
// a shape to compare with rather than an answer; `uniform-flow-column` is that.
#include <cmath>
#include <riffle/weakly_compressible.hpp>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct LogLaw {
  static constexpr auto id = "log-law", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Logarithmic velocities of uniform flow over a rough bed, and its linear stress";
  static constexpr auto source = "Nikuradse (1933); Kazemi (2017) eqs 3.20, 3.21";
  static constexpr auto leaves_out = "the wake of the outer layer; flow among the grains";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("depth", "m", 0, 1e4, "H above the datum", RIFFLE_ABOVE_MIN),
      riffle::required_real("roughness", "m", 0, 1e3, "k_s of Nikuradse, about the diameter of the grains",
                            RIFFLE_ABOVE_MIN),
      riffle::required_real("slope", "1", 0, 0.999, "S0, sine of the angle by which the bed descends",
                            RIFFLE_ABOVE_MIN),
      riffle::real("datum", "m", 0, -1e6, 1e6, "level of z_w = 0"),
      riffle::real("from", "m", -1e6, -1e6, 1e6, "level above which it holds: the crest of the grains"),
      riffle::real("kappa", "1", 0.41, 0, 2, "von Karman's constant", RIFFLE_ABOVE_MIN),
      riffle::real("constant", "1", 8.5, -100, 100, "B_r"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity"),
      riffle::real("density", "kg.m-3", 1000, 0, 1e5, "of the water", RIFFLE_ABOVE_MIN, "fluid.density")};
  static constexpr const riffle_field* gives[] = {&f::velocity, &wc::modelled_shear_stress};

  explicit LogLaw(const riffle::Values& v)
      : depth(v.number("depth")),
        roughness(v.number("roughness")),
        datum(v.number("datum")),
        from(v.number("from")),
        kappa(v.number("kappa")),
        constant(v.number("constant")),
        density(v.number("density")),
        shear_velocity(std::sqrt(v.number("gravity") * depth * v.number("slope"))) {}

  [[nodiscard]] double velocity(double z) const {
    return shear_velocity * (std::log(z / roughness) / kappa + constant);
  }
  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const int dim = points.dim, up = dim - 1;
    const double bed_stress = density * shear_velocity * shear_velocity;
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double level = points.x[up] != nullptr ? points.x[up][k] : datum, z = level - datum;
      for (int c = 0; c < dim; ++c) {
        values[c][k] = 0;
        scales[c][k] = std::abs(velocity(depth));
      }
      const bool above = z > 0 && z <= depth && level >= from;
      if (above) values[0][k] = velocity(z);
      values[dim][k] = bed_stress * (1 - z / depth);
      scales[dim][k] = bed_stress;
      defined[k] = above && std::isfinite(values[0][k]) ? 1 : 0;
    }
  }
  double depth, roughness, datum, from, kappa, constant, density, shear_velocity;
};

RIFFLE_PLUGIN(LogLaw)
