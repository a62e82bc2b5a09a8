// Images follow their origins: positions are mirrored or shifted, components across a mirror change sign by the rule of
// their shape, and a corner is the image of an image.
#include "host/schedule/images.hpp"

#include <gtest/gtest.h>

namespace riffle::test::images {
namespace {

FieldDescription described(const std::string& name, Shape shape) {
  FieldDescription d;
  d.name = name;
  d.unit = "1";
  d.shape = shape;
  return d;
}

// Two particles, and three images: 0 behind the plane x = 1, that image behind the plane z = 0, and 1 shifted by (2, 3).
class Images : public testing::Test {
 protected:
  Images() {
    store_.resize_owned({2, 0, 0, 0, 0, 0});
    store_.add_field(described("position", Shape::vector), FieldUse::evolved);
    set("position", {{0.75, 0.5}, {0.125, 0.25}});
    store_.resize_images(3);
  }
  // values[component][particle]
  void set(const std::string& name, const std::vector<std::vector<double>>& values) {
    for (std::size_t c = 0; c < values.size(); ++c) {
      for (std::size_t i = 0; i < 2; ++i) store_.data(name, static_cast<int>(c))[i] = values[c][i];
    }
  }
  std::vector<double> of_images(const std::string& name, int component) {
    refresh_images(images_, store_, store_.at(name));
    const double* v = store_.data(name, component) + 2;
    return {v, v + 3};
  }
  ParticleStore store_{2};
  const std::vector<Image> images_{{0, true, 0, {1, 0, 0}}, {2, true, 1, {0, 0, 0}}, {1, false, 0, {2, 3, 0}}};
};

TEST_F(Images, StandBehindThePlaneOrShifted) {
  EXPECT_EQ(of_images("position", 0), (std::vector<double>{1.25, 1.25, 2.5}));
  EXPECT_EQ(of_images("position", 1), (std::vector<double>{0.125, -0.125, 3.25}));
}

TEST_F(Images, HaveTheScalarsOfTheirOrigins) {
  store_.add_field(described("depth", Shape::scalar), FieldUse::derived);
  set("depth", {{3, 4}});
  EXPECT_EQ(of_images("depth", 0), (std::vector<double>{3, 3, 4}));
}

TEST_F(Images, ReverseTheNormalComponentOfVectors) {
  store_.add_field(described("velocity", Shape::vector), FieldUse::evolved);
  set("velocity", {{5, 6}, {7, 8}});
  EXPECT_EQ(of_images("velocity", 0), (std::vector<double>{-5, -5, 6})) << "the plane of the second is normal to z";
  EXPECT_EQ(of_images("velocity", 1), (std::vector<double>{7, -7, 8}));
}

TEST_F(Images, ReverseTheMixedComponentsOfTensorsOnly) {
  store_.add_field(described("gradient", Shape::tensor), FieldUse::derived);
  set("gradient", {{1, 10}, {2, 20}, {3, 30}, {4, 40}});
  EXPECT_EQ(of_images("gradient", 0), (std::vector<double>{1, 1, 10}));
  EXPECT_EQ(of_images("gradient", 1), (std::vector<double>{-2, 2, 20})) << "twice reversed in the corner";
  EXPECT_EQ(of_images("gradient", 2), (std::vector<double>{-3, 3, 30}));
  EXPECT_EQ(of_images("gradient", 3), (std::vector<double>{4, 4, 40}));
  store_.add_field(described("stress", Shape::symmetric), FieldUse::derived);
  set("stress", {{1, 10}, {2, 20}, {3, 30}});
  EXPECT_EQ(of_images("stress", 0), (std::vector<double>{1, 1, 10}));
  EXPECT_EQ(of_images("stress", 1), (std::vector<double>{-2, 2, 20}));
  EXPECT_EQ(of_images("stress", 2), (std::vector<double>{3, 3, 30}));
}

}  // namespace
}  // namespace riffle::test::images
