// What the kernel is, in one line; author (year), equation. This one is the kernel of Lucy (1977), W = sigma l^-d w(q)
// with q = r / l and s = q / 2:
//
//   w = (1 + 3 s) (1 - s)^3 for s < 1;   sigma = 5/8, 5/(4 pi), 105/(128 pi) in 1, 2, 3 dimensions
//
// The host checks the integral, the sign of the slope, and every derivative against w, to 1e-10, before each run.
#include <riffle/radial_kernel.hpp>
#include <riffle/sdk.hpp>

struct MyPlugin : riffle::RadialKernel<MyPlugin> {
  using RadialKernel::RadialKernel;
  static constexpr auto id = "my-plugin", kind = "kernel", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equation; here Lucy (1977)";
  static constexpr auto leaves_out = "where it fails: particles pair when l exceeds about 1.3 spacings";
  static constexpr double support = 2;  // in units of l: everything below must be exactly 0 for q >= support

  static double normalisation(int dim) {
    return dim == 1 ? 5.0 / 8 : dim == 2 ? 5 / (4 * riffle::pi) : 105 / (128 * riffle::pi);
  }
  // The shape and its derivatives. They are called in vector loops: no branches, no functions of libm.
  template <int>
  static double w(double q) {
    const double s = 0.5 * q, t = std::max(0.0, 1 - s);
    return (1 + 3 * s) * t * t * t;
  }
  template <int>
  static double w1(double q) {  // w'(q) / q, finite at q = 0
    const double t = std::max(0.0, 1 - 0.5 * q);
    return -3 * t * t;
  }
  template <int>
  static double w2(double q) {  // w''(q)
    const double s = 0.5 * q, t = std::max(0.0, 1 - s);
    return -3 * t * (1 - 3 * s);
  }
};

RIFFLE_PLUGIN(MyPlugin)
