// The cubic spline with one mistake at a time.
#include <gtest/gtest.h>

#include <cmath>

#include "host/plugins/contracts.hpp"
#include "tests/unit/plugins/toy.hpp"

namespace riffle {
namespace {

using test::Toy;
using Lines = std::vector<std::string>;

struct Fault {
  double w = 1, f = 1, w_l = 1, w_rr = 1, w_rl = 1, w_ll = 1;  // factors
  double tail = 0;                                             // added beyond the support
  double spacing = 0;                                          // a length of its own, m: W is not l^-d w(r/l) any more
  double knot = 1;                                             // where the two pieces meet
  bool flips_slope = false;                                    // F > 0 in a part
  double support = 2;
};
Fault fault;
int dimension = 1;

// Two cubic pieces of support 2 that meet at `knot` with continuous w, w', w''; knot = 1 is the cubic spline.
double shape(double q, int derivative) {
  const double a = std::max(0.0, 2 - q), b = std::max(0.0, fault.knot - q), c = 4 / (fault.knot * fault.knot);
  // w = a^3/4 - c b^3/4 has w'(0) = 0 because 3/4 * 4 = 3/4 c knot^2.
  if (derivative == 0) return 0.25 * (a * a * a - c * b * b * b);
  if (derivative == 1) return -0.75 * (a * a - c * b * b);
  return 1.5 * (a - c * b);
}

// Its integral over space, term by term: of (s - q)+^3 in 1D s^4/2, 2D 2 pi s^5/20, 3D 4 pi s^6/60.
double norm(int dim) {
  const double s = fault.knot, c = 4 / (s * s);
  if (dim == 1) return 0.25 * (std::pow(2, 4) - c * std::pow(s, 4)) / 2;
  if (dim == 2) return 0.25 * 2 * M_PI * (std::pow(2, 5) - c * std::pow(s, 5)) / 20;
  return 0.25 * 4 * M_PI * (std::pow(2, 6) - c * std::pow(s, 6)) / 60;
}

std::int32_t evaluate(const void*, std::int64_t n, const double* r, const double* inverse_l, std::uint32_t want,
                      double* const* out) noexcept {
  const int d = dimension;
  for (std::int64_t k = 0; k < n; ++k) {
    const double l = 1 / inverse_l[k] + fault.spacing, q = r[k] / l, scale = std::pow(l, -d) / norm(d);
    const double w0 = shape(q, 0), w2 = shape(q, 2);
    double w1 = shape(q, 1);
    if (fault.flips_slope && q > 1.9) w1 = -w1;
    const double w1_over_q = q > 1e-12 ? w1 / q : w2;
    const double tail = q >= 2 ? fault.tail : 0;
    const double values[] = {fault.w * scale * w0 + tail,
                             fault.f * scale / (l * l) * w1_over_q,
                             -fault.w_l * scale / l * (d * w0 + q * w1),
                             fault.w_rr * scale / (l * l) * w2,
                             -fault.w_rl * scale / (l * l) * ((d + 1) * w1 + q * w2),
                             fault.w_ll * scale / (l * l) * (d * (d + 1) * w0 + 2 * (d + 1) * q * w1 + q * q * w2)};
    for (int b = 0; b < RIFFLE_KERNEL_OUTPUTS; ++b) {
      if ((want >> b & 1U) != 0) out[b][k] = values[b];
    }
  }
  return RIFFLE_OK;
}

Lines problems(const Fault& with, int dim) {
  fault = with;
  dimension = dim;
  Toy toy;
  toy.plugin.kind = "kernel";
  toy.passes = {nullptr};
  toy.votes = {nullptr};
  toy.plugin.kernel = [](const void*, riffle_kernel* out) noexcept {
    *out = {sizeof(riffle_kernel), (1U << RIFFLE_KERNEL_OUTPUTS) - 1, fault.support, 1};
  };
  toy.plugin.evaluate_kernel = &evaluate;
  const Plugin plugin = toy.read().front();
  Lines lines = contract_problems(PluginInstance(plugin, dim, default_values(plugin.description)));
  for (std::string& line : lines) line = line.substr(std::string("kernel \"toy\": ").size());
  return lines;
}

class KernelContract : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, KernelContract, testing::Values(1, 2, 3));

TEST_P(KernelContract, ACorrectKernelPasses) {
  EXPECT_EQ(problems({}, GetParam()), Lines{});
}

TEST_P(KernelContract, PiecesMayMeetAnywhere) {
  Fault odd;
  odd.knot = 0.7316;
  EXPECT_EQ(problems(odd, GetParam()), Lines{});
}

// A relative mistake of 1e-8 is far below anything that shows in a run, and a hundred times the tolerance.
TEST_P(KernelContract, AMistakeInTheEighthDigitIsFoundWhereItIs) {
  const auto first = [&](double Fault::*member) {
    Fault f;
    f.*member = 1 + 1e-8;
    const Lines lines = problems(f, GetParam());
    return lines.empty() ? std::string("nothing") : lines.front().substr(0, lines.front().find(':'));
  };
  EXPECT_EQ(first(&Fault::w).substr(0, 28), "its integral over space is 1");
  EXPECT_EQ(first(&Fault::f), "F does not fit W");
  EXPECT_EQ(first(&Fault::w_l), "dW/dl does not fit W");
  EXPECT_EQ(first(&Fault::w_rr), "d2W/dr2 does not fit W");
  EXPECT_EQ(first(&Fault::w_rl), "d2W/(dr dl) does not fit W");
  EXPECT_EQ(first(&Fault::w_ll), "d2W/dl2 does not fit W");
}

TEST(KernelMistake, WhatIsLeftBeyondTheSupportIsFound) {
  Fault f;
  f.tail = 1e-300;
  EXPECT_EQ(problems(f, 1), Lines{"W is 1e-300 at r = 2 l; from its support of 2 l on it must be exactly 0"});
}

TEST(KernelMistake, ASupportThatIsToldTooShortIsFound) {
  Fault f;
  f.support = 1.5;
  EXPECT_EQ(problems(f, 1), Lines{"W is 0.0417 at r = 1.5 l; from its support of 1.5 l on it must be exactly 0"});
}

TEST(KernelMistake, ALengthOfItsOwnIsFound) {
  Fault f;
  f.spacing = -0.01;
  const Lines lines = problems(f, 2);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines.front().substr(0, 42), "W is not of the form l^-d w(r / l): at r =");
}

TEST(KernelMistake, ASlopeThatRisesIsFound) {
  Fault f;
  f.flips_slope = true;
  const Lines lines = problems(f, 1);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines.front().substr(0, 33), "F = (dW/dr)/r is positive at r = ");
}

TEST(KernelMistake, AKernelThatIsNoNumberIsFound) {
  Fault f;
  f.w_rr = std::nan("");
  EXPECT_EQ(problems(f, 1), Lines{"d2W/dr2 is nan at r = 2 l; from its support of 2 l on it must be exactly 0"});
}

}  // namespace
}  // namespace riffle
