// The bed as a summation depth sees it, against what can be worked out by hand.
#include "host/terrain/smoothed_bed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/unit/terrain/made_up_bed.hpp"

namespace riffle::test {
namespace {

// The cubic spline in one dimension, support 2 l, and the part of it left of q.
double spline(double q) {
  q = std::abs(q);
  return q < 1 ? 2.0 / 3 - q * q + q * q * q / 2 : q < 2 ? (2 - q) * (2 - q) * (2 - q) / 6 : 0;
}
double share(double q) {
  if (q < 0) return 1 - share(-q);
  if (q >= 2) return 1;
  if (q >= 1) return 1 - std::pow(2 - q, 4) / 24;
  return 0.5 + 2 * q / 3 - q * q * q / 3 + q * q * q * q / 8;
}
void kernel(std::int64_t n, const double* r, const double* inverse_l, double* w) {
  for (std::int64_t k = 0; k < n; ++k) w[k] = spline(r[k] * inverse_l[k]) * inverse_l[k];
}

SmoothedBed smooth(const MadeUpBed& bed, double spacing = 1.0 / 64) {
  return {bed.terrain(), -10, 20, spacing, kernel, 2, 1};
}

TEST(SmoothedBed, OfAFlatBedIsThatBedWithoutSlope) {
  const MadeUpBed bed([](double) { return 1.25; });
  const SmoothedBed smoothed = smooth(bed);
  for (const double x : {-9.0, 0.3, 7.0, 25.0}) {
    EXPECT_EQ(smoothed.slope(x, 0.5), 0);
    EXPECT_DOUBLE_EQ(smoothed.level(x, 0.5), 1.25);
  }
}

TEST(SmoothedBed, OfAnInclinedBedIsThatBed) {
  const MadeUpBed bed([](double x) { return 0.5 - 0.02 * x; });
  const SmoothedBed smoothed = smooth(bed);
  for (const double x : {-5.0, 0.37, 11.123}) {
    EXPECT_NEAR(smoothed.slope(x, 0.5), -0.02, 1e-14);
    EXPECT_NEAR(smoothed.level(x, 0.5), 0.5 - 0.02 * x, 1e-12);  // the table of the kernel's share: 1e-12
  }
}

TEST(SmoothedBed, FeelsAStepAsFarAsTheKernelReaches) {
  constexpr double at = 5.0123456789, height = 0.8, l = 0.5;  // within a cell of the lattice
  const MadeUpBed bed([](double x) { return x < at ? 0.2 : 0.2 + height; });
  const SmoothedBed smoothed = smooth(bed);
  for (const double x : {3.9, 4.3, 4.9, 5.0, 5.2, 5.9, 6.1}) {
    EXPECT_NEAR(smoothed.slope(x, l), height * spline((x - at) / l) / l, 1e-13)
        << x;  // the place is found to the last bit
    EXPECT_NEAR(smoothed.level(x, l), 0.2 + height * share((x - at) / l), 1e-12) << x;
  }
}

TEST(SmoothedBed, OfAHumpConvergesWithTheLattice) {
  // second order in the lattice: where the hump begins, its slope has a jump, which the lattice meets within half a cell
  const auto hump = [](double x) { return std::abs(x) < 2 ? 0.2 - 0.05 * x * x : 0.0; };
  const MadeUpBed bed(hump);
  const double l = 0.5;
  const auto exact = [&](double x) {  // the integral of b' W by a fine midpoint rule: error far below 1e-9
    double sum = 0;
    constexpr int n = 400000;
    for (int k = 0; k < n; ++k) {
      const double u = x - 2 * l + 4 * l * (k + 0.5) / n;
      if (std::abs(u) < 2) sum += -0.1 * u * spline((x - u) / l) / l;
    }
    return sum * 4 * l / n;
  };
  double coarse = 0, fine = 0;
  for (const double x : {-2.4, -1.9, -1.3, 0.1, 1.2, 2.1, 2.6}) {
    const double answer = exact(x);
    coarse = std::max(coarse, std::abs(smooth(bed, 0.033).slope(x, l) - answer));
    fine = std::max(fine, std::abs(smooth(bed, 0.033 / 8).slope(x, l) - answer));
  }
  EXPECT_LT(fine, 2e-6);
  EXPECT_GT(coarse, 10 * fine);
}

TEST(SmoothedBed, HasTheCurvatureOfItsSlope) {
  const double l = 0.5;
  const MadeUpBed hill([](double x) { return 0.3 * std::exp(-x * x); });
  const SmoothedBed smoothed = smooth(hill, l / 16);
  constexpr double d = 1e-4;  // the difference's own error is below 1e-8
  for (const double x : {-2.1, -0.7, 0.0, 0.31, 1.6}) {
    const double difference = (smoothed.slope(x + d, l) - smoothed.slope(x - d, l)) / (2 * d);
    // rises stand in the middle of their cells, jumps of slope at the faces: second order in the lattice
    EXPECT_NEAR(smoothed.curvature(x, l), difference, 2e-4) << x;
  }
  const MadeUpBed bowl([](double x) { return 0.1 * x * x; });
  EXPECT_NEAR(smooth(bowl).curvature(1.37, l), 0.2, 1e-6);  // the lattice sum of the kernel
  const MadeUpBed ramp([](double x) { return 0.5 - 0.02 * x; });
  EXPECT_EQ(smooth(ramp).curvature(3.1, l), 0);
}

}  // namespace
}  // namespace riffle::test
