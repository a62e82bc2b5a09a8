// The references of uniform flow, as the host sees them: profiles at points, and what they say of what cannot be.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/contract/loaded.hpp"

namespace riffle::contract {
namespace {

using Given = std::map<std::string, double>;

// Rows: velocity along the bed and across it, pressure, strain rate, eddy viscosity, modelled and virial shear stress.
struct At {
  std::vector<double> value = std::vector<double>(7, -1), scale = std::vector<double>(7, -1);
  bool defined = false;
};

At at(const std::string& id, const Given& given, double z) {
  const Instance instance(plugin("reference", id), 2, given);
  At result;
  std::vector<double*> values, scales;
  for (std::size_t r = 0; r < 7; ++r) {
    values.push_back(&result.value[r]);
    scales.push_back(&result.scale[r]);
  }
  const double x = 0.3;
  const riffle_points points{sizeof(riffle_points), 2, 1, {&x, &z, nullptr}, 0};
  std::uint8_t defined = 2;
  riffle_error error{sizeof(riffle_error), {}};
  if (instance.table().evaluate_reference(instance.self(), &points, values.data(), scales.data(), &defined, &error) !=
      RIFFLE_OK) {
    throw std::runtime_error(error.message);
  }
  result.defined = defined == 1;
  return result;
}

std::string refusal(const std::string& id, const Given& given) {
  try {
    const Instance instance(plugin("reference", id), 2, given);
  } catch (const Refused& refused) {
    return refused.what();
  }
  return "accepted";
}

const Given rough{{"depth", 0.05}, {"slope", 0.004}, {"roughness_height", 0.0103}};
const Given armour{{"bottom", -0.0134}, {"trough", 0.0366},         {"crest", 0.0876},       {"level", 0.184},
                   {"slope", 0.0026},   {"grain_diameter", 0.0136}, {"length_offset", 0.02}, {"kappa_rough", 0.27}};

Given with(Given given, const Given& others) {
  for (const auto& [name, value] : others) given[name] = value;
  return given;
}
Given without(Given given, const std::string& name) {
  given.erase(name);
  return given;
}

TEST(UniformFlowColumn, GivesStressAndPressureThatCarryTheWater) {
  for (const double z : {0.0103, 0.02, 0.03, 0.049}) {
    const At p = at("uniform-flow-column", rough, z);
    EXPECT_TRUE(p.defined);
    EXPECT_NEAR(p.value[5] / (9810 * 0.004 * (0.05 - z)), 1, 1e-9) << z;
    EXPECT_NEAR(p.value[2], 9810 * std::sqrt(1 - 0.004 * 0.004) * (0.05 - z), 1e-9);
    EXPECT_EQ(p.value[1], 0);
    EXPECT_EQ(p.value[6], 0);
    EXPECT_EQ(p.scale[6], p.scale[5]);
    EXPECT_NEAR(p.value[5], 1000 * (1e-6 + p.value[4]) * p.value[3], 2e-3 * p.scale[5]);  // between faces
  }
  EXPECT_FALSE(at("uniform-flow-column", rough, 0.0501).defined);
  EXPECT_FALSE(at("uniform-flow-column", rough, -0.0001).defined);
  EXPECT_EQ(at("uniform-flow-column", rough, 0).value[0], 0);
}

TEST(UniformFlowColumn, ReadsTheDepthEitherWay) {
  const At above_crest = at("uniform-flow-column", with(rough, {{"depth_above", 1}}), 0.06);
  const At same = at("uniform-flow-column", with(rough, {{"depth", 0.0603}}), 0.06);
  EXPECT_DOUBLE_EQ(above_crest.value[0], same.value[0]);
}

TEST(UniformFlowColumn, StandsOnItsBedWhereverThatIs) {
  const At low = at("uniform-flow-column", rough, 0.03);
  const At high = at("uniform-flow-column", with(rough, {{"bed_level", 1}}), 1.03);
  for (std::size_t r = 0; r < 7; ++r) EXPECT_NEAR(high.value[r], low.value[r], 1e-9 * (1 + std::abs(low.value[r])));
}

TEST(UniformFlowColumn, SaysWhatIsWrong) {
  EXPECT_EQ(refusal("uniform-flow-column", {{"slope", 0.004}}),
            "channel: of discharge, depth and slope two must be given");
  EXPECT_EQ(refusal("uniform-flow-column", with(rough, {{"discharge", 0.0122}})),
            "channel: discharge, depth and slope are all given; give two. With this bed: (depth, slope) -> discharge = "
            "0.0122 m2/s; (discharge, slope) -> depth = 0.05001 m; (discharge, depth) -> slope = 0.004003");
  EXPECT_EQ(
      refusal("uniform-flow-column", with(rough, {{"roughness_height", 0.06}})),
      "depth: 0.05 m of water above the numerical bed do not cover the roughness layer of 0.06 m; the depth must be "
      "larger, or roughness_height smaller");
  EXPECT_EQ(refusal("uniform-flow-column", with(rough, {{"slope", 0}})),
            "slope must be above 0 for a channel that gravity drives");
}

TEST(UniformFlowColumn, HasNothingToCompareWithWhenNothingIsGiven) {
  EXPECT_FALSE(at("uniform-flow-column", {}, 0.01).defined);
}

TEST(ArmourBedColumn, GivesTheFlowInAndOverTheBed) {
  EXPECT_NEAR(at("armour-bed-column", armour, 0.0116).value[0], 0.00227, 5e-6);
  EXPECT_NEAR(at("armour-bed-column", armour, 0.0876).value[0], 0.2700, 2e-4);
  EXPECT_NEAR(at("armour-bed-column", armour, 0.1).value[5] / (9810 * 0.0026 * 0.084), 1, 1e-9);
  EXPECT_NEAR(at("armour-bed-column", armour, 0.1).scale[0], 0.4033, 4e-4);
}

TEST(ArmourBedColumn, TakesAFlowRateWithAWidth) {
  const Given by_rate = with(without(armour, "slope"), {{"flow_rate", 0.06}, {"width", 0.9}});
  const At a = at("armour-bed-column", by_rate, 0.1);
  const At b = at("armour-bed-column", with(without(armour, "slope"), {{"discharge", 0.06 / 0.9}}), 0.1);
  EXPECT_DOUBLE_EQ(a.value[0], b.value[0]);
  EXPECT_EQ(refusal("armour-bed-column", without(by_rate, "width")),
            "flow_rate needs the width of the channel (or give discharge, in m2/s)");
}

TEST(ArmourBedColumn, SaysWhatIsWrong) {
  const auto said = [](const Given& changed) { return refusal("armour-bed-column", with(armour, changed)); };
  EXPECT_EQ(said({{"discharge", 0.0666667}}),
            "channel: discharge, level and slope are all given; give two. With this bed: (level, slope) -> discharge = "
            "0.04372 m2/s; (discharge, slope) -> level = 0.2133 m; (discharge, level) -> slope = 0.006039");
  EXPECT_EQ(said({{"trough", 0.0876}, {"crest", 0.0366}}),
            "levels: need bottom < trough < crest, got bottom = -0.0134 m, trough = 0.0876 m, crest = 0.0366 m");
  EXPECT_EQ(
      said({{"level", 0.06}}),
      "level: the water at 0.06 m must stand above the crest at 0.0876 m, below which the mixing length (eq. 6.7) is "
      "not defined");
  EXPECT_EQ(
      said({{"middle", 0.04}}),
      "middle of 0.04 m is outside [0.04935, 0.07485] m: the ramp of the porosity would leave the roughness layer");
  EXPECT_EQ(said({{"grain_diameter", 13.6}}),
            "grain_diameter of 13.6 m is larger than the roughness layer of 0.051 m: millimetres?");
  EXPECT_EQ(said({{"length_offset", 0.06}}),
            "length_offset: the mixing length would begin to grow at 0.0966 m, above the crest at 0.0876 m");
  EXPECT_EQ(refusal("armour-bed-column", with(without(armour, "level"), {{"discharge", 1e-7}})),
            "the bed alone carries more than this discharge: no level above its crest");
}

}  // namespace
}  // namespace riffle::contract
