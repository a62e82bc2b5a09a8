#include "riffle/limiters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace riffle::test {
namespace {

double limited(const char* name, double a, double b) {
  double phi = 0;
  with_limiter(limiter_of(name), [&](auto limiter) { phi = limiter(a, b); });
  return phi;
}

TEST(Limiters, KeepLinearFieldsAndMakeNoExtremum) {
  for (const char* name : {"van-leer", "minmod", "monotonised-central", "superbee"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(limited(name, 0.3, 0.3), 0.3);
    EXPECT_EQ(limited(name, -0.3, 0.3), 0);
    EXPECT_EQ(limited(name, 0, 2), 0);
    for (const double a : {1e-9, 0.1, 0.5, 1.0, 3.0, 1e6}) {
      EXPECT_EQ(limited(name, a, 1), limited(name, 1, a));     // it does not matter which side is which
      EXPECT_EQ(limited(name, -a, -1), -limited(name, a, 1));  // nor which way is up
      EXPECT_GE(limited(name, a, 1), std::min(a, 1.0) * (1 - 1e-15));
      EXPECT_LE(limited(name, a, 1), 2 * std::min(a, 1.0));  // the bound of second-order TVD limiters (Sweby 1984)
      EXPECT_LE(limited(name, a, 1), std::max(a, 1.0));
    }
  }
}

TEST(Limiters, HaveTheValuesOfTheirFormulas) {
  EXPECT_DOUBLE_EQ(limited("van-leer", 1, 3), 1.5);
  EXPECT_DOUBLE_EQ(limited("minmod", 1, 3), 1);
  EXPECT_DOUBLE_EQ(limited("monotonised-central", 1, 2), 1.5);
  EXPECT_DOUBLE_EQ(limited("monotonised-central", 1, 9), 2);
  EXPECT_DOUBLE_EQ(limited("superbee", 1, 1.5), 1.5);
  EXPECT_DOUBLE_EQ(limited("superbee", 1, 9), 2);
  EXPECT_DOUBLE_EQ(limited("first-order", 1, 1), 0);
}

TEST(Limiters, ANameThatIsNoneIsRefused) {
  EXPECT_THROW(limiter_of("van-leeer"), std::invalid_argument);
  const std::string names = limiter_choices;
  for (std::size_t at = 0; at != std::string::npos + 1;) {
    const std::size_t end = names.find('|', at);
    EXPECT_NO_THROW(limiter_of(names.substr(at, end - at)));
    at = end + 1;
  }
}

}  // namespace
}  // namespace riffle::test
