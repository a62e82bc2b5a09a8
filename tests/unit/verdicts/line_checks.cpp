// Signs along a line of particles: who sees whom, who stands in pairs, who overtook whom.
#include "host/verdicts/line_checks.hpp"

#include <gtest/gtest.h>

namespace riffle {
namespace {

TEST(Overtakings, AreNoneWhenParticlesOnlyComeAndGo) {
  EXPECT_EQ(overtakings({1, 2, 3, 4}, {1, 2, 3, 4}), 0);
  EXPECT_EQ(overtakings({1, 2, 3, 4}, {9, 8, 1, 2, 3}), 0) << "two came in on the left, one left on the right";
  EXPECT_EQ(overtakings({1, 2, 3, 4}, {1, 3, 4}), 0) << "one vanished";
  EXPECT_EQ(overtakings({}, {1, 2}), 0);
}

TEST(Overtakings, CountParticlesThatFellBehind) {
  EXPECT_EQ(overtakings({1, 2, 3, 4}, {1, 3, 2, 4}), 1);
  EXPECT_EQ(overtakings({1, 2, 3, 4}, {1, 4, 2, 3}), 2) << "one passed two";
  EXPECT_EQ(overtakings({7, 3, 5}, {7, 9, 5, 3}), 1) << "ids need no order, and new ones do not count";
}

TEST(Overtakings, AreNotWhatAChannelClosedToARingDoes) {
  EXPECT_EQ(overtakings({1, 2, 3, 4}, {4, 1, 2, 3}), 0) << "one left at the end and came in at the beginning";
  EXPECT_EQ(overtakings({1, 2, 3, 4}, {3, 4, 1, 2}), 0);
  EXPECT_EQ(overtakings({1, 2, 3, 4}, {4, 2, 1, 3}), 1) << "the others must keep their order all the same";
}

TEST(LookAlong, FindsWaterThatSeesNobodyOnOneSideUnlessItIsTheEnd) {
  LineView line;
  line.x = {0, 1, 2, 5, 6};  // a gap from 2 to 5
  line.reach = {2, 2, 2, 2, 2};
  const LineLook look = look_along(line);
  EXPECT_EQ(look.one_sided, 2);
  EXPECT_EQ(look.one_sided_at, 2);
  line.others = {3.5};  // a wall in the gap is company for both
  EXPECT_EQ(look_along(line).one_sided, 0);
}

TEST(LookAlong, TakesBuffersAndImagesForNeighboursAtTheEnds) {
  LineView line;
  line.x = {0, 1, 2};
  line.reach = {1.5, 1.5, 1.5};
  line.others = {4, -1};  // the right one is out of sight
  EXPECT_EQ(look_along(line).one_sided, 1);
  EXPECT_EQ(look_along(line).one_sided_at, 2);
}

TEST(LookAlong, MeasuresHowManyStandInPairs) {
  LineView line;
  for (int k = 0; k < 100; ++k) line.x.push_back(k % 2 == 0 ? k : k - 0.4);  // gaps of 0.6 and 1.4
  line.reach.assign(100, 4);
  EXPECT_NEAR(look_along(line).paired, 0.97, 1e-12) << "all but those at the ends";
  for (int k = 0; k < 100; ++k)
    line.x[static_cast<std::size_t>(k)] = k * (1 + 0.01 * k);  // spaced more and more widely
  EXPECT_EQ(look_along(line).paired, 0);
}

TEST(LookAlong, MeasuresHowManyHardlyFeelTheirNeighbours) {
  LineView line;
  line.x = {0, 1, 2, 3.6, 5.2};
  line.reach.assign(5, 2);
  EXPECT_NEAR(look_along(line).stretched, 0.6, 1e-12) << "the last three: 1.6 is more than three quarters of 2";
  EXPECT_EQ(look_along(line).one_sided, 0);
}

TEST(LookAlong, BearsAnEmptyLine) {
  const LineLook look = look_along({});
  EXPECT_EQ(look.one_sided, 0);
  EXPECT_EQ(look.paired, 0);
}

}  // namespace
}  // namespace riffle
