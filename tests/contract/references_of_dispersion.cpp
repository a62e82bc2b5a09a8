// Linear waves and undular bores against their own laws and against an independently computed table.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/contract/csv.hpp"
#include "tests/contract/reference_case.hpp"

namespace riffle::contract {
namespace references_of_dispersion {

constexpr double g = 9.81;

ReferenceCase wave(double length, double theory, double direction = 0) {
  return ReferenceCase("linear-dispersion", {{"depth", 2},
                                             {"relative_amplitude", 5e-4},
                                             {"wave_length", length},
                                             {"position", 3},
                                             {"direction", direction},
                                             {"theory", theory}});
}

// d/dt of the depth is minus d/dx of h0 u, by central differences of second order.
TEST(LinearDispersion, KeepsTheWaterThatItMoves) {
  for (const double direction : {0.0, 1.0, 2.0}) {
    const ReferenceCase sine = wave(7, 0, direction);
    const double e = 1e-4;
    for (double x = 0; x < 7; x += 0.3) {
      const double rise = (sine.at(x, 1.3 + e).depth - sine.at(x, 1.3 - e).depth) / (2 * e);
      const double inflow = -2 * (sine.at(x + e, 1.3).velocity - sine.at(x - e, 1.3).velocity) / (2 * e);
      EXPECT_NEAR(rise, inflow, 1e-10) << direction << " " << x;
    }
  }
}

TEST(LinearDispersion, RunsWithThePhaseSpeedOfItsTheory) {
  const double length = 11, kh = 2 * M_PI / length * 2, shallow = std::sqrt(g * 2);
  const double speed[] = {shallow / std::sqrt(1 + kh * kh / 3), std::sqrt(g * length / (2 * M_PI) * std::tanh(kh)),
                          shallow, shallow * std::sqrt(1 - kh * kh / 3)};
  for (int theory = 0; theory < 4; ++theory) {
    const ReferenceCase sine = wave(length, theory);
    EXPECT_NEAR(sine.at(3 + speed[theory] * 5, 5).depth, 2.001, 1e-14) << theory;  // the crest
    EXPECT_NEAR(sine.at(3 + length / 4 + speed[theory] * 5, 5).depth, 2, 1e-14);
    EXPECT_NEAR(sine.at(3 + speed[theory] * 5, 5).velocity, 1e-3 * speed[theory] / 2, 1e-15);
  }
  EXPECT_EQ(wave(length, 0).at(5, 0).depth_scale, 1e-3);
}

TEST(LinearDispersion, RefusesWhereItsTheoryHasNoWaves) {
  try {
    wave(2 * M_PI * 2 / 1.8, 3);
    FAIL() << "a growing wave was accepted";
  } catch (const Refused& refused) {
    EXPECT_STREQ(refused.what(), "the split has no waves of k h0 above sqrt 3 = 1.732, they grow; k h0 is 1.8 here");
  }
}

ReferenceCase bore(double left, double right, double margin = 0) {
  return ReferenceCase("undular-bore",
                       {{"dam_position", 4}, {"depth_left", left}, {"depth_right", right}, {"margin", margin}});
}

// Where the reference begins and ceases to be defined at t = 1, by bisection between a defined and an undefined place.
double edge(const ReferenceCase& reference, double defined, double undefined) {
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (defined + undefined);
    (reference.at(middle, 1).defined ? defined : undefined) = middle;
  }
  return defined;
}

TEST(UndularBore, HasTheEdgesOfTheTableOfModulationTheory) {
  int compared = 0;
  for (const auto& row : rows("serre_undular_bore_theory.csv")) {
    const double jump = std::stod(row[0]), leading = std::stod(row[1]), trailing = std::stod(row[6]);
    if (jump > 1.43) continue;
    const double deep = std::pow(2 * std::sqrt(jump) - 1, 2), unit = std::sqrt(g);
    const ReferenceCase reference = bore(deep, 1);
    const double inside = 4 + 0.5 * unit * (leading + trailing);
    EXPECT_NEAR((edge(reference, 1e3, inside) - 4) / unit, leading, 1e-6);  // printed with six digits
    EXPECT_NEAR((edge(reference, 4 + unit * (trailing - 0.5), inside) - 4) / unit, trailing, 6e-6);
    EXPECT_NEAR(reference.at(4 + unit * (trailing - 0.1), 1).depth, jump, 1e-13);
    ++compared;
  }
  EXPECT_GE(compared, 10);
}

TEST(UndularBore, IsASimpleWaveBehindAndStillWaterAhead) {
  const ReferenceCase reference = bore(1, 0.7), mirrored = bore(0.7, 1);
  for (double x = -40; x < 40; x += 0.7) {
    const WaterState s = reference.at(4 + x, 3), other = mirrored.at(4 - x, 3);
    EXPECT_EQ(s.defined, other.defined);
    EXPECT_NEAR(s.depth, other.depth, 1e-14);  // 4 + x and 4 - x round differently
    EXPECT_NEAR(s.velocity, -other.velocity, 1e-14);
    if (!s.defined) continue;
    const double invariant = x < 7 ? s.velocity + 2 * std::sqrt(g * s.depth) - 2 * std::sqrt(g) : s.velocity;
    EXPECT_NEAR(invariant, 0, 1e-14 * 2 * std::sqrt(g));
  }
  EXPECT_FALSE(bore(1, 0.7, 10).at(4 + 6.9, 0).defined);
  EXPECT_TRUE(bore(1, 0.7, 10).at(4 + 7.1, 0).defined);
}

TEST(UndularBore, IsRefusedBeyondItsRange) {
  try {
    bore(1, 0.5);
    FAIL() << "a bore beyond the range was accepted";
  } catch (const Refused& refused) {
    EXPECT_NE(std::string(refused.what()).find("1.45711"), std::string::npos) << refused.what();
    EXPECT_NE(std::string(refused.what()).find("up to 1.43"), std::string::npos) << refused.what();
  }
  const ReferenceCase allowed("undular-bore",
                              {{"dam_position", 0}, {"depth_left", 1}, {"depth_right", 0.5}, {"beyond_range", 1}});
  EXPECT_TRUE(allowed.at(-10, 1).defined);
}

}  // namespace references_of_dispersion
}  // namespace riffle::contract
