// Polygons in the vertical plane, beside sums over many points.
#include "riffle/polygon.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace riffle::test::polygon {
namespace {

bool all(std::size_t) {
  return true;
}
const Polygon block({{0.3, 0}, {0.59, 0}, {0.59, 0.37}, {0.3, 0.37}});
const Polygon arrow({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}});  // with a notch

TEST(Polygon, KnowsInsideAndDistanceOfABlock) {
  EXPECT_TRUE(block.contains({0.4, 0.1}));
  EXPECT_FALSE(block.contains({0.2, 0.1}));
  EXPECT_FALSE(block.contains({0.4, 0.38}));
  EXPECT_NEAR(block.distance({0.31, 0.2}, all), 0.01, 1e-15);
  EXPECT_NEAR(block.distance({0.2, -0.1}, all), std::hypot(0.1, 0.1), 1e-15) << "from a corner";
  EXPECT_NEAR(block.area(), 0.29 * 0.37, 1e-15);
  EXPECT_TRUE(std::isinf(block.distance({0.4, 0.1}, [](std::size_t) { return false; })));
}

TEST(Polygon, CountsThePointsOfItsAreaWhicheverWayItTurns) {
  const Polygon turned({{0, 2}, {1, 0.5}, {2, 2}, {2, 0}, {0, 0}});
  int inside = 0;
  constexpr int n = 500;
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) {
      const PlanePoint p{-1 + 4 * (i + 0.37) / n, -1 + 4 * (k + 0.61) / n};
      EXPECT_EQ(arrow.contains(p), turned.contains(p));
      inside += arrow.contains(p) ? 1 : 0;
    }
  }
  EXPECT_NEAR(inside * 16.0 / (n * n), arrow.area(), 0.01);
  EXPECT_FALSE(arrow.contains({1, 1})) << "in the notch";
}

TEST(Polygon, IsBeyondOnlyWhereItsDistanceIs) {
  for (double x = -1; x < 3; x += 0.13) {
    for (double z = -1; z < 3; z += 0.17) {
      const PlanePoint p{x, z};
      if (arrow.beyond(p, 0.4)) {
        EXPECT_GT(arrow.distance(p, all), 0.4);
        EXPECT_FALSE(arrow.contains(p));
      }
    }
  }
  EXPECT_TRUE(arrow.beyond({2.5, 1}, 0.4));
}

TEST(Polygon, SeesWhatCrossesItselfAndWhatOverlaps) {
  EXPECT_TRUE(Polygon({{0, 0}, {1, 1}, {1, 0}, {0, 1}}).crosses_itself());
  EXPECT_FALSE(arrow.crosses_itself());
  EXPECT_TRUE(block.overlaps(Polygon({{0.5, 0.1}, {0.7, 0.1}, {0.7, 0.2}, {0.5, 0.2}})));
  EXPECT_FALSE(block.overlaps(Polygon({{0.59, 0}, {0.7, 0}, {0.7, 0.2}, {0.59, 0.2}}))) << "they share an edge";
  EXPECT_TRUE(block.overlaps(Polygon({{0.2, -1}, {1, -1}, {1, 1}, {0.2, 1}}))) << "it lies inside";
}

}  // namespace
}  // namespace riffle::test::polygon
