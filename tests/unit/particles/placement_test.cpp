#include "host/particles/placement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace riffle {
namespace {

using Formula = std::function<double(double x, double y, double z)>;

Function function(Formula formula) {
  class OfFormula : public Function::Implementation {
   public:
    explicit OfFormula(Formula formula) : formula_(std::move(formula)) {}
    void evaluate(std::int64_t n, const double* x, const double* y, const double* z, double,
                  double* out) const override {
      for (std::int64_t k = 0; k < n; ++k) {
        out[k] = formula_(x != nullptr ? x[k] : 0, y != nullptr ? y[k] : 0, z != nullptr ? z[k] : 0);
      }
    }

   private:
    Formula formula_;
  };
  return {std::make_shared<OfFormula>(std::move(formula)), "test"};
}

Function dam(double at, double left, double right) {
  return function([=](double x, double, double) { return x < at ? left : right; });
}

Case channel(double low, double high, const Function& depth) {
  Case scene;
  scene.dimension = 1;
  scene.lower[0] = low;
  scene.upper[0] = high;
  scene.initial["depth"] = {depth};
  return scene;
}

PlacedParticles by_spacing(Case scene, double spacing) {
  scene.placement.mode = Placement::Mode::spacing;
  scene.placement.spacing = spacing;
  return place(scene);
}

PlacedParticles by_count(Case scene, std::int64_t count) {
  scene.placement.mode = Placement::Mode::count;
  scene.placement.count = count;
  return place(scene);
}

PlacedParticles by_volume(Case scene, std::int64_t count) {
  scene.placement.mode = Placement::Mode::equal_volume;
  scene.placement.count = count;
  return place(scene);
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const PlacementError& error) {
    return error.what();
  }
  return "";
}

TEST(PlacementBySpacing, ParticlesStandInTheMiddleOfCellsOfTheGivenSize) {
  const PlacedParticles p = by_spacing(channel(-1, 1, dam(0, 2, 1)), 0.25);
  EXPECT_EQ(p.x[0], (std::vector<double>{-0.875, -0.625, -0.375, -0.125, 0.125, 0.375, 0.625, 0.875}));
  EXPECT_EQ(p.cell_measure, std::vector<double>(8, 0.25));
  EXPECT_TRUE(p.x[1].empty());
}

TEST(PlacementBySpacing, ARoundedQuotientOfLengthAndSpacingNeitherAddsNorLosesAParticle) {
  for (const int n : {3, 7, 49, 674, 8000}) {
    const double length = 0.1 * n;  // not a multiple in binary
    EXPECT_EQ(by_spacing(channel(0, length, dam(1, 1, 1)), 0.1).x[0].size(), static_cast<std::size_t>(n));
    EXPECT_EQ(by_spacing(channel(0, 200, dam(1, 1, 1)), 200.0 / n).x[0].size(), static_cast<std::size_t>(n));
  }
}

TEST(PlacementBySpacing, DryCellsAndCellsThatAreNotInsideStayEmpty) {
  EXPECT_EQ(by_spacing(channel(-1, 1, dam(0, 2, 0)), 0.5).x[0], (std::vector<double>{-0.75, -0.25}));
  Case scene = channel(-1, 1, dam(0, 2, 1));
  scene.placement.inside = function([](double x, double, double) { return x - 0.5; });
  EXPECT_EQ(by_spacing(scene, 0.5).x[0], (std::vector<double>{0.75}));
}

TEST(PlacementBySpacing, AVerticalPlaneIsFilledColumnByColumnAndItsFunctionsSeeXAndZ) {
  Case scene;
  scene.dimension = 2;
  scene.lower = {0, -1, 0};
  scene.upper = {2, 1, 0};
  scene.placement.inside = function([](double x, double y, double z) { return y == 0 && z < x - 1 ? 1 : 0; });
  const PlacedParticles p = by_spacing(scene, 1);
  EXPECT_EQ(p.x[0], (std::vector<double>{1.5}));
  EXPECT_EQ(p.x[1], (std::vector<double>{-0.5}));
  scene.placement.inside = Function();
  const PlacedParticles all = by_spacing(scene, 1);
  EXPECT_EQ(all.x[0], (std::vector<double>{0.5, 0.5, 1.5, 1.5}));
  EXPECT_EQ(all.x[1], (std::vector<double>{-0.5, 0.5, -0.5, 0.5}));
  EXPECT_TRUE(all.x[2].empty());
  EXPECT_EQ(all.cell_measure, std::vector<double>(4, 1));
}

TEST(PlacementBySpacing, ABoxIsFilledAlongXYAndZ) {
  Case scene;
  scene.dimension = 3;
  scene.lower = {0, 0, 0};
  scene.upper = {1, 2, 3};
  scene.placement.inside = function([](double x, double y, double z) { return 4 - (x + y + z); });
  const PlacedParticles p = by_spacing(scene, 1);
  EXPECT_EQ(p.x[0], (std::vector<double>{0.5, 0.5, 0.5, 0.5, 0.5}));
  EXPECT_EQ(p.x[1], (std::vector<double>{0.5, 0.5, 0.5, 1.5, 1.5}));
  EXPECT_EQ(p.x[2], (std::vector<double>{0.5, 1.5, 2.5, 0.5, 1.5}));
  EXPECT_EQ(by_spacing(scene, 0.5).cell_measure.front(), 0.125);
}

TEST(PlacementByCount, TheWettedLengthIsCutIntoEqualCells) {
  const PlacedParticles p = by_count(channel(0, 200, dam(100, 10, 1)), 8000);
  ASSERT_EQ(p.x[0].size(), 8000u);
  for (std::size_t k = 0; k < 8000; ++k) {
    // one multiplication, one division and one sum around 200: two of its last bits
    ASSERT_NEAR(p.x[0][k], (static_cast<double>(k) + 0.5) * 0.025, 6e-14);
  }
  EXPECT_EQ(p.cell_measure, std::vector<double>(8000, 0.025));
}

TEST(PlacementByCount, AFaceFallsOnTheDamWhenTheDamLiesOnACellFace) {
  const PlacedParticles p = by_count(channel(0, 200, dam(100, 10, 1)), 400);
  EXPECT_LT(p.x[0][199], 100);
  EXPECT_GT(p.x[0][200], 100);
  EXPECT_NEAR(p.x[0][199] + p.cell_measure[199] / 2, 100, 3e-14);  // two last bits of 100
  EXPECT_NEAR(p.x[0][200] - p.cell_measure[200] / 2, 100, 3e-14);
}

TEST(PlacementByCount, TheDryPartOfADamBreakIsLeftOut) {
  const PlacedParticles p = by_count(channel(-4.65, 10, dam(0, 1, 0)), 674);
  ASSERT_EQ(p.x[0].size(), 674u);
  EXPECT_NEAR(p.cell_measure.front(), 4.65 / 674, 1e-17);
  EXPECT_NEAR(p.x[0].front() - p.cell_measure.front() / 2, -4.65, 2e-15);
  EXPECT_NEAR(p.x[0].back() + p.cell_measure.back() / 2, 0, 2e-15);
}

TEST(PlacementByCount, SeveralStretchesOfWaterShareTheParticlesByTheirLength) {
  const Function pools = function([](double x, double, double) { return x < 1 || (x >= 3 && x < 6) ? 0.1 : -1; });
  const PlacedParticles p = by_count(channel(0, 10, pools), 8);
  const std::vector<double> expected{0.25, 0.75, 3.25, 3.75, 4.25, 4.75, 5.25, 5.75};
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(p.x[0][k], expected[k], 4e-15);
  EXPECT_NEAR(sum(p.cell_measure), 4, 1e-14);
}

TEST(PlacementByVolume, EveryParticleHoldsTheSameWater) {
  const Function depth = function([](double x, double, double) { return 1 + 0.5 * std::sin(x); });
  const Case scene = channel(0, 10, depth);
  const PlacedParticles p = by_volume(scene, 1000);
  const double total = 10 + 0.5 * (1 - std::cos(10.0));
  const auto water_left_of = [](double x) { return x + 0.5 * (1 - std::cos(x)); };
  for (std::size_t k = 0; k < 1000; ++k) {
    // Gauss points on intervals of 10/8192 leave an error far below round-off: what remains are some last bits of 10
    ASSERT_NEAR(water_left_of(p.x[0][k]), total * (static_cast<double>(k) + 0.5) / 1000, 2e-14);
    ASSERT_NEAR(p.cell_measure[k] * depth(p.x[0][k]), total / 1000, 1e-15);
  }
}

TEST(PlacementByVolume, NoCellStraddlesTheDamWhenTheCountAllowsIt) {
  // 1000 m2 on the left and 500 m2 on the right: 200 and 100 cells of 5 m2
  const PlacedParticles p = by_volume(channel(0, 200, dam(100, 10, 5)), 300);
  for (std::size_t k = 0; k < 300; ++k) {
    const double width = k < 200 ? 0.5 : 1.0;
    const double expected = k < 200 ? (static_cast<double>(k) + 0.5) * 0.5 : 100 + (static_cast<double>(k) - 199.5);
    ASSERT_NEAR(p.x[0][k], expected, 1e-12);  // a sum of 2400 parts and a quotient: some ten last bits of 1500, over 5
    ASSERT_NEAR(p.cell_measure[k], width, 1e-15);
  }
}

TEST(PlacementByVolume, ADamAnywhereIsFoundToTheLastBits) {
  for (const double at : {31.41592653589793, 77.7, 100.0 / 3}) {
    // 3 at + (100 - at) = 100 + 2 at; cut so that the left side is a whole number of cells
    const Case scene = channel(0, at + 3 * at, dam(at, 3, 1));  // 3 at on either side
    const PlacedParticles p = by_volume(scene, 200);
    EXPECT_NEAR(p.x[0][99] + p.cell_measure[99] / 2, at, 1e-12 * at);
    EXPECT_NEAR(p.x[0][100] - p.cell_measure[100] / 2, at, 1e-12 * at);
    EXPECT_NEAR(p.cell_measure[99], at / 100, 1e-12);
    EXPECT_NEAR(p.cell_measure[100], 3 * at / 100, 1e-12);
  }
}

TEST(PlacementByVolume, WhenTheCountDoesNotAllowItOneCellStraddlesTheDamAndHoldsNoLess) {
  const PlacedParticles p = by_volume(channel(0, 2, dam(1, 3, 1)), 3);  // 3 and 1 m2: cells of 4/3
  EXPECT_NEAR(p.x[0][0], 2.0 / 9, 1e-14);
  EXPECT_NEAR(p.x[0][1], 6.0 / 9, 1e-14);
  EXPECT_NEAR(p.x[0][2], 1 + 1.0 / 3, 1e-14);  // the third cell: 1/3 m2 left of the dam, 1 m2 right of it
  EXPECT_NEAR(p.cell_measure[2], 4.0 / 3, 1e-14);
}

TEST(PlacementByVolume, AStraightShorelineCarriesWiderCellsTowardsIt) {
  const PlacedParticles p = by_volume(channel(0, 2, function([](double x, double, double) { return 1 - x; })), 50);
  for (std::size_t k = 0; k < 50; ++k) {
    const double wanted = (static_cast<double>(k) + 0.5) / 100;  // of x - x^2/2 = 1/2 at the shore
    ASSERT_NEAR(p.x[0][k] - p.x[0][k] * p.x[0][k] / 2, wanted, 1e-14);
    if (k > 0) {
      ASSERT_GT(p.cell_measure[k], p.cell_measure[k - 1]);
    }
  }
}

TEST(Perturbation, MovesEveryParticleWithinItsCellAndLeavesItsMeasure) {
  Case scene = channel(0, 200, dam(100, 10, 1));
  const PlacedParticles still = by_volume(scene, 550);
  scene.placement.perturbation = 0.3;
  const PlacedParticles moved = by_volume(scene, 550);
  EXPECT_EQ(moved.cell_measure, still.cell_measure);
  double largest = 0, mean = 0;
  for (std::size_t k = 0; k < 550; ++k) {
    const double shift = (moved.x[0][k] - still.x[0][k]) / still.cell_measure[k];
    largest = std::max(largest, std::abs(shift));
    mean += shift / 550;
  }
  EXPECT_LE(largest, 0.3 + 1e-9);
  EXPECT_GT(largest, 0.29);  // 550 uniform numbers: all below 29/30 with a probability of 1e-8
  EXPECT_LT(std::abs(mean), 4 * 0.3 / std::sqrt(3 * 550));  // four standard deviations
}

TEST(Perturbation, IsTheSameEverywhereForOneSeedAndAnotherForAnother) {
  Case scene = channel(0, 4, dam(9, 1, 1));
  scene.placement.perturbation = 0.25;
  scene.placement.seed = 1;
  const PlacedParticles one = by_spacing(scene, 1);
  // The engine is std::mt19937_64, whose numbers the standard fixes; the first two of seed 1 are these.
  const auto displacement = [](std::uint64_t bits) {
    return (2 * (static_cast<double>(bits >> 11) / 9007199254740992.0) - 1) * 0.25;
  };
  EXPECT_NEAR(one.x[0][0], 0.5 + displacement(2469588189546311528ull), 1e-15);
  EXPECT_NEAR(one.x[0][1], 1.5 + displacement(2516265689700432462ull), 1e-15);
  EXPECT_EQ(by_spacing(scene, 1).x[0], one.x[0]);
  scene.placement.seed = 2;
  EXPECT_NE(by_spacing(scene, 1).x[0], one.x[0]);
}

TEST(Perturbation, NeverTakesAParticleOutOfTheWaterOrTheDomain) {
  Case scene = channel(0, 1.9, function([](double x, double, double) { return 1.05 - x; }));
  scene.placement.perturbation = 0.49;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    scene.placement.seed = seed;
    const PlacedParticles p = by_spacing(scene, 0.1);
    for (const double x : p.x[0]) {
      ASSERT_GT(x, 0);
      ASSERT_LT(x, 1.05);
    }
  }
}

TEST(PlacementErrors, NoParticleIsOneClearSentence) {
  EXPECT_EQ(error_of([] { by_spacing(channel(0, 1, dam(0, 0, 0)), 0.1); }),
            "no particle results: initial.depth is nowhere above 0 in the domain");
  EXPECT_EQ(error_of([] { by_volume(channel(0, 1, dam(0, 0, 0)), 10); }),
            "no particle results: initial.depth is nowhere above 0 in the domain");
  Case scene = channel(0, 1, dam(0.5, 1, 0));
  scene.placement.inside = function([](double x, double, double) { return x - 0.5; });
  EXPECT_EQ(error_of([&] { by_count(scene, 10); }),
            "no particle results: initial.depth and initial.inside are nowhere both above 0");
  scene.initial.clear();
  scene.placement.inside = function([](double, double, double) { return -1; });
  EXPECT_EQ(error_of([&] { by_spacing(scene, 0.1); }),
            "no particle results: initial.inside is nowhere above 0 in the domain");
  EXPECT_EQ(error_of([] { by_spacing(channel(0, 1, dam(0, 1, 1)), 3); }),
            "no particle results: initial.particles.spacing = 3 m is more than twice the domain");
}

TEST(PlacementErrors, TooManyParticlesAreRefusedBeforeMemoryRunsOut) {
  EXPECT_EQ(error_of([] { by_spacing(channel(0, 1, dam(0, 1, 1)), 1e-10); }),
            "initial.particles.spacing = 1e-10 m gives 10000000000 cells, at most 2147483647 particles are possible");
}

TEST(PlacementErrors, AFunctionWithoutAValueIsNamedWithThePlace) {
  const Function hole = function([](double x, double, double) { return x > 0.5 ? std::nan("") : 1; });
  EXPECT_EQ(error_of([&] { by_spacing(channel(0, 1, hole), 0.5); }),
            "initial.depth must be finite at t = 0, got nan at x = 0.75");
}

// A basin of 1 m by 0.3 m in the vertical plane, with pores where x > 0.5 m.
PlacedParticles in_plane(const PorosityAt& porosity) {
  Case scene;
  scene.dimension = 2;
  scene.upper[0] = 1;
  scene.upper[1] = 0.3;
  scene.placement.mode = Placement::Mode::equal_volume_in_plane;
  scene.placement.spacing = 0.02;
  scene.placement.inside = function([](double, double, double z) { return z < 0.2 ? 1.0 : 0.0; });
  return place(scene, porosity);
}

TEST(EqualVolumeInPlane, StandsFurtherApartInPoresByOneOverTheRootOfThePorosity) {
  const double phi = 0.36;
  const auto half = [=](std::int64_t n, const double* x, const double*, double* out) {
    for (std::int64_t k = 0; k < n; ++k) out[k] = x[k] < 0.5 ? 1 : phi;
  };
  const PlacedParticles found = in_plane(half);
  double water = 0, smallest = 1, largest = 0, in_pores = 0, free = 0;
  for (std::size_t k = 0; k < found.cell_measure.size(); ++k) {
    const double here = (found.x[0][k] < 0.5 ? 1 : phi) * found.cell_measure[k];
    water += here, smallest = std::min(smallest, here), largest = std::max(largest, here);
    (found.x[0][k] < 0.5 ? free : in_pores) += 1;
    EXPECT_LT(found.x[1][k], 0.2);
  }
  EXPECT_NEAR(water, 0.2 * 0.5 * (1 + phi), 1e-12) << "no water is lost or made by rounding";
  EXPECT_NEAR(smallest, 0.0004, 0.08 * 0.0004) << "10 rows become 6: half a row is 8 % of a column";
  EXPECT_NEAR(largest, 0.0004, 0.08 * 0.0004);
  EXPECT_NEAR(in_pores / free, phi, 0.01);
  std::vector<double> x;
  for (const double at : found.x[0]) {
    if (at > 0.55) x.push_back(at);
  }
  std::sort(x.begin(), x.end());
  x.erase(std::unique(x.begin(), x.end()), x.end());
  EXPECT_NEAR(x[1] - x[0], 0.02 / std::sqrt(phi), 0.02 * 0.02) << "columns";
}

TEST(EqualVolumeInPlane, IsTheLatticeOfTheSpacingInFreeWater) {
  const PlacedParticles found = in_plane({});
  ASSERT_EQ(found.cell_measure.size(), 500u);
  for (std::size_t k = 0; k < 500; ++k) {
    EXPECT_NEAR(found.cell_measure[k], 0.0004, 1e-12);
    EXPECT_NEAR(found.x[1][k], 0.02 * (static_cast<double>(k % 10) + 0.5), 1e-9);
  }
}

TEST(EqualVolumeInPlane, CutsIntoRowsWhereThePorosityChangesWithTheHeight) {
  const auto bed = [](std::int64_t n, const double*, const double* z, double* out) {
    for (std::int64_t k = 0; k < n; ++k) out[k] = z[k] < 0.1 ? 0.25 : 1;
  };
  const PlacedParticles found = in_plane(bed);
  double below = 0;
  for (const double z : found.x[1]) below += z < 0.1 ? 1 : 0;
  const double columns = 1 / 0.02;
  EXPECT_NEAR(below, columns / 2 * 2.5, columns / 4 + 1) << "2.5 rows of 25: 2 or 3 of them";
  EXPECT_NEAR(static_cast<double>(found.x[1].size()), 0.125 / 0.0004, 0.02 * 0.125 / 0.0004);
}

}  // namespace
}  // namespace riffle
