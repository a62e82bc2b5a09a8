// Drags of grains against numbers worked out by hand, against the laws that they stand for, and against each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/contract/block_case.hpp"
#include "tests/contract/csv.hpp"

namespace riffle::contract {
namespace {

using Given = std::map<std::string, double>;

struct Place {
  double speed = 0, porosity = 1, z = 0, x = 0, spacing = 1e-9;
};

double rate(const std::string& id, const Given& given, const Place& at, int dim = 2) {
  const riffle_plugin& table = plugin("drag", id);
  const Instance instance(table, dim, given);
  const riffle_pass& pass = *entries(table.passes).at(0);
  BlockCase block(pass, dim, 4);
  const auto reads = entries(pass.reads);
  for (std::size_t k = 0; k < reads.size(); ++k) {
    const std::string field = reads[k]->field->name;
    for (std::size_t c = 0; c < block.read(k).size(); ++c) {
      const bool last = c + 1 == block.read(k).size();
      double value = 0;
      if (field == "porosity") value = at.porosity;
      if (field == "cell_measure") value = std::pow(at.spacing, dim);
      if (field == "position") value = last ? at.z : c == 0 ? at.x : 0;
      if (field == "velocity") value = last ? 0.6 * at.speed : c == 0 ? -0.8 * at.speed : 0;  // downstream is -x here
      std::fill(block.in(k, c).begin(), block.in(k, c).end(), value);
    }
  }
  block.run(instance, 0, 4);
  return block.out(0)[2];
}

// Spheres of 24 mm whose centres lie on the bed: at half their radius the chord is sqrt(3)/2 of the diameter.
TEST(RoughnessLayer, HasTheChordsOfItsSpheres) {
  const Given half{{"roughness_height", 0.012}};  // thin slices: what a difference of areas leaves
  EXPECT_NEAR(rate("roughness-layer", half, {0.3, 1, 0.006}), 0.5 * std::sqrt(0.75) * 0.3 / 0.024, 1e-6);
  EXPECT_NEAR(rate("roughness-layer", half, {0.3, 1, 0.006}, 3), 0.5 * std::sqrt(0.75) * 0.3 / 0.024, 1e-6);
  EXPECT_NEAR(rate("roughness-layer", half, {0.3, 1, 0}), 0.5 * 0.3 / 0.024, 1e-6);
  EXPECT_EQ(rate("roughness-layer", half, {0.3, 1, 0.0121}), 0);
  EXPECT_EQ(rate("roughness-layer", half, {0.3, 1, 0.02}), 0);
  EXPECT_EQ(rate("roughness-layer", half, {0, 1, 0.006}), 0);
  double mean = 0;
  for (int k = 0; k < 1000; ++k) mean += rate("roughness-layer", half, {1, 1, 0.012 * (k + 0.5) / 1000}) / 1000;
  EXPECT_NEAR(2 * 0.024 * mean, 0.785398, 1e-4);  // C_d W_d over half a sphere: the 0.785 of the source
}

// Rows of 2 mm, of which one reaches over the crest: together they have the area of the spheres, wherever the crest is.
TEST(RoughnessLayer, IsAveragedOverTheSpacingOfTheParticles) {
  for (const double crest : {0.0090, 0.0094, 0.0099, 0.0103, 0.012}) {
    double rows = 0, fine = 0;
    for (int k = 0; k < 8; ++k) {
      rows += rate("roughness-layer", {{"roughness_height", crest}}, {1, 1, 0.002 * (k + 0.5), 0, 0.002}) / 8;
    }
    for (int k = 0; k < 4000; ++k) {
      fine += rate("roughness-layer", {{"roughness_height", crest}}, {1, 1, 0.016 * (k + 0.5) / 4000, 0, 4e-6}) / 4000;
    }
    EXPECT_NEAR(rows / fine, 1, 1e-9) << crest;
  }
}

TEST(RoughnessLayer, StandsOnItsBed) {
  const Given raised{{"roughness_height", 0.0103}, {"bed_level", 0.5}, {"drag_coefficient", 0.76}};
  const double from_centre = (0.004 - 0.0103) / 0.012 + 1;
  EXPECT_NEAR(rate("roughness-layer", raised, {0.2, 1, 0.504}),
              0.5 * 0.76 * std::sqrt(1 - from_centre * from_centre) * 0.2 / 0.024, 1e-6);
}

// phi = 1/2, d = 10 mm, nu = 1e-6: 150 * 1e-6 / 1e-4 + 1.75 |u| / 0.01 = 1.5 + 175 |u|
TEST(Ergun, GivesTheRateByHand) {
  EXPECT_NEAR(rate("ergun", {{"grain_diameter", 0.01}}, {0.02, 0.5}), 5, 1e-13);
  EXPECT_NEAR(rate("ergun", {{"grain_diameter", 0.01}}, {0.02, 0.5}, 3), 5, 1e-13);
  EXPECT_NEAR(rate("ergun", {{"grain_diameter", 0.01}}, {0, 0.5}), 1.5, 1e-13);
  EXPECT_EQ(rate("ergun", {{"grain_diameter", 0.01}}, {3, 1}), 0) << "free water has no drag";
}

// Hydraulic gradient i = a U + b U^2 of the filter velocity U = phi u, tabulated for three materials and five laws.
TEST(Ergun, AndVanGentHaveTheHydraulicGradientsTabulated) {
  int tried = 0;
  for (const auto& row : rows("porous_forchheimer_coefficients.csv")) {
    const double phi = std::stod(row[1]), d = std::stod(row[2]), a = std::stod(row[4]), b = std::stod(row[5]);
    std::string id = "van-gent";
    Given given{{"grain_diameter", d}};
    if (row[3] == "Ergun1952") id = "ergun";
    if (row[3] == "Liu1999_a200_b1.1") given["alpha"] = 200;
    if (row[3] == "waves2Foam_Jensen2014_a500_b2.0_KC128")
      given.insert({{"alpha", 500}, {"beta", 2.0}, {"keulegan_carpenter", 128}});
    if (row[3] == "olaFlow_a50_b2.0") given.insert({{"alpha", 50}, {"beta", 2.0}});
    for (const double filter : {0.001, 0.04, 0.2}) {
      const double gradient = rate(id, given, {filter / phi, phi}) * filter / phi / 9.81;
      EXPECT_NEAR(gradient / (a * filter + b * filter * filter), 1, 3e-5) << row[0] << " " << row[3];  // five digits
      ++tried;
    }
  }
  EXPECT_EQ(tried, 45);
}

TEST(DarcyForchheimer, IsErgunsLawWithErgunsPermeability) {
  const double phi = 0.39, d = 0.003, k = d * d * phi * phi * phi / (150 * 0.61 * 0.61);
  const Given given{
      {"permeability", k}, {"form_coefficient", 1.75 / std::sqrt(150 * phi * phi * phi)}, {"porosity", phi}};
  for (const double u : {0.0, 0.01, 0.5}) {
    EXPECT_NEAR(rate("darcy-forchheimer", given, {u, phi}) / rate("ergun", {{"grain_diameter", d}}, {u, phi}), 1,
                1e-12);
  }
  // elsewhere the permeability alone follows Kozeny and Carman: the viscous part stays Ergun's
  EXPECT_NEAR(rate("darcy-forchheimer", given, {0, 0.7}) / rate("ergun", {{"grain_diameter", d}}, {0, 0.7}), 1, 1e-12);
  EXPECT_EQ(rate("darcy-forchheimer", given, {1, 1}), 0);
}

// nu / K = 100, C_F / sqrt K = 5000: lambda = 50 + 1250 |u| at phi = 1/2
TEST(DarcyForchheimer, GivesTheRateByHand) {
  EXPECT_NEAR(
      rate("darcy-forchheimer", {{"permeability", 1e-8}, {"form_coefficient", 0.5}, {"porosity", 0.5}}, {0.1, 0.5}),
      175, 1e-10);
}

// d = 20 mm, phi = 0.22 below the trough at 36.6 mm: 150 (0.78/0.22)^2 1e-6 / 4e-4 + 1.75 (0.78/0.22) |u| / 0.02
TEST(ArmourLayer, IsPackedBelowTheTroughAndLooseAboveIt) {
  const Given bed{{"trough", 0.0366}, {"grain_diameter", 0.02}};
  const double solid = 0.78 / 0.22;
  EXPECT_NEAR(rate("armour-layer", bed, {0.004, 0.22, 0.03}), 150 * solid * solid * 2.5e-3 + 1.75 * solid * 0.2, 1e-12);
  EXPECT_EQ(rate("armour-layer", bed, {0.004, 0.22, 0.0366}), rate("armour-layer", bed, {0.004, 0.22, 0}));
  EXPECT_NEAR(rate("armour-layer", bed, {0.1, 0.6, 0.05}), 0.9 * 0.4 * 0.1 / 0.02, 1e-12);
  EXPECT_EQ(rate("armour-layer", bed, {0.5, 1, 0.1}), 0);
}

TEST(ArmourLayer, MayHaveTheHalfOfTheDragLawBackAndBeginSomewhere) {
  Given bed{{"trough", 0.0366}, {"grain_diameter", 0.02}, {"half", 1}};
  EXPECT_NEAR(rate("armour-layer", bed, {0.1, 0.6, 0.05}), 0.45 * 0.4 * 0.1 / 0.02, 1e-12);
  bed["from_x"] = 2;
  EXPECT_NEAR(rate("armour-layer", bed, {0.1, 0.6, 0.05, 2.1}), 0.9, 1e-12);
  const double ergun = rate("ergun", {{"grain_diameter", 0.02}}, {0.1, 0.6});
  EXPECT_NEAR(rate("armour-layer", bed, {0.1, 0.6, 0.05, 1.9}), ergun, 1e-12);
}

}  // namespace
}  // namespace riffle::contract
