// Pistons that make a solitary wave of 47.7 mm in water of 106 mm, the wave of Wu & Hsiao (2013).
#include "riffle/piston_law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "riffle/run_up.hpp"

namespace riffle::test::piston {
namespace {

constexpr double h0 = 0.106, height = 0.0477, g = 9.81;

PistonLaw law(PistonLaw::Kind kind) {
  return {kind, h0, height, g};
}
double largest_speed(const PistonLaw& piston) {
  double speed = 0;
  for (int k = 0; k <= 4000; ++k) speed = std::max(speed, piston.velocity(piston.duration() * k / 4000));
  return speed;
}

TEST(PistonLaw, OfTheSourceHasItsStrokeDurationAndSpeed) {
  const PistonLaw piston = law(PistonLaw::explicit_law);
  EXPECT_NEAR(piston.stroke(), 0.1642, 5e-5);  // digits worked out by hand from eqs 5.9 and 5.10
  EXPECT_NEAR(piston.wave_number(), 5.481, 5e-4);
  EXPECT_NEAR(piston.speed(), 1.2279, 5e-5);
  EXPECT_NEAR(piston.duration(), 1.2630, 5e-5);
  EXPECT_NEAR(largest_speed(piston), 0.494, 5e-4);
  EXPECT_NEAR(piston.stroke(), 4 * std::sqrt(height * h0 / 3), 1e-15);
  EXPECT_NEAR(piston.displacement(0.5 * piston.duration()), 0.5 * piston.stroke() * std::tanh(3.8), 1e-15);
}

TEST(PistonLaw, OfSerreAndGoringNeverRunsFasterThanTheWaterUnderTheCrest) {
  for (const PistonLaw::Kind kind : {PistonLaw::serre, PistonLaw::goring}) {
    const PistonLaw piston = law(kind);
    EXPECT_NEAR(largest_speed(piston), piston.speed() * height / (h0 + height), 1e-6);
    EXPECT_NEAR(largest_speed(piston), 0.381, 5e-4);
  }
  EXPECT_NEAR(law(PistonLaw::serre).wave_number(), 4.551, 5e-4);
  EXPECT_NEAR(law(PistonLaw::serre).stroke(), 0.1977, 5e-5);
}

TEST(PistonLaw, DisplacesTheVolumeOfTheWave) {
  for (const PistonLaw::Kind kind : {PistonLaw::serre, PistonLaw::goring, PistonLaw::explicit_law}) {
    const PistonLaw piston = law(kind);
    EXPECT_NEAR(piston.stroke() * h0, 2 * height / piston.wave_number(), 1e-15);
    EXPECT_NEAR(piston.displacement(100) / piston.stroke(), 1, 1e-3);  // what is cut off of the tail
    EXPECT_NEAR(piston.displacement(0), 0, 1e-12);
    EXPECT_NEAR(piston.displacement(piston.duration()), piston.stroke(), 2e-3 * piston.stroke());
  }
}

TEST(PistonLaw, MovesWithTheVelocityThatItSays) {
  for (const PistonLaw::Kind kind : {PistonLaw::serre, PistonLaw::goring, PistonLaw::explicit_law}) {
    const PistonLaw piston = law(kind);
    for (double t = 0.01; t < 1.8; t += 0.07) {
      const double dt = 1e-5, mean = (piston.displacement(t + dt) - piston.displacement(t - dt)) / (2 * dt);
      EXPECT_NEAR(mean, piston.velocity(t), 1e-8);
    }
  }
}

// The wave that leaves the piston: at the piston's own place, eta of the wave fits the speed, and the wave's phase is its own.
TEST(PistonLaw, OfSerreIsTheWaterOfTheSolitaryWaveWhereverThePistonIs) {
  const PistonLaw piston = law(PistonLaw::serre);
  const double k = piston.wave_number(), c = piston.speed(), middle = 0.5 * piston.duration();
  const double start = piston.displacement(middle);
  for (double t = 0.05; t < 1.7; t += 0.11) {
    const double phase = k * (c * (t - middle) - (piston.displacement(t) - start));
    const double eta = height / (std::cosh(phase) * std::cosh(phase));
    EXPECT_NEAR(piston.velocity(t), c * eta / (h0 + eta), 1e-12);
  }
}

TEST(PistonLaw, HoldsForSteepAndFlatWaves) {
  for (const double share : {1e-4, 0.1, 0.78}) {
    const PistonLaw piston(PistonLaw::serre, 2, 2 * share, g);
    EXPECT_NEAR(largest_speed(piston) / (piston.speed() * share / (1 + share)), 1, 1e-5);
  }
  EXPECT_THROW(PistonLaw(PistonLaw::serre, 0, 1, g), std::invalid_argument);
}

// 8 sqrt(pi sqrt 3) times the largest value of sum (-1)^(n+1) n^(3/2) x^n
TEST(RunUp, HasTheConstantOfItsSeries) {
  double largest = 0;
  for (double x = 0.4; x < 0.56; x += 1e-5) {
    double sum = 0, power = 1;
    for (int n = 1; n < 120; ++n) {
      power *= x;
      sum += (n % 2 == 1 ? 1 : -1) * n * std::sqrt(n) * power;
    }
    largest = std::max(largest, sum);
  }
  EXPECT_NEAR(8 * std::sqrt(3.14159265358979 * std::sqrt(3)) * largest, 2.8315, 5e-5);  // cut off at 2.831 in print
  EXPECT_NEAR(run_up::solitary_wave(0.019, 1, 19.85), 2.831 * std::sqrt(19.85) * std::pow(0.019, 1.25), 1e-15);
}

TEST(RunUp, KnowsWhereItHolds) {
  EXPECT_TRUE(run_up::is_valid(0.019, 1, 19.85));
  EXPECT_FALSE(run_up::is_valid(0.04, 1, 19.85)) << "breaks: the limit is 0.0296";
  EXPECT_NEAR(run_up::breaking_height(1, 19.85), 0.0296, 5e-5);
  EXPECT_FALSE(run_up::is_valid(0.005, 1, 2)) << "too steep a beach";
}

}  // namespace
}  // namespace riffle::test::piston
