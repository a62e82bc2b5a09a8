// Bed friction after Manning, through the C++ face: lambda = g n^2 |u| / h^(4/3), so that du/dt = -lambda u.
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct Manning {
  static constexpr auto id = "manning-outside", kind = "drag", version = "1.0.0";
  static constexpr auto summary = "Bed friction after Manning", source = "Manning (1891)";
  static constexpr riffle_parameter parameters[] = {
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 100, "acceleration of gravity"),
      riffle::real("roughness", "s.m-1/3", 0.03, 0, 1, "Manning's n: 0.01 for glass, 0.03 for gravel")};
  static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(f::depth)};
  static constexpr riffle_write writes[] = {riffle::sum(f::drag_rate)};

  explicit Manning(const riffle::Values& v) : factor(v.number("gravity") * std::pow(v.number("roughness"), 2)) {}

  void run(const riffle::Block& b) const {
    const double *u = b.in(0), *h = b.in(1);
    double* rate = b.out(0);
    RIFFLE_EACH(k, b) rate[k] += factor * std::abs(u[k]) / (h[k] * std::cbrt(h[k]));
  }
  double factor;
};

RIFFLE_PLUGIN(Manning)
