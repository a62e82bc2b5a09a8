// What the terrain refuses, and what plugins see of it.
#include "host/terrain/terrain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/terrain/made_up_bed.hpp"

namespace riffle::test {
namespace {

TEST(Terrain, WithoutPluginsIsFlatAndAMetreWide) {
  Case scene;
  scene.upper[0] = 3;
  const Terrain terrain(scene, nullptr, nullptr);
  const riffle_services& s = terrain.services();
  const double x[] = {-1, 2};
  double level[2], slope[2], width[2];
  s.bed(s.context, 2, x, nullptr, level, slope, nullptr);
  EXPECT_EQ(level[1], 0);
  EXPECT_EQ(slope[1], 0);
  s.width(s.context, 2, x, width, slope);
  EXPECT_EQ(width[0], 1);
  EXPECT_EQ(slope[0], 0);
  EXPECT_EQ(s.has_bed, 0u);
  EXPECT_EQ(s.has_width, 0u);
  EXPECT_EQ(s.high[0], 3);
}

TEST(Terrain, ShowsPluginsTheBedOfTheScene) {
  const MadeUpBed bed([](double x) { return 0.1 * x; });
  const riffle_services& s = bed.terrain().services();
  const double x = 4;
  double level = 0, slope = 0;
  s.bed(s.context, 1, &x, nullptr, &level, &slope, nullptr);
  EXPECT_DOUBLE_EQ(level, 0.4);
  EXPECT_NEAR(slope, 0.1, 1e-9);
  EXPECT_EQ(s.has_bed, 1u);
}

TEST(Terrain, RefusesABedWithAGap) {
  try {
    const MadeUpBed bed([](double x) { return x > 5 && x < 6 ? std::nan("") : 0.0; });
    FAIL() << "a gap was accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("bed \"made-up\": the level of the bed must be finite"), std::string::npos)
        << error.what();
  }
}

TEST(Terrain, MakesADepthOfALevel) {
  class Level : public Function::Implementation {
    void evaluate(std::int64_t n, const double*, const double*, const double*, double, double* out) const override {
      std::fill_n(out, n, 1.0);
    }
  };
  const MadeUpBed bed([](double x) { return 0.25 * x; });
  const Function depth = depth_below(Function(std::make_shared<Level>(), "1"), bed.terrain());
  EXPECT_DOUBLE_EQ(depth(2), 0.5);
  EXPECT_EQ(depth(8), 0);  // the bed is higher than the water
}

}  // namespace
}  // namespace riffle::test
