#include "host/plugins/floating_point.hpp"

#include <gtest/gtest.h>

namespace riffle {
namespace {

TEST(FloatingPointGuard, PutsBackTheRoundingModeAndSaysSo) {
  FloatingPointGuard guard;
  std::fesetround(FE_UPWARD);
  EXPECT_TRUE(guard.restore());
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
  EXPECT_FALSE(guard.restore());
}

TEST(FloatingPointGuard, RaisedFlagsAreNoChange) {
  FloatingPointGuard guard;
  volatile double zero = 0, one = 1;
  volatile double infinity = one / zero;
  (void)infinity;
  EXPECT_FALSE(guard.restore());
}

TEST(FloatingPointGuard, PutsItBackWhenItsScopeEnds) {
  {
    const FloatingPointGuard guard;
    std::fesetround(FE_DOWNWARD);
  }
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

}  // namespace
}  // namespace riffle
