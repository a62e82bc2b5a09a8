// Shapes of beds and channels: values by hand, and slopes that are the slopes of the values.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/contract/csv.hpp"
#include "tests/contract/loaded.hpp"

namespace riffle::contract {
namespace {

struct Point {
  double value = 0, slope = 0;
};
class Shape {
 public:
  Shape(const std::string& kind, const std::string& id, const std::map<std::string, double>& given)
      : instance_(plugin(kind, id), 1, given) {}
  [[nodiscard]] Point at(double x) const {
    Point p;
    riffle_error error{sizeof(riffle_error), {}};
    EXPECT_EQ(instance_.table().evaluate_profile(instance_.self(), 1, &x, nullptr, &p.value, &p.slope, nullptr, &error),
              RIFFLE_OK);
    double alone = 0;  // without slopes
    instance_.table().evaluate_profile(instance_.self(), 1, &x, nullptr, &alone, nullptr, nullptr, &error);
    EXPECT_EQ(alone, p.value);
    return p;
  }
  [[nodiscard]] double value(double x) const { return at(x).value; }
  // Central differences over 2e-6: of second order, and round-off of 1e-10.
  void expect_slopes(double low, double high) const {
    for (int k = 0; k < 97; ++k) {
      const double x = low + (high - low) * (k + 0.5) / 97, d = 1e-6;
      EXPECT_NEAR(at(x).slope, (value(x + d) - value(x - d)) / (2 * d), 1e-8) << "at " << x;
    }
  }

 private:
  Instance instance_;
};

TEST(Bed, OfAStepJumpsWhereItIsToldAndIsFlatOnBothSides) {
  const Shape step("bed", "step", {{"position", 10}, {"height", 1}, {"level", 0.5}});
  EXPECT_EQ(step.value(9.999999), 0.5);
  EXPECT_EQ(step.value(10), 1.5);
  EXPECT_EQ(step.at(9.999999).slope, 0);
  EXPECT_EQ(step.at(10).slope, 0);
}

TEST(Bed, OfAHumpIsTheParabolaOfThePaper) {  // Diwakar & Mohapatra (2023), eq. 18
  const Shape hump("bed", "parabolic-hump", {{"height", 0.2}, {"center", 5}, {"half_length", 2}});
  EXPECT_EQ(hump.value(5), 0.2);
  EXPECT_DOUBLE_EQ(hump.value(4), 0.15);
  EXPECT_DOUBLE_EQ(hump.at(4).slope, 0.1);
  for (const double x : {0.0, 3.0, 7.0, 9.0}) {
    EXPECT_EQ(hump.value(x), 0);
    EXPECT_EQ(hump.at(x).slope, 0);
  }
  hump.expect_slopes(3.001, 6.999);
}

TEST(Bed, OfConstantSlopeFallsAlongXWhenTheSlopeIsPositive) {
  const Shape bed("bed", "slope", {{"slope", 0.01}, {"origin", 100}, {"level", 2}});
  EXPECT_EQ(bed.value(100), 2);
  EXPECT_DOUBLE_EQ(bed.value(200), 1);
  EXPECT_DOUBLE_EQ(bed.at(7).slope, -0.01);
}

TEST(Width, OfAContractionIsACosine) {
  const Shape channel("width", "contraction", {{"throat_width", 0.6}, {"center", 5}, {"half_length", 2}});
  EXPECT_DOUBLE_EQ(channel.value(5), 0.6);
  EXPECT_DOUBLE_EQ(channel.value(4), 0.8);
  EXPECT_EQ(channel.value(3), 1);
  EXPECT_EQ(channel.value(9), 1);
  channel.expect_slopes(0, 10);
}

class Parshall : public testing::TestWithParam<std::vector<std::string>> {};

// Columns W, A, B, C, D, E, F, G, K, N of the table, in mm.
TEST_P(Parshall, HasTheStandardDimensions) {
  const auto& row = GetParam();
  const auto metres = [&](std::size_t column) { return std::stod(row[column]) / 1000; };
  const double throat = metres(0), crest = 3, end_of_throat = crest + metres(6), end = end_of_throat + metres(7);
  const Shape bed("bed", "parshall", {{"throat_width", throat}, {"crest", crest}, {"level", 1}});
  const Shape width("width", "parshall", {{"throat_width", throat}, {"crest", crest}});
  EXPECT_DOUBLE_EQ(width.value(crest - metres(2)), metres(4));
  EXPECT_DOUBLE_EQ(width.value(crest), throat);
  EXPECT_DOUBLE_EQ(width.value(end_of_throat), throat);
  EXPECT_DOUBLE_EQ(width.value(end), metres(3));
  EXPECT_DOUBLE_EQ(width.value(end + 1), metres(3));
  EXPECT_DOUBLE_EQ(bed.value(crest - 1), 1);
  EXPECT_DOUBLE_EQ(bed.value(crest), 1);
  EXPECT_DOUBLE_EQ(bed.value(end_of_throat), 1 - metres(9));
  EXPECT_DOUBLE_EQ(bed.value(end), 1 - metres(8));
  EXPECT_DOUBLE_EQ(bed.value(end + 1), 1 - metres(8));
  for (const Shape* shape : {&bed, &width}) {
    shape->expect_slopes(crest - metres(2) + 1e-3, crest - 1e-3);
    shape->expect_slopes(crest + 1e-3, end_of_throat - 1e-3);
    shape->expect_slopes(end_of_throat + 1e-3, end - 1e-3);
  }
}
INSTANTIATE_TEST_SUITE_P(Flumes, Parshall,
                         testing::ValuesIn(csv_rows(std::string(RIFFLE_CASES) + "/parshall/standard-dimensions.csv")),
                         [](const auto& info) { return "throat_of_" + info.param[0] + "_mm"; });

TEST(ParshallFlume, OfAnotherThroatIsRefusedWithTheOnesThereAre) {
  for (const std::string kind : {"bed", "width"}) {
    try {
      const Instance flume(plugin(kind, "parshall"), 1, {{"throat_width", 0.4}, {"crest", 0}});
      FAIL() << "a flume that is no standard one was accepted";
    } catch (const Refused& refused) {
      EXPECT_STREQ(refused.what(),
                   "throat_width is 0.4 m, but a standard Parshall flume has one of 0.229, 0.305, 0.457, 0.61, 0.915, "
                   "1.22, 1.525, 1.83, 2.135, 2.44 m");
    }
  }
}

}  // namespace
}  // namespace riffle::contract
