// The cubic spline: W = sigma l^-d w(q), support 2 l.
//
//   w = 1 - 3/2 q^2 + 3/4 q^3 for q < 1, (2 - q)^3 / 4 for q < 2;   sigma = 2/3, 10/(7 pi), 1/pi in 1, 2, 3 dimensions
//
// Eq. 6 of Diwakar & Mohapatra (2023) prints w without sigma / l: in one dimension 2 / (3 l) is missing there.
// In one dimension this is the cubic B-spline: on a lattice of spacing l, l/2, l/3, ... its sum is exactly one.
// Where it fails: particles pair when l exceeds about 1.3 spacings in two and three dimensions; w'' has kinks.
#include <riffle/radial_kernel.hpp>
#include <riffle/sdk.hpp>

struct CubicSpline : riffle::RadialKernel<CubicSpline> {
  using RadialKernel::RadialKernel;
  static constexpr auto id = "cubic-spline", kind = "kernel", version = "1.0.0";
  static constexpr auto summary = "Cubic B-spline of support 2 l, the usual kernel of shallow-water SPH";
  static constexpr auto source =
      "Monaghan & Lattanzio (1985); Diwakar & Mohapatra (2023) eq. 6, normalisation restored";
  static constexpr auto leaves_out = "particles pair when l exceeds about 1.3 spacings";
  static constexpr double support = 2;

  static double normalisation(int dim) {
    return dim == 1 ? 2.0 / 3 : dim == 2 ? 10 / (7 * riffle::pi) : 1 / riffle::pi;
  }
  template <int>
  static double w(double q) {
    const double outer = std::max(0.0, 2 - q), inner = std::max(0.0, 1 - q);
    return 0.25 * outer * outer * outer - inner * inner * inner;
  }
  template <int>
  static double w1(double q) {
    const double outer = std::max(0.0, 2 - q);
    const double far = -0.75 * outer * outer / std::max(1.0, q);
    return q < 1 ? 2.25 * q - 3 : far;
  }
  template <int>
  static double w2(double q) {
    return 1.5 * std::max(0.0, 2 - q) - 6 * std::max(0.0, 1 - q);
  }
};

RIFFLE_PLUGIN(CubicSpline)
