// The Wendland function of continuity C2: W = sigma l^-d w(q), support 2 l. With t = (1 - q/2)+,
//
//   one dimension:          w = t^3 (1 + 3/2 q),   sigma = 5/8
//   two, three dimensions:  w = t^4 (1 + 2 q),     sigma = 7/(4 pi), 21/(16 pi)
//
// The two differ because a function of least degree that is positive definite in three dimensions is not of least
// degree in one; many codes use the second everywhere. Its Fourier transform is positive, so particles do not pair,
// however many neighbours. Where it fails: its lattice sum is off by up to 4 % at l near one spacing, so keep
// lattice_normalised on where a depth is a sum, or l at 1.4 spacings and more.
#include <riffle/radial_kernel.hpp>
#include <riffle/sdk.hpp>

struct WendlandC2 : riffle::RadialKernel<WendlandC2> {
  using RadialKernel::RadialKernel;
  static constexpr auto id = "wendland-c2", kind = "kernel", version = "1.0.0";
  static constexpr auto summary = "Wendland C2 of support 2 l: cheap, and particles do not pair";
  static constexpr auto source = "Wendland (1995); Dehnen & Aly (2012) table 1, scaled to support 2 l";
  static constexpr auto leaves_out = "lattice sums are off by up to 4 % when l is near one spacing";
  static constexpr double support = 2;

  static double normalisation(int dim) {
    return dim == 1 ? 5.0 / 8 : dim == 2 ? 7 / (4 * riffle::pi) : 21 / (16 * riffle::pi);
  }
  template <int dim>
  static double w(double q) {
    const double t = std::max(0.0, 1 - 0.5 * q);
    return dim == 1 ? t * t * t * (1 + 1.5 * q) : t * t * t * t * (1 + 2 * q);
  }
  template <int dim>
  static double w1(double q) {
    const double t = std::max(0.0, 1 - 0.5 * q);
    return dim == 1 ? -3 * t * t : -5 * t * t * t;
  }
  template <int dim>
  static double w2(double q) {
    const double t = std::max(0.0, 1 - 0.5 * q);
    return dim == 1 ? 3 * t * (1.5 * q - 1) : 5 * t * t * (2 * q - 1);
  }
};

RIFFLE_PLUGIN(WendlandC2)
