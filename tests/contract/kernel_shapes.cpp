// Each kernel against its closed form, written down a second time as its source prints it.
#include <gtest/gtest.h>

#include <functional>

#include "tests/contract/kernel_case.hpp"

namespace riffle::contract {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double round_off = 1e-14;  // a handful of operations on numbers of order one

void expect_shape(const std::string& id, int dim, const std::function<double(double)>& expected) {
  const KernelCase kernel(plugin("kernel", id), dim, {{"lattice_normalised", 0}});
  for (double q = 0; q < 3.2; q += 0.0625)
    EXPECT_NEAR(kernel(RIFFLE_W, q), expected(q), round_off) << id << " at " << q;
}

TEST(CubicSpline, IsThePapersEquation6TimesTheNormalisationThatIsMissingThere) {
  const auto printed = [](double q) {
    return q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : q < 2 ? 0.25 * std::pow(2 - q, 3) : 0;
  };
  expect_shape("cubic-spline", 1, [&](double q) { return 2.0 / 3 * printed(q); });
  expect_shape("cubic-spline", 2, [&](double q) { return 10 / (7 * pi) * printed(q); });
  expect_shape("cubic-spline", 3, [&](double q) { return printed(q) / pi; });
}

TEST(QuinticSpline, IsTheSumOfThreeFifthPowers) {
  const auto power = [](double a) { return a > 0 ? std::pow(a, 5) : 0; };
  const auto w = [&](double q) { return power(3 - q) - 6 * power(2 - q) + 15 * power(1 - q); };
  expect_shape("quintic-spline", 1, [&](double q) { return w(q) / 120; });
  expect_shape("quintic-spline", 2, [&](double q) { return 7 / (478 * pi) * w(q); });
  expect_shape("quintic-spline", 3, [&](double q) { return w(q) / (120 * pi); });
}

// Dehnen & Aly (2012) table 1 gives these on the unit interval, with s = q / 2 and sigma for support 1.
TEST(Wendland, HasTheFunctionsOfDehnenAndAlyInOneAndInMoreDimensions) {
  const auto on_support = [](double sigma, int dim, const std::function<double(double)>& w) {
    return [=](double q) { return q < 2 ? sigma / std::pow(2, dim) * w(q / 2) : 0; };
  };
  const auto c2_line = [](double s) { return std::pow(1 - s, 3) * (1 + 3 * s); };
  const auto c2 = [](double s) { return std::pow(1 - s, 4) * (1 + 4 * s); };
  const auto c4_line = [](double s) { return std::pow(1 - s, 5) * (1 + 5 * s + 8 * s * s); };
  const auto c4 = [](double s) { return std::pow(1 - s, 6) * (1 + 6 * s + 35.0 / 3 * s * s); };
  expect_shape("wendland-c2", 1, on_support(5.0 / 4, 1, c2_line));
  expect_shape("wendland-c2", 2, on_support(7 / pi, 2, c2));
  expect_shape("wendland-c2", 3, on_support(21 / (2 * pi), 3, c2));
  expect_shape("wendland-c4", 1, on_support(3.0 / 2, 1, c4_line));
  expect_shape("wendland-c4", 2, on_support(9 / pi, 2, c4));
  expect_shape("wendland-c4", 3, on_support(495 / (32 * pi), 3, c4));
}

TEST(Gaussian, IsAGaussianLessItsContactParabolaAtTheCut) {
  const KernelCase kernel(plugin("kernel", "gaussian"), 1, {{"lattice_normalised", 0}});
  const double scale = kernel(RIFFLE_W, 0) / (1 - 50.5 * std::exp(-9.0));
  for (double q = 0; q < 3; q += 0.0625) {
    const double u = 9 - q * q, expected = std::exp(-q * q) - std::exp(-9.0) * (1 + u + u * u / 2);
    EXPECT_NEAR(kernel(RIFFLE_W, q), scale * expected, round_off) << q;
  }
  // The parabola takes 50.5 e^-9 = 0.6 % of the peak, and the normalisation gives 1.2 % back.
  EXPECT_NEAR(kernel(RIFFLE_W, 0), 1 / std::sqrt(pi), 0.007 / std::sqrt(pi));
  for (const std::uint32_t output : {RIFFLE_W, RIFFLE_F, RIFFLE_W_RR}) EXPECT_NEAR(kernel(output, 3 - 1e-9), 0, 1e-10);
}

// The sum of B-splines whose joints lie on the lattice is one without any help.
TEST(LatticeNormalisation, ChangesNothingInSplinesOnTheirOwnLattice) {
  for (const char* id : {"cubic-spline", "quintic-spline"}) {
    for (const double ratio : {1.0, 2.0, 3.0}) {
      const KernelCase kernel(plugin("kernel", id), 1, {{"lattice_normalised", 1}, {"smoothing_ratio", ratio}});
      EXPECT_NEAR(kernel.about().integral, 1, round_off) << id;
    }
  }
}

// 0.35 % is the sum of the cubic spline at 1.3 spacings, from the formula by hand: the depth of still water without it.
TEST(LatticeNormalisation, RemovesTheBiasOfDepthOfTheCubicSpline) {
  const auto w = [](double q) { return q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : 0.25 * std::pow(2 - q, 3); };
  const double sum = 2.0 / 3 * (1 + 2 * (w(1 / 1.3) + w(2 / 1.3))) / 1.3;
  const KernelCase kernel(plugin("kernel", "cubic-spline"), 1, {{"lattice_normalised", 1}, {"smoothing_ratio", 1.3}});
  EXPECT_NEAR(sum, 1.0035, 5e-5);
  EXPECT_NEAR(kernel.about().integral, 1 / sum, round_off);
}

}  // namespace
}  // namespace riffle::contract
