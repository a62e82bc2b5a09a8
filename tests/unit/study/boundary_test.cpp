#include "host/study/boundary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

namespace riffle {
namespace {

using Truth = std::function<int(int, int)>;

constexpr int n = 20;

TracedMap traced(const Truth& truth) {
  std::set<std::pair<int, int>> asked;
  const Classify classify = [&](const std::vector<GridPoint>& points) {
    std::vector<int> classes;
    for (const GridPoint& p : points) {
      EXPECT_TRUE(asked.insert({p.x, p.y}).second) << "asked twice for " << p.x << ", " << p.y;
      classes.push_back(truth(p.x, p.y));
    }
    return classes;
  };
  return trace_map(n, n, 4, classify);
}

// Points whose class is that of none of the eight around them in the full grid, nor their own: off by more than a cell.
int far_off(const TracedMap& map, const Truth& truth) {
  int count = 0;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      bool near = false;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          near = near || truth(std::clamp(x + dx, 0, n - 1), std::clamp(y + dy, 0, n - 1)) == map.at(x, y);
        }
      }
      if (!near) ++count;
    }
  }
  return count;
}

struct Region {
  const char* name;
  Truth truth;
};

class Boundary : public testing::TestWithParam<Region> {};

// A full grid takes 400 runs; a quarter of them must do, at the same boundary to one cell.
TEST_P(Boundary, IsFoundToOneCellWithAQuarterOfTheRuns) {
  const TracedMap map = traced(GetParam().truth);
  EXPECT_EQ(far_off(map, GetParam().truth), 0);
  EXPECT_LE(map.runs(), n * n / 4);
  RecordProperty("runs", map.runs());
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Boundary,
    testing::Values(Region{"line", [](int x, int y) { return int(y > 0.6 * x + 3.3); }},
                    Region{"hyperbola", [](int x, int y) { return int((x + 1) * (y + 1) > 60); }},
                    Region{"circle", [](int x, int y) { return int(std::hypot(x - 9.3, y - 10.1) < 6.3); }},
                    Region{"level", [](int, int y) { return int(y > 7); }},
                    Region{"upright", [](int x, int) { return int(x > 18); }},
                    Region{"wave", [](int x, int y) { return int(y > 10 + 5 * std::sin(x / 2.5)); }},
                    Region{"three", [](int x, int y) { return (x + 1) * (y + 1) > 150 ? 2 : int(y < 0.3 * x); }}),
    [](const auto& info) { return info.param.name; });

TEST(Trace, TakesAnEighthOfTheRunsForAStraightBoundary) {
  const TracedMap map = traced([](int x, int y) { return int(y > 7 + 0.1 * x); });
  EXPECT_LE(map.runs(), n * n / 8);
}

TEST(Trace, OfOneClassTriesTheCoarseGridOnly) {
  EXPECT_EQ(traced([](int, int) { return 3; }).runs(), 16);
}

TEST(Trace, NarrowsTheBoundaryToNeighboursThatWereTried) {
  const TracedMap map = traced([](int x, int) { return int(x > 10); });
  int steps = 0;
  for (int y = 0; y < n; ++y) steps += map.tried[map.index(10, y)] != 0 && map.tried[map.index(11, y)] != 0 ? 1 : 0;
  EXPECT_GE(steps, 7);  // on every third row and the last
}

TEST(Trace, TriesEveryPointWhereItSearchesAsManyAsThereAre) {
  const Classify classify = [](const std::vector<GridPoint>& points) { return std::vector<int>(points.size(), 1); };
  EXPECT_EQ(trace_map(6, 5, 6, classify).runs(), 30);
}

TEST(Trace, OfSmallGridsTriesEveryPointAtMostOnce) {
  for (const int size : {2, 3, 4, 5}) {
    int asked = 0;
    const Classify classify = [&](const std::vector<GridPoint>& points) {
      asked += static_cast<int>(points.size());
      std::vector<int> classes;
      for (const GridPoint& p : points) classes.push_back(p.x > p.y ? 1 : 0);
      return classes;
    };
    const TracedMap map = trace_map(size, size, 4, classify);
    EXPECT_EQ(asked, map.runs());
    EXPECT_EQ(map.at(size - 1, 0), 1);
    EXPECT_EQ(map.at(0, size - 1), 0);
  }
}

}  // namespace
}  // namespace riffle
