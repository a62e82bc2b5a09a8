// What the model is, in one line; author (year), equation. This one is the depth-averaged eddy viscosity of a wide
// channel, with the shear velocity as a share of the mean one:
//
//   nu_t = c u_* h,   u_* = s |u|
//
// eddy_viscosity [m2/s] must not be negative. Equation sets that have no stress term leave it alone.
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;  // what there is to read and write: riffle/fields.h

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "turbulence", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equation; here Elder (1959) for the form of nu_t";
  static constexpr auto leaves_out = "what the model does not contain, and where it fails";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;  // scenes in one and two dimensions

  // name, unit, default, least, largest, meaning
  static constexpr riffle_parameter parameters[] = {
      riffle::real("coefficient", "1", 0.15, 0, 10, "c: 0.07 over the vertical, 0.15 across a straight channel"),
      riffle::real("shear_velocity_share", "1", 0.06, 0, 1, "s = u_* / |u|: 0.05 smooth, 0.1 rough")};

  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::depth)};
  static constexpr riffle_write writes[] = {riffle::set(f::eddy_viscosity)};

  explicit MyPlugin(const riffle::Values& v) : factor(v.number("coefficient") * v.number("shear_velocity_share")) {}

  void run(const riffle::Block& b) const {
    const double *u = b.in(0, 0), *v = b.dim() > 1 ? b.in(0, 1) : nullptr, *depth = b.in(1);
    double* eddy_viscosity = b.out(0);
    for (std::int64_t k = 0; k < b.size(); ++k) {
      const double speed = v == nullptr ? std::abs(u[k]) : std::sqrt(u[k] * u[k] + v[k] * v[k]);
      eddy_viscosity[k] = factor * speed * depth[k];
    }
  }
  double factor;
};

RIFFLE_PLUGIN(MyPlugin)
