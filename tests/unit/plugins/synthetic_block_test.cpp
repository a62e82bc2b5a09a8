#include "host/plugins/synthetic_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "riffle/fields.hpp"

namespace riffle {
namespace {

const riffle_field own{sizeof(riffle_field), RIFFLE_SCALAR, 0, 0, "grain_size", "m", "size of the grains"};

TEST(SyntheticScene, GeometryFitsPositionsAndVelocities) {
  SyntheticScene scene;
  scene.dim = 3;
  for (std::int64_t p = 0; p < 40; ++p) {
    double r2 = 0, approach = 0;
    for (int c = 0; c < 3; ++c) {
      const double x = scene.value(fields::separation, RIFFLE_PAIR, c, p);
      r2 += x * x;
      approach += scene.value(fields::velocity, RIFFLE_DIFFERENCE, c, p) * x;
      // Positions are up to 1e3 m apart: their difference is rounded at that size.
      EXPECT_NEAR(scene.value(fields::position, RIFFLE_DIFFERENCE, c, p), x, 1e-12);
    }
    // Three products and sums, which compilers may fuse.
    const double rounding = 4 * std::numeric_limits<double>::epsilon();
    EXPECT_NEAR(scene.value(fields::distance_squared, RIFFLE_PAIR, 0, p), r2, rounding * r2);
    EXPECT_NEAR(scene.value(fields::distance, RIFFLE_PAIR, 0, p), std::sqrt(r2), rounding * std::sqrt(r2));
    EXPECT_NEAR(scene.value(fields::approach, RIFFLE_PAIR, 0, p), approach, 4 * rounding * std::sqrt(r2));
  }
}

TEST(SyntheticScene, SwappedPairsAreTheSamePairsFromTheOtherSide) {
  SyntheticScene scene, swapped;
  scene.dim = swapped.dim = 2;
  swapped.swapped = true;
  for (std::int64_t p = 0; p < 40; ++p) {
    EXPECT_EQ(scene.value(fields::depth, RIFFLE_AT_I, 0, p), swapped.value(fields::depth, RIFFLE_AT_J, 0, p));
    EXPECT_EQ(scene.value(fields::depth, RIFFLE_MEAN, 0, p), swapped.value(fields::depth, RIFFLE_MEAN, 0, p));
    EXPECT_EQ(scene.value(fields::separation, RIFFLE_PAIR, 1, p),
              -swapped.value(fields::separation, RIFFLE_PAIR, 1, p));
    EXPECT_EQ(scene.value(fields::approach, RIFFLE_PAIR, 0, p), swapped.value(fields::approach, RIFFLE_PAIR, 0, p));
    EXPECT_EQ(scene.value(fields::kernel, RIFFLE_AT_I, 0, p), swapped.value(fields::kernel, RIFFLE_AT_J, 0, p));
  }
}

TEST(SyntheticScene, RescalingByPowersOfTwoIsExact) {
  SyntheticScene scene, scaled;
  scene.dim = scaled.dim = 2;
  scaled.scale = {0x1p-12, 0x1p12, 0x1p24};
  for (std::int64_t p = 0; p < 40; ++p) {
    EXPECT_EQ(scene.value(fields::density, RIFFLE_AT_I, 0, p) * 0x1p-48,
              scaled.value(fields::density, RIFFLE_AT_I, 0, p));
    EXPECT_EQ(scene.value(fields::approach, RIFFLE_PAIR, 0, p), scaled.value(fields::approach, RIFFLE_PAIR, 0, p))
        << "m2.s-1: 2^24 / 2^24";
    EXPECT_EQ(scene.value(fields::kernel_gradient, RIFFLE_MEAN, 0, p) * 0x1p-48,
              scaled.value(fields::kernel_gradient, RIFFLE_MEAN, 0, p));
  }
}

TEST(SyntheticScene, SomePairsAreBeyondEverySupportAndAParticleMayPairWithItself) {
  SyntheticScene scene;
  scene.with_self = true;
  double nearest = 1e9, farthest = 0;
  for (std::int64_t p = 0; p < 64; ++p) {
    const double r = scene.value(fields::distance, RIFFLE_PAIR, 0, p);
    nearest = std::min(nearest, r);
    farthest = std::max(farthest, r);
  }
  EXPECT_EQ(nearest, 0);
  EXPECT_GT(farthest, 100);
  EXPECT_EQ(scene.value(fields::depth, RIFFLE_DIFFERENCE, 0, 16), 0);
}

struct OnePass {
  riffle_read read{sizeof(riffle_read), RIFFLE_AT_I, RIFFLE_OPTIONAL, 0, &own};
  const riffle_read* reads[2] = {&read, nullptr};
  riffle_write write{sizeof(riffle_write), RIFFLE_SUM, 0, 0, &fields::acceleration};
  const riffle_write* writes[2] = {&write, nullptr};
  riffle_pass pass{};
  explicit OnePass(std::uint32_t type) {
    pass.size = sizeof pass;
    pass.type = type;
    pass.reads = reads;
    pass.writes = writes;
  }
};

TEST(SyntheticBlock, ItIsLaidOutAsTheBoundarySays) {
  SyntheticScene scene;
  scene.dim = 2;
  const OnePass one(RIFFLE_PASS_PARTICLE);
  const SyntheticBlock block(scene, one.pass, first_items(13));
  EXPECT_EQ(block.block().n, 13);
  EXPECT_EQ(block.components(0), 2);
  EXPECT_EQ(block.in(0)[7], scene.value(own, RIFFLE_AT_I, 0, 7));
  EXPECT_EQ(block.out(0, 1)[7], 0) << "a particle pass adds to zero";
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.in(0)) % 64, 0U);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.out(0, 1)) % 64, 0U);
}

TEST(SyntheticBlock, OptionalReadsCanBeAbsent) {
  SyntheticScene scene;
  scene.optional = false;
  const OnePass one(RIFFLE_PASS_PARTICLE);
  EXPECT_EQ(SyntheticBlock(scene, one.pass, first_items(4)).block().in[0], nullptr);
}

TEST(SyntheticBlock, AWriteBehindTheLastParticleIsSeen) {
  const OnePass one(RIFFLE_PASS_PARTICLE);
  const SyntheticBlock block(SyntheticScene{}, one.pass, first_items(12));
  EXPECT_EQ(block.overrun_output(), -1);
  block.block().out[0][0][12] = 1;
  EXPECT_EQ(block.overrun_output(), 0);
}

TEST(SyntheticBlock, PairsMayBeWrittenToTheNextMultipleOfEight) {
  const OnePass one(RIFFLE_PASS_PAIR);
  const SyntheticBlock block(SyntheticScene{}, one.pass, first_items(12));
  EXPECT_TRUE(std::isnan(block.out(0)[0])) << "a pair pass must set what is summed";
  block.block().out[0][0][15] = 1;
  EXPECT_EQ(block.overrun_output(), -1);
  block.block().out[0][0][16] = 1;
  EXPECT_EQ(block.overrun_output(), 0);
}

TEST(SyntheticBlock, ItemsMayComeInAnyOrder) {
  const OnePass one(RIFFLE_PASS_PAIR);
  const SyntheticBlock block(SyntheticScene{}, one.pass, {5, 2, 9, 0});
  EXPECT_EQ(block.in(0)[2], SyntheticScene{}.value(own, RIFFLE_AT_I, 0, 9));
}

}  // namespace
}  // namespace riffle
