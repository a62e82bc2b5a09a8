#include "riffle/shallow_riemann.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace riffle::test::riemann {
namespace {

constexpr double g = 9.81, dry = 1e-8;

TEST(Hll, OfTwoEqualStatesIsTheFluxOfThatState) {
  for (const double u : {-9.0, -1.0, 0.0, 2.5, 12.0}) {
    for (const double w : {0.0, 1.5, u}) {
      const ShallowFlux flux = hll_flux(g, {2, u}, {2, u}, w, 0, dry);
      EXPECT_NEAR(flux.volume, 2 * (u - w), 1e-14 * (1 + std::abs(u)));
      EXPECT_NEAR(flux.momentum, 2 * u * (u - w) + 0.5 * g * 4, 1e-13 * (20 + u * u));
    }
  }
}

TEST(Hll, SeesTheSameInAMirror) {
  const ShallowFlux a = hll_flux(g, {3, 1}, {1, -0.5}, 0.2, 0, dry), b = hll_flux(g, {1, 0.5}, {3, -1}, -0.2, 0, dry);
  EXPECT_NEAR(a.volume, -b.volume, 1e-14 * std::abs(a.volume));
  EXPECT_NEAR(a.momentum, b.momentum, 1e-14 * a.momentum);
}

TEST(Hll, StillWaterOfTheDepthThatIsTakenOffGivesExactlyNothing) {
  const double h = 0.1 + 0.2;
  const ShallowFlux flux = hll_flux(g, {h, 0}, {h, 0}, 0, h, dry);
  EXPECT_EQ(flux.volume, 0);
  EXPECT_EQ(flux.momentum, 0);
}

TEST(Hll, InAMovingFrameTheFaceOnlyTakesItsShareAlong) {
  // with the frame at rest F, at speed w F - w U*, U* being the state at the face: at a face that all waves leave behind
  // it is that of the side they come from
  const ShallowFlux rest = hll_flux(g, {1, 9}, {0.5, 8}, 0, 0, dry), moving = hll_flux(g, {1, 9}, {0.5, 8}, 2, 0, dry);
  EXPECT_NEAR(rest.volume - moving.volume, 2 * 1, 1e-14);
  EXPECT_NEAR(rest.momentum - moving.momentum, 2 * 1 * 9, 1e-13);
}

TEST(Hll, ADryBedGetsWaterAndGivesNone) {
  const ShallowFlux out = hll_flux(g, {1, 0}, {0, 0}, 0, 0, dry);
  // L c / 3 of the dam, S_R = 2 c: F = (S_R F_L - S_L F_R + S_L S_R (0 - h)) / (S_R - S_L) = 2 c h / 3
  EXPECT_NEAR(out.volume, 2.0 / 3.0 * std::sqrt(g), 1e-14);
  const ShallowFlux back = hll_flux(g, {0, 0}, {1, 0}, 0, 0, dry);
  EXPECT_NEAR(back.volume, -out.volume, 1e-14);
  EXPECT_NEAR(back.momentum, out.momentum, 1e-14);
  const ShallowFlux none = hll_flux(g, {0, 0}, {0, 0}, 0, 0, dry);
  EXPECT_EQ(none.volume, 0);
  EXPECT_EQ(none.momentum, 0);
}

}  // namespace
}  // namespace riffle::test::riemann
