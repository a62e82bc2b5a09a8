// The quintic spline: W = sigma l^-d w(q), support 3 l. With (a)+ = max(a, 0),
//
//   w = (3 - q)+^5 - 6 (2 - q)+^5 + 15 (1 - q)+^5;   sigma = 1/120, 7/(478 pi), 1/(120 pi) in 1, 2, 3 dimensions
//
// Smoother than the cubic spline (w'''' is continuous), so lattice sums and second derivatives are better, at 1.5 times
// the support: 1.5, 2.2, 3.4 times the neighbours. In one dimension it is the quintic B-spline: on a lattice of spacing
// l, l/2, l/3, ... its sum is exactly one. Where it fails: particles pair when l exceeds about 1.3 spacings.
#include <riffle/radial_kernel.hpp>
#include <riffle/sdk.hpp>

struct QuinticSpline : riffle::RadialKernel<QuinticSpline> {
  using RadialKernel::RadialKernel;
  static constexpr auto id = "quintic-spline", kind = "kernel", version = "1.0.0";
  static constexpr auto summary = "Quintic B-spline of support 3 l, for smooth gradients at more neighbours";
  static constexpr auto source = "Schoenberg (1946); Morris, Fox & Zhu (1997)";
  static constexpr auto leaves_out = "particles pair when l exceeds about 1.3 spacings";
  static constexpr double support = 3;

  static double normalisation(int dim) {
    return dim == 1 ? 1.0 / 120 : dim == 2 ? 7 / (478 * riffle::pi) : 1 / (120 * riffle::pi);
  }
  template <int>
  static double w(double q) {
    return fifth(std::max(0.0, 3 - q)) - 6 * fifth(std::max(0.0, 2 - q)) + 15 * fifth(std::max(0.0, 1 - q));
  }
  template <int>
  static double w1(double q) {
    const double a = std::max(0.0, 3 - q), b = std::max(0.0, 2 - q);
    const double far = (30 * b * b * b * b - 5 * a * a * a * a) / std::max(1.0, q);
    const double near = -120 + q * q * (120 - 50 * q);
    return q < 1 ? near : far;
  }
  template <int>
  static double w2(double q) {
    const double a = std::max(0.0, 3 - q), b = std::max(0.0, 2 - q), c = std::max(0.0, 1 - q);
    return 20 * (a * a * a - 6 * b * b * b + 15 * c * c * c);
  }
  static double fifth(double a) { return a * a * a * a * a; }
};

RIFFLE_PLUGIN(QuinticSpline)
