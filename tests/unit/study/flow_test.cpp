#include "host/study/advise/flow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host/study/advise/dispersion.hpp"

namespace riffle {
namespace flow_test {

constexpr double g = 9.81;

// Depth of a dam break behind and in front of a bore at x = 0, smeared as a scheme does it.
FlowState bore(const FlowLine& line, double deep, double shallow, double time = 0) {
  FlowState state{time, {}, {}};
  for (const double x : line.x) {
    const double share = 0.5 - 0.5 * std::tanh(x / line.step());
    state.depth.push_back(shallow + (deep - shallow) * share);
    state.velocity.push_back(share);
  }
  return state;
}

TEST(AlongLine, IsLinearBetweenParticlesInAnyOrderAndEndsWhereTheyEnd) {
  const FlowLine line = flow_line(0, 10, 10);
  const auto values = along_line(line, {2.5, 0.5, 1.5, 3.5, 4.5}, {3, 1, 2, 4, 5});
  EXPECT_DOUBLE_EQ(values[0], 1);
  EXPECT_DOUBLE_EQ(values[3], 4);
  EXPECT_DOUBLE_EQ(values[9], 0);  // more than three distances from the last particle: dry ground
}

TEST(RelativeDifference, IsTheShareOfTheIntegralThatIsMisplaced) {
  const FlowLine line = flow_line(0, 4, 4);
  EXPECT_DOUBLE_EQ(relative_difference(line, {1, 1, 1, 2}, {1, 1, 1, 1}, 0, 4), 0.25);
  EXPECT_DOUBLE_EQ(relative_difference(line, {1, 1, 1, 2}, {1, 1, 1, 1}, 0, 3), 0);
}

TEST(Fronts, OfABoreHaveTheDepthsOnBothSides) {
  const FlowLine line = flow_line(-10, 10, 200);
  const auto fronts = fronts_of(line, bore(line, 0.8433, 0.7));
  ASSERT_EQ(fronts.size(), 1U);
  EXPECT_NEAR(fronts[0].deep, 0.8433, 1e-3);  // the tanh is within a thousandth of its end after four cells
  EXPECT_NEAR(fronts[0].shallow, 0.7, 1e-3);
}

TEST(Fronts, AreNoneWhereTheWaterParts) {
  const FlowLine line = flow_line(-10, 10, 200);
  FlowState state = bore(line, 1, 0.5);
  for (double& u : state.velocity) u = -u;
  EXPECT_TRUE(fronts_of(line, state).empty());
}

TEST(Fronts, AreNoneWhereOnlyTheBedJumps) {
  FlowLine line = flow_line(-10, 10, 200);
  FlowState state = bore(line, 1, 0.5);
  for (std::size_t k = 0; k < line.x.size(); ++k) line.bed[k] = 1 - state.depth[k];
  EXPECT_TRUE(fronts_of(line, state).empty());
}

// d2h/dt2 of a small hydrostatic wave is g h times the curvature of its level.
TEST(NonhydrostaticRatio, OfASmallWaveIsTwoThirdsOfItsSteepnessTimesWaveNumberTimesDepth) {
  const FlowLine line = flow_line(0, 200, 4000);
  const double h = 1, a = 1e-3, k = 2 * std::numbers::pi / 20;
  FlowState state{0, {}, {}};
  for (const double x : line.x) {
    state.depth.push_back(h + a * std::cos(k * x));
    state.velocity.push_back(a * std::sqrt(g / h) * std::cos(k * x));
  }
  const auto ratio = nonhydrostatic_ratio(line, state, {}, g);
  const std::size_t crest = 2000 - 1;  // x = 100 is five lengths from 0
  // averaging over a depth takes (k h)^2 / 24 off, and the squares of the wave are neglected
  EXPECT_NEAR(ratio[crest] / (2.0 / 3 * k * k * h * a), 1, 0.01);
}

Scout scout_with(const FlowLine& line, FlowState first, FlowState last) {
  Scout scout;
  scout.line = line;
  scout.end = last.time;
  scout.states = {std::move(first), std::move(last)};
  return scout;
}

FlowState still(const FlowLine& line, double depth) {
  return {0, std::vector<double>(line.x.size(), depth), std::vector<double>(line.x.size(), 0)};
}

TEST(Dispersion, OfAnUndularBoreGrowsWithTime) {
  const FlowLine line = flow_line(-50, 50, 1000);
  double before = 0;
  for (const double t : {2.0, 5.0, 15.0}) {
    const auto estimate = estimate_dispersion(scout_with(line, still(line, 0.8), bore(line, 0.8433, 0.7, t)), g, false);
    EXPECT_GT(estimate.fronts, before);
    EXPECT_FALSE(estimate.breaks);
    before = estimate.fronts;
  }
}

TEST(Dispersion, OfABoreThatBreaksHasNoTrainOfWaves) {
  const FlowLine line = flow_line(-50, 50, 1000);
  const auto early = estimate_dispersion(scout_with(line, still(line, 0.3), bore(line, 0.3966, 0.1, 2)), g, false);
  const auto late = estimate_dispersion(scout_with(line, still(line, 0.3), bore(line, 0.3966, 0.1, 16)), g, false);
  EXPECT_TRUE(late.breaks);
  EXPECT_NEAR(late.fronts / early.fronts, 2, 1e-6);  // the third root of eight
}

TEST(Dispersion, OfStillWaterIsNothing) {
  const FlowLine line = flow_line(-50, 50, 1000);
  FlowState last = still(line, 1);
  last.time = 10;
  const auto estimate = estimate_dispersion(scout_with(line, still(line, 1), last), g, true);
  EXPECT_EQ(estimate.total(), 0);
}

}  // namespace flow_test
}  // namespace riffle
