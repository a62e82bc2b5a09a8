// riffle/radial_kernel.hpp: what every kernel W(r, l) = sigma l^-d w(q), q = r / l, has in common: its six outputs, its
// parameters and its lattice normalisation. An author derives from it and gives the shape:
//
//   struct MyKernel : riffle::RadialKernel<MyKernel> {
//     using RadialKernel::RadialKernel;
//     static constexpr auto id = ..., kind = "kernel", version = ..., summary = ..., source = ...;
//     static constexpr double support = 2;                 // kappa: w, w1 and w2 are exactly 0 for q >= kappa
//     static double normalisation(int dim);                // sigma
//     template <int dim> static double w(double q);        // the shape, decreasing
//     template <int dim> static double w1(double q);       // w'(q) / q: finite at q = 0, never positive
//     template <int dim> static double w2(double q);       // w''(q)
//   };
//
// The three functions are called inside vectorised loops: no calls to libm, no branch around a formula; select values
// (q < 1 ? a : b), and cut with std::max(0.0, ...). They may be called with any q >= 0, however large.
//
// With f' for the derivative to q, from W = sigma l^-d w(r / l):
//   F    = (dW/dr) / r  =  sigma l^-(d+2) w' / q
//   W_L  = dW/dl        = -sigma l^-(d+1) (d w + q w')
//   W_RR = d2W/dr2      =  sigma l^-(d+2) w''
//   W_RL = d2W/(dr dl)  = -sigma l^-(d+2) ((d + 1) w' + q w'')
//   W_LL = d2W/dl2      =  sigma l^-(d+2) (d (d + 1) w + 2 (d + 1) q w' + q^2 w'')
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "riffle/abi.h"
#include "riffle/values.hpp"

namespace riffle {

inline constexpr double pi = 3.14159265358979323846;

template <class Kernel>
class RadialKernel {
 public:
  // On by default because a depth is a sum over W: with it, still water on its lattice has the depth that the manifest
  // gives; without it, most kernels are off by 0.1 to 4 %. Where the density is evolved instead (continuity), only
  // gradients of W are used, and false is as good.
  static constexpr riffle_parameter parameters[] = {
      boolean("lattice_normalised", true,
              "divide W by its sum over the regular lattice of the initial spacing, so that still water has its depth; "
              "false: unit integral"),
      real("smoothing_ratio", "1", 1.3, 0.6, 10, "smoothing length over the spacing of that lattice", 0,
           "domain.smoothing_ratio")};
  static constexpr std::uint32_t provides = (1u << RIFFLE_KERNEL_OUTPUTS) - 1;  // hide it in a kernel that gives less

  explicit RadialKernel(const Values& v) : dim_(v.dim()), sigma_(Kernel::normalisation(v.dim())) {
    if (v.flag("lattice_normalised")) integral_ = 1 / lattice_sum(v.number("smoothing_ratio"));
    sigma_ *= integral_;
  }

  [[nodiscard]] riffle_kernel describe() const {
    return {sizeof(riffle_kernel), Kernel::provides, Kernel::support, integral_};
  }

  // out[b][k] for each bit b of `want`, for the pairs k < n; see riffle_plugin.evaluate_kernel.
  void evaluate(std::int64_t n, const double* r, const double* inverse_l, std::uint32_t want,
                double* const* out) const {
    switch (dim_) {
      case 1: return evaluate_in<1>(n, r, inverse_l, want, out);
      case 2: return evaluate_in<2>(n, r, inverse_l, want, out);
      default: return evaluate_in<3>(n, r, inverse_l, want, out);
    }
  }

 private:
  template <int power>  // by squaring: a^5 is three multiplications
  static double raised(double a) {
    if constexpr (power == 1) {
      return a;
    } else if constexpr (power % 2 == 0) {
      return raised<power / 2>(a) * raised<power / 2>(a);
    } else {
      return raised<power / 2>(a) * raised<power / 2>(a) * a;
    }
  }

  // One output by itself: out[k] = sigma l^-power shape(q).
  template <int power, class Shape>
  void each(std::int64_t n, const double* r, const double* inverse_l, double* out, Shape shape) const {
    const double sigma = sigma_;
#pragma omp simd
    for (std::int64_t k = 0; k < n; ++k) out[k] = sigma * raised<power>(inverse_l[k]) * shape(r[k] * inverse_l[k]);
  }

  template <int dim>
  void evaluate_in(std::int64_t n, const double* r, const double* inverse_l, std::uint32_t want,
                   double* const* out) const {
    if (want == (RIFFLE_W | RIFFLE_F)) return both<dim>(n, r, inverse_l, out[0], out[1]);
    if (want == (RIFFLE_W | RIFFLE_W_L | RIFFLE_W_LL)) return in_l<dim>(n, r, inverse_l, out[0], out[2], out[5]);
    if (want == (RIFFLE_F | RIFFLE_W_RR)) return in_r<dim>(n, r, inverse_l, out[1], out[3]);
    const auto w = [](double q) { return Kernel::template w<dim>(q); };
    const auto w1 = [](double q) { return Kernel::template w1<dim>(q); };
    const auto w2 = [](double q) { return Kernel::template w2<dim>(q); };
    if ((want & RIFFLE_W) != 0) each<dim>(n, r, inverse_l, out[0], w);
    if ((want & RIFFLE_F) != 0) each<dim + 2>(n, r, inverse_l, out[1], w1);
    if ((want & RIFFLE_W_L) != 0)
      each<dim + 1>(n, r, inverse_l, out[2], [=](double q) { return -(dim * w(q) + q * q * w1(q)); });
    if ((want & RIFFLE_W_RR) != 0) each<dim + 2>(n, r, inverse_l, out[3], w2);
    if ((want & RIFFLE_W_RL) != 0)
      each<dim + 2>(n, r, inverse_l, out[4], [=](double q) { return -q * ((dim + 1) * w1(q) + w2(q)); });
    if ((want & RIFFLE_W_LL) != 0)
      each<dim + 2>(n, r, inverse_l, out[5],
                    [=](double q) { return dim * (dim + 1) * w(q) + q * q * (2 * (dim + 1) * w1(q) + w2(q)); });
  }

  // W and F together, the commonest request: l^-d and q once.
  template <int dim>
  void both(std::int64_t n, const double* r, const double* inverse_l, double* w, double* f) const {
    const double sigma = sigma_;
#pragma omp simd
    for (std::int64_t k = 0; k < n; ++k) {
      const double a = inverse_l[k], q = r[k] * a, scale = sigma * raised<dim>(a);
      w[k] = scale * Kernel::template w<dim>(q);
      f[k] = scale * a * a * Kernel::template w1<dim>(q);
    }
  }

  // The first two derivatives to r together, as the motion of a summation depth wants them.
  template <int dim>
  void in_r(std::int64_t n, const double* r, const double* inverse_l, double* f, double* w_rr) const {
    const double sigma = sigma_;
#pragma omp simd
    for (std::int64_t k = 0; k < n; ++k) {
      const double a = inverse_l[k], q = r[k] * a, scale = sigma * raised<dim + 2>(a);
      f[k] = scale * Kernel::template w1<dim>(q);
      w_rr[k] = scale * Kernel::template w2<dim>(q);
    }
  }

  // W and its derivatives to l together, as Newton's method for the support wants them.
  template <int dim>
  void in_l(std::int64_t n, const double* r, const double* inverse_l, double* w, double* w_l, double* w_ll) const {
    const double sigma = sigma_;
#pragma omp simd
    for (std::int64_t k = 0; k < n; ++k) {
      const double a = inverse_l[k], q = r[k] * a, scale = sigma * raised<dim>(a);
      const double shape = Kernel::template w<dim>(q), slope = q * q * Kernel::template w1<dim>(q);
      w[k] = scale * shape;
      w_l[k] = -scale * a * (dim * shape + slope);
      w_ll[k] = scale * a * a * (dim * (dim + 1) * shape + 2 * (dim + 1) * slope + q * q * Kernel::template w2<dim>(q));
    }
  }

  // Sum over the points of the unit-measure lattice of spacing l / ratio, the one at the origin included, of
  // (l / ratio)^d W: what a kernel of unit integral makes of still water of depth 1.
  [[nodiscard]] double lattice_sum(double ratio) const {
    const auto reach = static_cast<int>(std::ceil(Kernel::support * ratio));
    const int y = dim_ >= 2 ? reach : 0, z = dim_ >= 3 ? reach : 0;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -y; j <= y; ++j) {
        for (int k = -z; k <= z; ++k) sum += shape(std::sqrt(double(i * i + j * j + k * k)) / ratio);
      }
    }
    return sum * sigma_ / std::pow(ratio, dim_);
  }
  [[nodiscard]] double shape(double q) const {
    return dim_ == 1 ? Kernel::template w<1>(q) : dim_ == 2 ? Kernel::template w<2>(q) : Kernel::template w<3>(q);
  }

  int dim_;
  double sigma_, integral_ = 1;
};

}  // namespace riffle
