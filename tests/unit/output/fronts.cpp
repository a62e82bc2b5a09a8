#include "host/output/fronts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace riffle {
namespace fronts_test {

struct Profile {
  std::vector<double> x, h;
  template <class F>
  Profile(double low, double high, int n, F&& depth) {
    for (int k = 0; k < n; ++k) {
      x.push_back(low + (high - low) * (k + 0.5) / n);
      h.push_back(depth(x.back()));
    }
  }
};

// Depth 1 and 0.5, fan down to 0.73 between -30 m and -17 m, then level, front at 44 m over 2 m.
double bore(double s) {
  if (s < -30) return 1;
  if (s < -17) return 1 - 0.27 * (s + 30) / 13;
  if (s < 43) return 0.73;
  return s < 45 ? 0.73 - 0.23 * (s - 43) / 2 : 0.5;
}
double waves(double s) {  // grow from 0 to 43 m, crest at 40 m, front from 42 m on
  const auto wave = [](double at) { return 0.73 + 0.2 * (at / 43) * std::cos(2 * M_PI * (at - 40) / 8); };
  return s < 0 ? bore(s) : s < 42 ? wave(s) : s < 45 ? wave(42) - (wave(42) - 0.5) * (s - 42) / 3 : 0.5;
}

TEST(Fronts, AStepIsFoundWhereItIs) {
  const auto jump = depth_step([](double x) { return x < 100 ? 10.0 : 5.0; }, 0, 200);
  ASSERT_TRUE(jump);
  EXPECT_DOUBLE_EQ(jump->place, 100);
  EXPECT_EQ(jump->left, 10);
  EXPECT_EQ(jump->right, 5);
  const auto smooth = depth_step([](double x) { return 0.75 + 0.25 * std::tanh((x - 60) / 0.5); }, 0, 200);
  ASSERT_TRUE(smooth);
  EXPECT_NEAR(smooth->place, 60, 1e-6);  // to the fourth root of rounding and better: tanh is steep there
  EXPECT_TRUE(depth_step([](double x) { return x < 3 ? 1.0 : 0.0; }, 0, 10));
}

TEST(Fronts, OtherInitialStatesAreNoStep) {
  EXPECT_FALSE(depth_step([](double) { return 1.0; }, 0, 10));
  EXPECT_FALSE(depth_step([](double x) { return 1 + 0.1 * x; }, 0, 10));
  EXPECT_FALSE(depth_step([](double x) { return x < 4 ? 1.0 : x < 6 ? 0.1 : 0.5; }, 0, 10));
  EXPECT_FALSE(depth_step([](double x) { return 1 + std::exp(-(x - 5) * (x - 5)); }, 0, 10));
}

TEST(Fronts, OfABoreAreItsToeAndItsMiddle) {
  const Profile water(-100, 100, 4000, bore);
  const Fronts found = fronts({0, 1, 0.5}, water.x, water.h);
  EXPECT_NEAR(*found.plateau, 0.73, 1e-12);
  EXPECT_NEAR(*found.mid, 44, 1e-9);  // linear between particles, as the profile is
  EXPECT_NEAR(*found.toe, 45 - 2 * 0.005 / 0.23, 1e-9);
  EXPECT_FALSE(found.crest);
}

TEST(Fronts, TowardsTheLeftAreTheSame) {
  const Profile right(-100, 100, 4000, bore), left(-100, 100, 4000, [](double x) { return bore(-x + 10); });
  const Fronts a = fronts({0, 1, 0.5}, right.x, right.h), b = fronts({10, 0.5, 1}, left.x, left.h);
  EXPECT_NEAR(*a.toe, *b.toe, 0.05);
  EXPECT_NEAR(*a.mid, *b.mid, 0.05);
}

TEST(Fronts, OfATrainOfWavesHaveACrest) {
  const Profile water(-100, 100, 4000, waves);
  const Fronts found = fronts({0, 1, 0.5}, water.x, water.h);
  EXPECT_NEAR(*found.plateau, 0.73, 1e-12);  // where there are no waves
  ASSERT_TRUE(found.crest);
  EXPECT_NEAR(*found.crest, 40, 0.2);  // the amplitude grows along the way, which moves the maximum a little
  EXPECT_NEAR(*found.crest_depth, 0.73 + 0.2 * 40 / 43, 1e-3);
}

TEST(Fronts, DoNotMindAWaveAtTheEndOfTheChannel) {
  const Profile water(-100, 100, 4000, [](double s) { return s > 95 ? 0.53 : bore(s); });
  const Fronts found = fronts({0, 1, 0.5}, water.x, water.h);
  EXPECT_NEAR(*found.toe, 45 - 2 * 0.005 / 0.23, 1e-9);
}

TEST(Fronts, OnADryBedHaveAToeAndNoPlateau) {  // Ritter: h = (2 - s)^2 / 9 between -1 and 2
  const Profile water(-3, 2, 4000, [](double s) { return s < -1 ? 1 : (2 - s) * (2 - s) / 9; });
  const Fronts found = fronts({0, 1, 0}, water.x, water.h);
  EXPECT_NEAR(*found.toe, 2 - 3 * std::sqrt(0.01), 1e-3);
  EXPECT_FALSE(found.plateau);
  EXPECT_FALSE(found.mid);
}

}  // namespace fronts_test
}  // namespace riffle
