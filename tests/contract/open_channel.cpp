// The algebra of steady flow and the backwater solver of the SDK, against tables computed independently and against the
// laws that they solve.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <riffle/steady_channel.hpp>

#include "tests/contract/csv.hpp"

namespace riffle::contract {
namespace {

constexpr double g = 9.81;
using open_channel::critical_depth, open_channel::depth_of_energy, open_channel::specific_energy;

TEST(OpenChannel, GivesBackTheDepthThatAnEnergyCameFrom) {
  for (const double q : {1e-6, 0.18, 4.8, 1e4}) {
    const double hc = critical_depth(q, g);
    for (const double ratio : {1e-3, 0.1, 0.5, 0.9, 1.1, 2.0, 10.0, 1e4}) {
      const double h = ratio * hc;
      // The root's condition is 1 / (1 - (hc/h)^3); at a tenth from critical it costs one digit.
      EXPECT_NEAR(depth_of_energy(specific_energy(h, q, g), q, g, ratio < 1) / h, 1, 1e-14) << q << " " << ratio;
    }
  }
}

TEST(OpenChannel, HasNoFlowBelowTheEnergyOfTheCriticalDepth) {
  const double hc = critical_depth(2, g);
  EXPECT_EQ(depth_of_energy(1.5 * hc, 2, g, false), hc);
  EXPECT_EQ(depth_of_energy(0.1 * hc, 2, g, true), hc);
  EXPECT_EQ(depth_of_energy(-1, 2, g, true), hc);
}

TEST(OpenChannel, KeepsMomentumBetweenConjugateDepths) {
  for (const double h : {0.01, 0.05, 0.2}) {
    const double q = 0.4, other = open_channel::conjugate_depth(h, q, g);
    EXPECT_NEAR(open_channel::momentum_function(other, q, g) / open_channel::momentum_function(h, q, g), 1, 1e-14);
    EXPECT_NEAR(open_channel::conjugate_depth(other, q, g) / h, 1, 1e-14);
  }
}

SteadyChannel::Data level(double discharge, double low, double high) {
  SteadyChannel::Data data;
  data.discharge = discharge;
  data.low = low;
  data.high = high;
  data.bed = [](double) { return 0.0; };
  data.width = [](double) { return 1.0; };
  return data;
}

struct Bump {
  std::string row;
  double discharge, depth_downstream;
};
void PrintTo(const Bump& bump, std::ostream* out) {
  *out << bump.row;
}
class SwashesBump : public testing::TestWithParam<Bump> {};

TEST_P(SwashesBump, IsTheSolutionTabulated) {
  const Bump& bump = GetParam();
  SteadyChannel::Data data = level(bump.discharge, 0, 25);
  data.depth_downstream = bump.depth_downstream;
  data.bed = [](double x) { return std::max(0.0, 0.2 - 0.05 * (x - 10) * (x - 10)); };
  const SteadyChannel channel(data);
  int compared = 0;
  for (const auto& row : rows("swashes_bumps.csv")) {
    const double x = std::stod(row[1]);
    if (row[0].rfind(bump.row, 0) != 0) continue;
    if (bump.row == "shock" && x > 11.3 && x < 11.65) continue;  // the table has its jump too early: see its head
    const auto state = channel.at(x);
    EXPECT_NEAR(state.depth, std::stod(row[3]), 5.1e-7) << "at " << x;  // half of the last digit printed
    EXPECT_NEAR(state.velocity, std::stod(row[4]), 5.1e-6) << "at " << x;
    ++compared;
  }
  EXPECT_EQ(compared, bump.row == "shock" ? 198 : 201);
}
INSTANTIATE_TEST_SUITE_P(Bumps, SwashesBump,
                         testing::Values(Bump{"subcritical", 4.42, 2}, Bump{"transcritical", 1.53, 0},
                                         Bump{"shock", 0.18, 0.33}),
                         [](const auto& info) { return info.param.row; });

// x = 11.665504281554291 m is the place that papers quote for this bump; it belongs to g = 9.812.
TEST(SteadyChannel, JumpsBehindABumpWhereTheLiteratureSays) {
  SteadyChannel::Data data = level(0.18, 0, 25);
  data.gravity = 9.812;
  data.depth_downstream = 0.33;
  data.bed = [](double x) { return std::max(0.0, 0.2 - 0.05 * (x - 10) * (x - 10)); };
  const SteadyChannel channel(data);
  ASSERT_EQ(channel.jumps().size(), 1u);
  EXPECT_NEAR(channel.jumps()[0], 11.665504281554291, 1e-10);
  ASSERT_EQ(channel.controls().size(), 1u);
  EXPECT_NEAR(channel.controls()[0], 10, 1e-6);
}

// Twenty jumps of a flume with friction: place and depths by an independent program (cases/hydraulic-jump/standard-step.csv
// says how), printed to 1 mm in x and 0.1 mm in depth. Its steps are of 1 mm in places, hence two units of its last digit.
TEST(SteadyChannel, JumpsWhereFrictionPutsTheJump) {
  const auto conditions = csv_rows(std::string(RIFFLE_CASES) + "/hydraulic-jump/conditions.csv");
  int compared = 0;
  for (const auto& row : csv_rows(std::string(RIFFLE_CASES) + "/hydraulic-jump/standard-step.csv")) {
    if (row[1] != "R=h") continue;
    for (const auto& ends : conditions) {
      if (ends[0].substr(0, 6) != row[0]) continue;
      SteadyChannel::Data data = level(std::stod(ends[2]) * std::stod(ends[3]), 0.305, 14);
      data.roughness = std::stod(row[2]);
      data.depth_upstream = std::stod(ends[3]);
      data.depth_downstream = std::stod(ends[4]);
      const SteadyChannel channel(data);
      ASSERT_EQ(channel.jumps().size(), 1u);
      const double x = channel.jumps()[0];
      EXPECT_NEAR(x, std::stod(row[3]), 2.1e-3) << row[0] << " n = " << row[2];
      EXPECT_NEAR(channel.at(x - 1e-9).depth, std::stod(row[4]), 1.1e-4);
      EXPECT_NEAR(channel.at(x + 1e-9).depth, std::stod(row[5]), 1.1e-4);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 20);
}

// The three regimes of flow over a hump of 0.2 m (Diwakar & Mohapatra 2023, table 3, "0.435" read as the velocity that
// belongs to q = 0.18 m2/s): figures of shallow-water theory to the digits given.
TEST(SteadyChannel, FlowsOverAHumpInThreeRegimes) {
  SteadyChannel::Data data = level(0.18, 0, 10);
  data.bed = [](double x) { return std::max(0.0, 0.2 * (1 - (x - 5) * (x - 5) / 4)); };
  const SteadyChannel transcritical(data);
  EXPECT_NEAR(transcritical.at(0).depth, 0.41374, 5e-6);
  EXPECT_NEAR(transcritical.at(0).velocity, 0.435, 1e-4);
  EXPECT_NEAR(transcritical.at(10).depth, 0.0682, 5e-5);
  data.depth_downstream = 0.33;
  const SteadyChannel shock(data);
  ASSERT_EQ(shock.jumps().size(), 1u);
  EXPECT_NEAR(shock.jumps()[0], 6.6656, 5e-5);
  EXPECT_NEAR(shock.at(shock.jumps()[0] - 1e-9).depth, 0.0760, 5e-5);
  EXPECT_NEAR(shock.at(shock.jumps()[0] + 1e-9).depth, 0.2593, 5e-5);
  data.discharge = 0.4;
  data.depth_downstream = 0;
  data.depth_upstream = 0.1;
  const SteadyChannel supercritical(data);  // passes the hump, although the choked state would have more momentum
  EXPECT_TRUE(supercritical.jumps().empty());
  EXPECT_TRUE(supercritical.at(5).supercritical);
  EXPECT_NEAR(supercritical.at(10).depth, 0.1, 1e-15);
}

TEST(SteadyChannel, ConservesHeadOverAStep) {  // level 3.273: Vacondio et al. (2013)
  SteadyChannel::Data data = level(4.8246, 0, 20);
  data.depth_downstream = 2.273;
  data.bed = [](double x) { return x < 10 ? 0.0 : 1.0; };
  const SteadyChannel channel(data);
  EXPECT_NEAR(channel.at(9.999).depth, 3.4, 5e-6);
  EXPECT_NEAR(channel.at(9.999).velocity, 1.419, 5e-5);
  EXPECT_EQ(channel.at(10.001).depth, channel.at(20).depth);
}

// A contraction from 1 m to 0.6 m, Q = 0.3 m3/s.
TEST(SteadyChannel, FlowsThroughAContraction) {
  SteadyChannel::Data data = level(0.3, 0, 10);
  data.width = [](double x) {
    return std::abs(x - 5) < 2 ? 1 - 0.2 * (1 + std::cos(std::acos(-1.0) * (x - 5) / 2)) : 1.0;
  };
  data.depth_downstream = 0.5867;
  const SteadyChannel subcritical(data);
  EXPECT_NEAR(subcritical.at(5).depth, 0.5593, 5e-5);
  data.depth_downstream = 0;
  const SteadyChannel transcritical(data);
  EXPECT_NEAR(transcritical.at(0).depth, 0.4147, 5.1e-5);
  EXPECT_NEAR(transcritical.at(5).depth, 0.2943, 5e-5);
  EXPECT_NEAR(transcritical.at(10).depth, 0.1193, 5e-5);
}

// S_f = S_0 in uniform flow, whatever marches: q = h^(5/3) sqrt(S_0) / n.
TEST(SteadyChannel, StaysUniformAtTheNormalDepth) {
  const double n = 0.02, slope = 1e-3, h = 0.8, q = std::pow(h, 5.0 / 3) * std::sqrt(slope) / n;
  SteadyChannel::Data data = level(q, 0, 100);
  data.roughness = n;
  data.depth_downstream = h;
  data.bed = [](double x) { return 1e-3 * (100 - x); };
  const SteadyChannel channel(data);
  for (const double x : {0.0, 3.3, 50.0, 100.0}) EXPECT_NEAR(channel.at(x).depth, h, 1e-12);
}

// The M1 curve has an invariant to converge to: halving the intervals divides the change by four (second order).
TEST(SteadyChannel, IsOfSecondOrderInTheIntervals) {
  SteadyChannel::Data data = level(1, 0, 200);
  data.roughness = 0.03;
  data.depth_downstream = 2;
  data.bed = [](double x) { return 2e-3 * (200 - x); };
  double depth[3];
  for (int k = 0; k < 3; ++k) {
    data.intervals = 25 << k;
    depth[k] = SteadyChannel(data).at(0).depth;
  }
  const double ratio = (depth[1] - depth[0]) / (depth[2] - depth[1]);
  EXPECT_GT(ratio, 3.3);
  EXPECT_LT(ratio, 4.7);
}

TEST(SteadyChannel, RefusesEndsThatCannotBe) {
  SteadyChannel::Data data = level(0.18, 0, 10);
  data.depth_downstream = 0.05;
  EXPECT_THROW(SteadyChannel{data}, std::invalid_argument);
  data.depth_downstream = 0;
  data.depth_upstream = 0.5;
  EXPECT_THROW(SteadyChannel{data}, std::invalid_argument);
  data.depth_upstream = 0.1;
  data.depth_downstream = 1;  // drowns the inlet
  EXPECT_THROW(SteadyChannel{data}, std::invalid_argument);
}

}  // namespace
}  // namespace riffle::contract
