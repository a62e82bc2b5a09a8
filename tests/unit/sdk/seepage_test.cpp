// Seepage: closed form, limits of one term alone, and columns of two materials.
#include "riffle/seepage.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace riffle::test::seepage {
namespace {

constexpr double g = 9.81, nu = 1e-6;

HydraulicGradient rock(double porosity = 0.49, double diameter = 0.0159) {
  return {porous_drag::ergun(porosity, diameter, nu), porosity, g};
}

TEST(HydraulicGradient, IsErgunsLaw) {
  EXPECT_NEAR(rock().linear, 0.13371, 5e-6);  // digits tabulated
  EXPECT_NEAR(rock().quadratic, 48.636, 5e-4);
  EXPECT_NEAR(rock().filter_velocity(0.1), 0.04399, 5e-6);
  EXPECT_NEAR(rock()(rock().filter_velocity(0.37)), 0.37, 1e-15);
  EXPECT_NEAR(rock()(rock().filter_velocity(-0.37)), -0.37, 1e-15);
}

// Velocities that a particle method gave in periodic boxes within 0.1 %, i the driving slope.
TEST(HydraulicGradient, HasTheVelocitiesInRockAndBeads) {
  EXPECT_NEAR(rock().filter_velocity(0.1) / 0.49, 0.08978, 5e-6);
  EXPECT_NEAR(rock().filter_velocity(1) / 0.49, 0.28984, 5e-6);
  EXPECT_NEAR(rock(0.39, 0.003).filter_velocity(0.1) / 0.39, 0.01734, 5e-6);
  HydraulicGradient half = rock();  // the other half of the way is free water
  half.linear /= 2;
  half.quadratic /= 2;
  EXPECT_NEAR(half.filter_velocity(0.1) / (0.5 * (1 + 0.49)), 0.08425, 5e-6);
}

TEST(BlockSeepage, IsTheClosedForm) {
  for (const double quadratic : {0.3, 48.636, 600.0}) {
    HydraulicGradient law = rock();
    law.quadratic = quadratic;
    const BlockSeepage block(law, 0.29, 0.14, 0.06);
    const double q = block.discharge(), e = law.quadratic * q / law.linear;
    const auto integral = [&](double h) { return h * h / 2 - e * h + e * e * std::log(h + e); };
    EXPECT_NEAR((integral(0.14) - integral(0.06)) / (law.linear * q), 0.29, 1e-9);  // the closed form cancels
    for (const double x : {0.05, 0.15, 0.25}) {
      EXPECT_NEAR((integral(0.14) - integral(block.depth(x))) / (law.linear * q), x, 1e-9);
    }
    EXPECT_EQ(block.depth(-1), 0.14);
    EXPECT_EQ(block.depth(1), 0.06);
  }
}

TEST(BlockSeepage, IsDupuitsParabolaWithoutFormDrag) {
  HydraulicGradient law = rock();
  law.quadratic = 0;
  const BlockSeepage block(law, 2, 1, 0.5);
  EXPECT_NEAR(block.discharge(), (1 - 0.25) / (2 * law.linear * 2), 1e-14);
  EXPECT_NEAR(block.depth(1), std::sqrt(1 - 0.75 / 2), 1e-12);
}

TEST(BlockSeepage, IsACubicWithoutViscousDrag) {
  HydraulicGradient law = rock();
  law.linear = 0;
  const BlockSeepage block(law, 2, 1, 0.5);
  EXPECT_NEAR(block.discharge(), std::sqrt((1 - 0.125) / (3 * law.quadratic * 2)), 1e-13);
  EXPECT_NEAR(block.depth(1), std::cbrt(1 - 0.875 / 2), 1e-12);
}

TEST(BlockSeepage, NeedsAFall) {
  EXPECT_THROW(BlockSeepage(rock(), 0.29, 0.1, 0.1), std::invalid_argument);
  EXPECT_THROW(BlockSeepage(rock(), 0.29, 0.1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace riffle::test::seepage
