// What the model is, in one line; author (year), equation. This one is bed friction with a constant coefficient:
//
//   du/dt = -lambda u,   lambda = c_f |u| / h
//
// A drag gives the rate lambda >= 0 [1/s] and nothing else, so it can only dissipate, whatever the time step.
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;  // what there is to read and write: riffle/fields.h

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "drag", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equation";
  static constexpr auto leaves_out = "what the model does not contain, and where it fails";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;  // scenes in one and two dimensions

  // name, unit, default, least, largest, meaning
  static constexpr riffle_parameter parameters[] = {
      riffle::real("friction_coefficient", "1", 0.01, 0, 10, "c_f: 0.003 for concrete, 0.01 for gravel")};

  // Arrays over particles, in this order; drag_rate is added to, because there may be several drags.
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::depth)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit MyPlugin(const riffle::Values& v) : friction_coefficient(v.number("friction_coefficient")) {}

  void run(const riffle::Block& b) const {
    const double *u = b.in(0, 0), *v = b.dim() > 1 ? b.in(0, 1) : nullptr, *depth = b.in(1);
    double* lambda = b.out(0);
    for (std::int64_t k = 0; k < b.size(); ++k) {
      const double speed = v == nullptr ? std::abs(u[k]) : std::sqrt(u[k] * u[k] + v[k] * v[k]);
      lambda[k] += friction_coefficient * speed / depth[k];
    }
  }
  double friction_coefficient;
};

RIFFLE_PLUGIN(MyPlugin)
