#include "host/bench/timing.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "host/bench/boundary.hpp"

namespace riffle::bench {

namespace {

void work(int amount) {
  volatile double x = 1;
  for (int k = 0; k < amount * 100000; ++k) x = x * 1.0000001;
}

TEST(TimeInterleaved, MeasuresWorkAndNotWaiting) {
  const std::vector<double> seconds = time_interleaved(
      {[] { work(1); }, [] { work(8); }, [] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }}, 9);
  ASSERT_EQ(seconds.size(), 3u);
  // eight times the work on a machine that may be busy: far from once and far from the sleep's wall time
  EXPECT_GT(seconds[1], 3 * seconds[0]);
  EXPECT_LT(seconds[2], 0.002);
}

TEST(TimeInterleaved, CallsEachAsOftenAsAskedAndOnceToWarmUp) {
  int first = 0, second = 0;
  time_interleaved({[&] { ++first; }, [&] { ++second; }}, 5);
  EXPECT_EQ(first, 6);
  EXPECT_EQ(second, 6);
}

TEST(TimeBoundary, ComparesThreeSidesWhenThereAreThree) {
  const BenchState state = make_state(60, 0);
  const BoundaryTimes two = time_boundary(state, {}, 3);
  EXPECT_FALSE(two.plugins.has_value());
  EXPECT_GT(two.fused_cells, 0);
  EXPECT_GT(two.fused_best, 0);
  const BoundaryTimes three = time_boundary(
      state, [] { work(1); }, 3);
  ASSERT_TRUE(three.plugins.has_value());
  EXPECT_DOUBLE_EQ(three.price() * three.gain(), three.fused_cells / three.fused_best);
}

}  // namespace

}  // namespace riffle::bench
