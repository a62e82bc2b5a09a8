#include "host/plugins/unit.hpp"

#include <gtest/gtest.h>

namespace riffle {
namespace {

TEST(Unit, ProductsOfPowersAreRead) {
  const auto density = parse_unit("kg.m-3");
  ASSERT_TRUE(density);
  EXPECT_EQ(density->exponent(Unit::kilogram, 2), 1);
  EXPECT_EQ(density->exponent(Unit::metre, 2), -3);
  EXPECT_EQ(density->exponent(Unit::second, 2), 0);
}

TEST(Unit, OneIsTheUnitOfNumbers) {
  EXPECT_EQ(parse_unit("1"), Unit{});
}

TEST(Unit, ExponentDIsTheDimensionOfTheScene) {
  const auto water = parse_unit("m.md");
  ASSERT_TRUE(water);
  EXPECT_EQ(water->exponent(Unit::metre, 1), 2);
  EXPECT_EQ(water->exponent(Unit::metre, 2), 3);
  EXPECT_EQ(parse_unit("m-d.m-2")->exponent(Unit::metre, 3), -5);
}

TEST(Unit, RoughnessOfManningHasAThirdAsExponent) {
  const auto roughness = parse_unit("s.m-1/3");
  ASSERT_TRUE(roughness);
  EXPECT_DOUBLE_EQ(roughness->exponent(Unit::metre, 1), -1.0 / 3);
}

TEST(Unit, OrderOfFactorsDoesNotMatter) {
  EXPECT_EQ(parse_unit("m.s-1"), parse_unit("s-1.m"));
}

TEST(Unit, RateTimesSecondsIsTheUnitItself) {
  const Unit velocity = parse_unit("m.s-1").value();
  EXPECT_EQ(velocity * parse_unit("s").value(), parse_unit("m"));
  EXPECT_EQ(velocity * velocity.inverse(), Unit{});
}

TEST(Unit, AnythingElseIsRefused) {
  for (const char* text :
       {"", "kg/m3", "m^2", "mm", "m-", "m.", ".m", "sd", "m1/5", "m--1", "m0", "kg m", "Pa", "m1x"}) {
    EXPECT_FALSE(parse_unit(text)) << text;
  }
}

}  // namespace
}  // namespace riffle
