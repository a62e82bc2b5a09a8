// Eddy viscosities against numbers worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/contract/block_case.hpp"

namespace riffle::contract {
namespace {

using Given = std::map<std::string, double>;
enum Profile { nezu_rodi, prandtl, three_layer, table };

// nu_t at |S| = 10 1/s and a height above the bed, in water of a depth [m]; reads are filled by the names of their fields.
double eddy_viscosity(const std::string& id, const Given& given, double height, double depth, int dim = 2) {
  const riffle_plugin& plugin_table = plugin("turbulence", id);
  const Instance instance(plugin_table, dim, given);
  const auto passes = entries(plugin_table.passes);
  const bool levels = given.count("heights") != 0 && given.at("heights") == 1;
  const riffle_pass& pass = *passes.at(levels ? 1 : 0);
  BlockCase block(pass, dim, 4);
  const auto reads = entries(pass.reads);
  for (std::size_t k = 0; k < reads.size(); ++k) {
    const std::string field = reads[k]->field->name;
    for (std::size_t c = 0; c < block.read(k).size(); ++c) {
      const double value = field == "strain_rate"          ? 10
                           : field == "wall_distance"      ? height
                           : field == "local_depth"        ? depth
                           : field == "cell_measure"       ? std::pow(0.002, dim)
                           : c + 1 == block.read(k).size() ? height
                                                           : 0.7;
      std::fill(block.in(k, c).begin(), block.in(k, c).end(), value);
    }
  }
  block.run(instance, 0, 4);
  return block.out(0)[3];
}

TEST(Smagorinsky, TakesTheSpacingOrTheWidthGiven) {
  EXPECT_DOUBLE_EQ(eddy_viscosity("smagorinsky", {}, 0, 0), 0.15 * 0.15 * 4e-6 * 10);
  EXPECT_DOUBLE_EQ(eddy_viscosity("smagorinsky", {}, 0, 0, 3), 0.15 * 0.15 * 4e-6 * 10);
  EXPECT_DOUBLE_EQ(eddy_viscosity("smagorinsky", {{"coefficient", 0.1}, {"filter_width", 0.02}}, 0, 0), 4e-6 * 10);
}

// kappa z sqrt(1 - z/H) with z = 0.03, H = 0.04: 0.4 * 0.03 * 0.5 = 6 mm
TEST(MixingLength, IsThatOfNezuAndRodiWithoutWake) {
  EXPECT_NEAR(eddy_viscosity("mixing-length", {{"kappa", 0.4}}, 0.03, 0.04), 3.6e-4, 1e-18);
  EXPECT_NEAR(eddy_viscosity("mixing-length", {{"kappa", 0.4}}, 0.03, 0.04, 3), 3.6e-4, 1e-18);
}

TEST(MixingLength, ShrinksInAWake) {  // at xi = 1/2: 1 + pi Pi xi sin(pi / 2) = 1 + 0.5 pi Pi
  const double bare = 0.4 * 0.02 * std::sqrt(0.5), wake = bare / (1 + 0.1 * 3.14159265358979);
  EXPECT_NEAR(eddy_viscosity("mixing-length", {{"kappa", 0.4}, {"coles", 0.2}}, 0.02, 0.04) / (10 * wake * wake), 1,
              1e-12);
}

TEST(MixingLength, GrowsToTheSurfaceAfterPrandtl) {
  EXPECT_NEAR(eddy_viscosity("mixing-length", {{"profile", prandtl}, {"kappa", 0.4}}, 0.04, 0.04), 0.00256, 1e-17);
}

TEST(MixingLength, IsDampedAfterVanDriest) {  // z+ = 0.03 * 0.0026 / 1e-6 = 78 = 3 A+
  const Given damped{{"kappa", 0.4}, {"damping", 1}, {"shear_velocity", 0.0026}};
  const double l = 0.006 * (1 - std::exp(-3));
  EXPECT_NEAR(eddy_viscosity("mixing-length", damped, 0.03, 0.04) / (10 * l * l), 1, 1e-12);
}

// Bed B1 of Table 6-3: z_0 = 56.6 mm; 2 mm below it, 2 + 0.27 * 31 = 10.37 mm at the crest
TEST(MixingLength, HasThreeLayersOverAPorousBed) {
  const Given b1{{"profile", three_layer}, {"trough", 0.0366}, {"crest", 0.0876}, {"length_offset", 0.02}};
  const auto length = [&](double z) { return std::sqrt(eddy_viscosity("mixing-length", b1, z, 0.184) / 10); };
  EXPECT_NEAR(length(0.01), 0.002, 1e-12);
  EXPECT_NEAR(length(0.0666), 0.0047, 1e-12);
  EXPECT_NEAR(length(0.0876), 0.01037, 1e-12);
  EXPECT_NEAR(length(0.1358), 0.01037 + 0.22 * 0.0482 * std::sqrt(0.5), 1e-12);  // half way up H_c = 96.4 mm
  EXPECT_NEAR(length(0.184), 0.01037, 1e-12);
}

TEST(MixingLength, TakesALengthFromATable) {
  EXPECT_NEAR(eddy_viscosity("mixing-length", {{"profile", table}, {"length", 0.003}}, 0.02, 0.04), 9e-5, 1e-18);
}

TEST(MixingLength, IsTheSameByLevelsAsByFields) {
  const Given levels{{"heights", 1}, {"bed_level", 1}, {"depth", 0.04}, {"kappa", 0.4}};
  EXPECT_NEAR(eddy_viscosity("mixing-length", levels, 1.03, -1), 3.6e-4, 1e-15);
  const Given b1{{"profile", three_layer}, {"trough", 1.0366}, {"crest", 1.0876}, {"length_offset", 0.02},
                 {"heights", 1},           {"bed_level", 1},   {"depth", 0.184}};
  EXPECT_NEAR(std::sqrt(eddy_viscosity("mixing-length", b1, 1.0666, -1) / 10), 0.0047, 1e-12);
}

TEST(MixingLength, IsNothingInTheBedAndAboveTheWater) {
  for (const double profile : {nezu_rodi, prandtl}) {
    EXPECT_EQ(eddy_viscosity("mixing-length", {{"profile", profile}}, -0.001, 0.04), 0);
    EXPECT_EQ(eddy_viscosity("mixing-length", {{"profile", profile}}, 0.02, 0), 0);
  }
  EXPECT_EQ(eddy_viscosity("mixing-length", {}, 0.041, 0.04), 0);
  EXPECT_EQ(eddy_viscosity("mixing-length", {}, INFINITY, 0.04), 0);  // no wall at all
}

TEST(MixingLength, SaysWhatItNeeds) {
  const auto refused = [](const Given& given) {
    try {
      const Instance instance(plugin("turbulence", "mixing-length"), 2, given);
    } catch (const Refused& refusal) {
      return std::string(refusal.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refused({{"heights", 1}}), "heights = \"levels\" needs the depth of the water above bed_level, got 0 m");
  EXPECT_EQ(refused({{"damping", 1}}), "damping = \"van-driest\" needs a shear_velocity and a viscosity above 0");
  EXPECT_EQ(refused({{"profile", three_layer}, {"trough", 0.1}, {"crest", 0.05}}),
            "profile = \"three-layer\" needs trough + length_offset below crest");
  EXPECT_EQ(refused({{"profile", table}}), "profile = \"table\" needs the function length");
}

}  // namespace
}  // namespace riffle::contract
