// The jump of Belanger against the four that Gharangik & Chaudhry (1991) measured.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/contract/csv.hpp"
#include "tests/contract/reference_case.hpp"

namespace riffle::contract {
namespace {

TEST(HydraulicJump, HasTheConjugateDepthsTabulated) {
  const auto table = csv_rows(std::string(RIFFLE_CASES) + "/hydraulic-jump/conditions.csv");
  ASSERT_EQ(table.size(), 4u);
  for (const auto& row : table) {
    const double u = std::stod(row[2]), h = std::stod(row[3]);
    const ReferenceCase jump("hydraulic-jump", {{"discharge", u * h}, {"depth_upstream", h}, {"jump_position", 7}});
    EXPECT_EQ(jump.at(6.99, 0).depth, h);
    EXPECT_DOUBLE_EQ(jump.at(6.99, 30).velocity, u);
    EXPECT_NEAR(jump.at(7.01, 30).depth, std::stod(row[8]), 5.1e-5);  // half of the last digit printed
    EXPECT_DOUBLE_EQ(jump.at(7.01, 0).velocity * jump.at(7.01, 0).depth, u * h);
    EXPECT_DOUBLE_EQ(jump.at(7.01, 0).velocity_scale, std::sqrt(9.81 * jump.at(7.01, 0).depth));
  }
}

TEST(HydraulicJump, NeedsSupercriticalWater) {
  try {
    const ReferenceCase jump("hydraulic-jump", {{"discharge", 0.2}, {"depth_upstream", 0.5}, {"jump_position", 7}});
    FAIL() << "a subcritical depth was accepted";
  } catch (const Refused& refused) {
    EXPECT_STREQ(refused.what(),
                 "depth_upstream is 0.5 m, but only supercritical flow can jump: it must be below the critical depth "
                 "0.159758 m");
  }
}

TEST(Table, ComparesWhatItIsGiven) {
  const ReferenceCase both("table", {{"depth", 0}, {"velocity", 0}});
  EXPECT_FALSE(both.at(1, 0).defined) << "no depth, no comparison";
  EXPECT_FALSE(ReferenceCase("table", {}).at(1, 0).defined);
  const WaterState speed = ReferenceCase("table", {{"velocity", 0}}).at(1, 0);
  EXPECT_TRUE(speed.defined);
  EXPECT_EQ(speed.depth_scale, 0) << "a scale of 0 keeps a field out of the norms";
}

}  // namespace
}  // namespace riffle::contract
