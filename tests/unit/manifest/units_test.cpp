#include "host/manifest/units.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace riffle {
namespace {

double si(const std::string& text) {
  const auto quantity = split_quantity(text);
  if (!quantity) throw std::invalid_argument(text + " is no quantity");
  return in_si(*quantity, read_unit(quantity->unit)).value();
}

SiDimension dimension(const std::string& unit) {
  return read_unit(unit).dimension;
}

std::string error_of(const std::string& unit) {
  try {
    read_unit(unit);
  } catch (const UnitError& error) {
    return error.what();
  }
  return "";
}

TEST(Units, APrefixedQuantityIsTheSameDoubleAsTheNumberWrittenOutInSi) {
  EXPECT_EQ(si("15.9 mm"), 0.0159);
  EXPECT_EQ(si("3 cm"), 0.03);
  EXPECT_EQ(si("0.25mm"), 0.00025);
  EXPECT_EQ(si("20 l/s"), 0.02);
  EXPECT_EQ(si("5 %"), 0.05);
  EXPECT_EQ(si("2.65 g/cm3"), 2650);
  EXPECT_EQ(si("1.5e3 um"), 0.0015);
  EXPECT_EQ(si("-3 kPa"), -3000);
  EXPECT_EQ(si("+2 km"), 2000);
}

TEST(Units, TheWaysOfWritingAUnitAgree) {
  for (const char* text : {"9.81 m/s2", "9.81 m/s^2", "9.81 m.s-2", "9.81 m.s^-2", "9.81 m s-2", "9.81 m/s/s",
                           "9.81 m·s⁻²", "9.81 m*s^(-2)", "9.81 N/kg"}) {
    EXPECT_EQ(si(text), 9.81) << text;
    EXPECT_EQ(dimension(split_quantity(text)->unit), dimension("m.s-2")) << text;
  }
  EXPECT_EQ(si("1000 kg/m3"), si("1000 kg.m-3"));
  EXPECT_EQ(si("1e-6 m2.s-1"), 1e-6);
  EXPECT_EQ(dimension("m2/s"), dimension("m².s-1"));
}

TEST(Units, TimesAndAnglesAreConvertedWithOneRounding) {
  EXPECT_EQ(si("2 min"), 120);
  EXPECT_EQ(si("1.5 h"), 5400);
  EXPECT_EQ(si("36 km/h"), 10);
  EXPECT_EQ(si("45 deg"), 45 * std::numbers::pi / 180);
  EXPECT_EQ(si("180 °"), std::numbers::pi);
  EXPECT_EQ(dimension("deg"), dimension("1"));
}

TEST(Units, DerivedUnitsHaveTheDimensionOfTheirBaseUnits) {
  EXPECT_EQ(dimension("Pa"), dimension("kg.m-1.s-2"));
  EXPECT_EQ(dimension("N"), dimension("kg.m.s-2"));
  EXPECT_EQ(dimension("Pa.s"), dimension("kg.m-1.s-1"));
  EXPECT_EQ(dimension("l"), dimension("m3"));
  EXPECT_EQ(dimension("W"), dimension("J/s"));
  EXPECT_EQ(dimension("Hz"), dimension("1/s"));
}

TEST(Units, ThirdsAreExactSoThatManningsCoefficientHasItsUnit) {
  EXPECT_EQ(dimension("s.m-1/3"), dimension("s/m^(1/3)"));
  EXPECT_EQ(dimension("s.m-1/3"), dimension("s/m1/3"));
  EXPECT_NE(dimension("s.m-1/3"), dimension("s.m-1"));
  EXPECT_EQ(si("0.03 s.m-1/3"), 0.03);
  EXPECT_NEAR(si("0.03 s.km-1/3"), 0.003, 1e-17);  // one pow, one product: a few round-offs of 0.003
}

TEST(Units, TheExponentDStandsForTheDimensionOfTheScene) {
  EXPECT_EQ(read_unit("m-d", 2).dimension, dimension("m-2"));
  EXPECT_EQ(read_unit("md", 3).dimension, dimension("m3"));
  EXPECT_EQ(read_unit("kg.m-3.md", 3).dimension, dimension("kg"));
  EXPECT_EQ(read_unit("m.md", 1).dimension, dimension("m2"));
  EXPECT_EQ(error_of("md"), "unknown unit \"md\"; did you mean \"m\"?");
}

TEST(Units, WrongUnitsAreNamed) {
  EXPECT_EQ(error_of("mmm"), "unknown unit \"mmm\"; did you mean \"mm\"?");
  EXPECT_EQ(error_of("Kg"), "unknown unit \"Kg\"; did you mean \"kg\"?");
  EXPECT_EQ(error_of("furlong"), "unknown unit \"furlong\"");
  EXPECT_EQ(error_of("m^"), "\"m^\" is no unit");
  EXPECT_EQ(error_of("m/"), "\"m/\" is no unit");
  EXPECT_EQ(error_of("m1/7"), "\"m1/7\" is no unit");  // only twelfths are kept
  EXPECT_EQ(error_of("kg/m.s"), "\"kg/m.s\" is ambiguous after its \"/\"; write kg/m/s or kg.m-1.s-1 for example");
}

TEST(Units, ATextIsAQuantityWhenANumberGoesOnWithLettersAndAFormulaWhenItGoesOnWithAnOperator) {
  for (const char* quantity : {"10 m", "10", "1e-3", "5%", ".5 m", "2 min", "3 x", "1 1/s"}) {
    EXPECT_TRUE(split_quantity(quantity).has_value()) << quantity;
  }
  for (const char* formula : {"10*x", "x", "2 - x", "5 < x ? 1 : 2", "-x", "(3)", "", "1/s", "sin(x)", "nan", "inf"}) {
    EXPECT_FALSE(split_quantity(formula).has_value()) << formula;
  }
}

TEST(Units, ANumberBeyondTheRangeOfDoubleHasNoValue) {
  EXPECT_FALSE(in_si(*split_quantity("1e308 km"), read_unit("km")).has_value());
}

}  // namespace
}  // namespace riffle
