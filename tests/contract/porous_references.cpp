// References of water in pores, point by point in the vertical plane.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "tests/contract/csv.hpp"
#include "tests/contract/loaded.hpp"

namespace riffle::contract {
namespace {

using Given = std::map<std::string, double>;

// Rows: velocity along x and z, and what follows. Scales behind.
struct Answer {
  std::vector<double> value = std::vector<double>(4, -1), scale = std::vector<double>(4, -1);
  bool defined = false;
};

Answer at(const std::string& id, const Given& given, double x, double z) {
  const Instance instance(plugin("reference", id), 2, given);
  Answer result;
  std::vector<double*> values, scales;
  for (std::size_t r = 0; r < 4; ++r) {
    values.push_back(&result.value[r]);
    scales.push_back(&result.scale[r]);
  }
  const riffle_points points{sizeof(riffle_points), 2, 1, {&x, &z, nullptr}, 3};
  std::uint8_t defined = 2;
  riffle_error error{sizeof(riffle_error), {}};
  if (instance.table().evaluate_reference(instance.self(), &points, values.data(), scales.data(), &defined, &error) !=
      RIFFLE_OK) {
    throw std::runtime_error(error.message);
  }
  result.defined = defined == 1;
  return result;
}

TEST(DupuitForchheimer, HasTheLevelsAndDischargesTabulated) {
  std::set<std::string> tried;
  for (const auto& row : rows("porous_steady_seepage_dupuit_forchheimer.csv")) {
    if (row[1] == "waves2Foam_Jensen2014_a500_b2.0_KC128") continue;  // KC: beta of the other laws times 1.0586
    const bool rock = row[0] == "crushed_rock_Liu1999";
    Given given{{"length", 0.29},
                {"depth_upstream", std::stod(row[2])},
                {"depth_downstream", std::stod(row[3])},
                {"grain_diameter", rock ? 0.0159 : 0.003},
                {"porosity", rock ? 0.49 : 0.39}};
    if (row[1] == "vanGent1995_a1000_b1.1_noKC") given.insert({{"c1", 1000}, {"c2", 1.1}});
    if (row[1] == "Liu1999_a200_b1.1") given.insert({{"c1", 200}, {"c2", 1.1}});
    if (row[1] == "olaFlow_a50_b2.0") given.insert({{"c1", 50}, {"c2", 2.0}});
    const double q = std::stod(row[4]), x = std::stod(row[5]), h = std::stod(row[6]), phi = given.at("porosity");
    const Answer p = at("dupuit-forchheimer", given, x, 0.01);
    EXPECT_NEAR(p.value[3], h, 6e-5 * 8) << row[0] << " " << row[1] << " at " << x;  // x has four digits, dh/dx up to 8
    EXPECT_NEAR(p.value[0] * phi * p.value[3], q, 6e-7) << row[0] << " " << row[1];
    EXPECT_NEAR(p.value[2], 9810 * (p.value[3] - 0.01), 1e-9);
    tried.insert(row[0] + row[1]);
  }
  EXPECT_EQ(tried.size(), 8u);
}

TEST(DupuitForchheimer, ComparesInTheWaterOfTheBlockAlone) {
  const Given given{{"position", 0.3},          {"length", 0.29},   {"depth_upstream", 0.14},
                    {"depth_downstream", 0.06}, {"porosity", 0.49}, {"grain_diameter", 0.0159}};
  EXPECT_TRUE(at("dupuit-forchheimer", given, 0.31, 0.1).defined);
  EXPECT_FALSE(at("dupuit-forchheimer", given, 0.31, 0.14).defined);
  EXPECT_FALSE(at("dupuit-forchheimer", given, 0.29, 0.1).defined);
  EXPECT_FALSE(at("dupuit-forchheimer", given, 0.6, 0.01).defined);
  const Answer low = at("dupuit-forchheimer", given, 0.4, 0);
  const Answer high = at("dupuit-forchheimer", given, 0.4, low.value[3] - 1e-12);
  EXPECT_EQ(low.value[1], 0) << "nothing flows through the bottom";
  const double dx = 1e-5, slope = (at("dupuit-forchheimer", given, 0.4 + dx, 0).value[3] -
                                   at("dupuit-forchheimer", given, 0.4 - dx, 0).value[3]) /
                                  (2 * dx);
  EXPECT_NEAR(high.value[1] / high.value[0], slope, 1e-6) << "the surface is a stream line";
}

TEST(DarcyForchheimerColumn, RunsAsErgunsLawSaysAlongEitherAxis) {
  const Given rock{{"gradient", 0.1}, {"porosity", 0.49}, {"grain_diameter", 0.0159}};
  const Answer along = at("darcy-forchheimer-column", rock, 0.3, 0.2);
  EXPECT_NEAR(along.value[0], 0.08978, 5e-6);
  EXPECT_EQ(along.value[1], 0);
  EXPECT_NEAR(along.scale[0], along.value[0], 1e-9);
  Given upwards = rock;
  upwards["axis"] = 1;
  EXPECT_EQ(at("darcy-forchheimer-column", upwards, 0.3, 0.2).value[1], along.value[0]);
}

TEST(DarcyForchheimerColumn, TakesAPermeabilityAsWell) {
  const double phi = 0.39, d = 0.003, k = d * d * phi * phi * phi / (150 * 0.61 * 0.61);
  const Given beads{{"gradient", 0.1},   {"porosity", phi},
                    {"law", 1},          {"reference_porosity", phi},
                    {"permeability", k}, {"form_coefficient", 1.75 / std::sqrt(150 * phi * phi * phi)}};
  EXPECT_NEAR(at("darcy-forchheimer-column", beads, 0.3, 0.2).value[0], 0.01734, 5e-6);
}

TEST(DarcyForchheimerColumn, RefusesFreeWater) {
  EXPECT_THROW(at("darcy-forchheimer-column", {{"gradient", 0.1}, {"porosity", 1}}, 0, 0), Refused);
  EXPECT_THROW(at("darcy-forchheimer-column", {{"gradient", 0.1}, {"porosity", 0}}, 0, 0), Refused);
}

TEST(Hydrostatic, CarriesTheWaterAbove) {
  const Answer stiff = at("hydrostatic", {{"level", 0.15}}, 0.4, 0.05);
  EXPECT_TRUE(stiff.defined);
  EXPECT_NEAR(stiff.value[2], 981, 1e-10);
  EXPECT_EQ(stiff.value[3], 1000);
  EXPECT_NEAR(stiff.scale[2], 1471.5, 1e-10);
  EXPECT_FALSE(at("hydrostatic", {{"level", 0.15}}, 0.4, 0.151).defined);
}

TEST(Hydrostatic, YieldsWithTheSpeedOfSound) {
  const Given soft{{"level", 0.15}, {"sound_speed", 12.1}};
  const double dz = 1e-4, c2 = 12.1 * 12.1;
  const Answer p = at("hydrostatic", soft, 0.4, 0.05);
  const double above = at("hydrostatic", soft, 0.4, 0.05 + dz).value[2],
               below = at("hydrostatic", soft, 0.4, 0.05 - dz).value[2];
  EXPECT_NEAR((below - above) / (2 * dz) / (9.81 * p.value[3]), 1, 1e-9) << "dp/dz = - rho g";
  EXPECT_NEAR(p.value[2], c2 * (p.value[3] - 1000), 1e-6);
  EXPECT_NEAR(p.value[2] / 981, 1 + 0.5 * 0.981 / c2, 1e-5);
}

}  // namespace
}  // namespace riffle::contract
