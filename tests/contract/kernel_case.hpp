// A kernel in one dimension, looked at point by point.
#pragma once

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <map>
#include <string>

#include "tests/contract/loaded.hpp"

namespace riffle::contract {

class KernelCase {
 public:
  KernelCase(const riffle_plugin& plugin, int dim, const std::map<std::string, double>& given)
      : instance_(plugin, dim, given), dim_(dim) {
    plugin.kernel(instance_.self(), &about_);
  }
  [[nodiscard]] int dim() const { return dim_; }
  [[nodiscard]] const riffle_kernel& about() const { return about_; }

  // One output (a bit such as RIFFLE_W_L) at distance r with smoothing length l.
  [[nodiscard]] double operator()(std::uint32_t output, double r, double l = 1) const {
    std::array<double, RIFFLE_KERNEL_OUTPUTS> value{};
    std::array<double*, RIFFLE_KERNEL_OUTPUTS> out{};
    for (std::size_t b = 0; b < out.size(); ++b) out[b] = &value[b];
    const double inverse_l = 1 / l;
    instance_.table().evaluate_kernel(instance_.self(), 1, &r, &inverse_l, output, out.data());
    return value[static_cast<std::size_t>(std::lround(std::log2(output)))];
  }
  [[nodiscard]] const Instance& instance() const { return instance_; }

 private:
  Instance instance_;
  int dim_;
  riffle_kernel about_{sizeof(riffle_kernel), 0, 0, 0};
};

// Exact to round-off for the polynomials of degree < 30 that most kernels are made of, if [a, b] holds no joint.
template <class Function>
double integral(Function f, double a, double b) {
  return boost::math::quadrature::gauss<double, 15>::integrate(f, a, b);
}

}  // namespace riffle::contract
