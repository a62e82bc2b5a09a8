#include "host/study/analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace riffle {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

TEST(ConvergenceOrder, OfAnErrorThatFallsWithTheSquareOfTheSpacingIsTwo) {
  const std::array<double, 3> spacing{0.4, 0.2, 0.1}, error{0.16, 0.04, 0.01};
  EXPECT_NEAR(convergence_order(spacing, error), 2, 1e-12);  // round-off of logarithms
}

TEST(ConvergenceOrder, LeavesOutWhatIsNotANumber) {
  const std::array<double, 3> spacing{0.4, 0.2, 0.1}, error{0.4, nothing, 0.1};
  EXPECT_NEAR(convergence_order(spacing, error), 1, 1e-12);
}

TEST(ConvergenceOrder, NeedsTwoSpacings) {
  const std::array<double, 2> same{0.2, 0.2}, error{0.4, 0.1};
  EXPECT_TRUE(std::isnan(convergence_order(same, error)));
  EXPECT_TRUE(std::isnan(convergence_order(std::span(same).first(1), error)));
}

TEST(ParetoFront, HoldsWhatNothingBeatsFromTheCheapestOn) {
  const std::array<ErrorCost, 6> points{{{0.1, 1}, {0.2, 2}, {0.05, 4}, {0.3, 0.5}, {0.05, 5}, {nothing, 0.1}}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{3, 0, 2}));
}

TEST(ParetoFront, OfEqualPointsTakesTheFirst) {
  const std::array<ErrorCost, 2> points{{{0.1, 1}, {0.1, 1}}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{0}));
}

// error = 1 / cost, so that logarithms are straight
constexpr std::array<ErrorCost, 3> hyperbola{{{1, 1}, {0.1, 10}, {0.01, 100}}};

TEST(CostAtError, IsInterpolatedOnLogarithms) {
  EXPECT_NEAR(cost_at_error(hyperbola, 0.02).value(), 50, 1e-9);
  EXPECT_NEAR(error_at_cost(hyperbola, 50).value(), 0.02, 1e-12);
}

TEST(CostAtError, AtAPointIsThatPoint) {
  EXPECT_EQ(cost_at_error(hyperbola, 0.1), 10);
  EXPECT_EQ(error_at_cost(hyperbola, 100), 0.01);
}

TEST(CostAtError, IsNotExtrapolated) {
  EXPECT_FALSE(cost_at_error(hyperbola, 0.009).has_value());
  EXPECT_FALSE(cost_at_error(hyperbola, 1.1).has_value());
  EXPECT_FALSE(error_at_cost(hyperbola, 101).has_value());
}

TEST(CostAtError, OfALineThatGoesUpAndDownIsTheLeast) {
  const std::array<ErrorCost, 4> line{{{0.5, 1}, {0.05, 2}, {0.2, 4}, {0.01, 8}}};
  EXPECT_LT(cost_at_error(line, 0.1).value(), 2);
}

}  // namespace
}  // namespace riffle
