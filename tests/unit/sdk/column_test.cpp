// Uniform flow as a column: against tables of the twelve rough beds and the twelve armour beds that an independent solver
// made (400 cells, pseudo-time), and against what holds for any column.
#include "riffle/column.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "riffle/armour_bed.hpp"

namespace riffle::test::column {
namespace {

constexpr double g = 9.81;

struct RoughBed {
  const char* id;
  double slope, depth, relative_roughness;                  // Kazemi (2017), Tables 3-1 and 3-2
  double mean, mean_above_crest;                            // m/s: depth above the numerical bed
  double mean_deep, mean_above_crest_deep, discharge_deep;  // depth above the crest
};
const RoughBed rough_beds[] = {{"S004H40", 0.004, 0.04, 0.285, 0.182, 0.218, 0.232, 0.268, 0.0119},
                               {"S004H50", 0.004, 0.05, 0.206, 0.244, 0.279, 0.289, 0.323, 0.01743},
                               {"S004H70", 0.004, 0.07, 0.144, 0.334, 0.369, 0.376, 0.409, 0.0301},
                               {"S004H90", 0.004, 0.09, 0.104, 0.434, 0.466, 0.470, 0.502, 0.0467},
                               {"S004H100", 0.004, 0.1, 0.094, 0.472, 0.503, 0.507, 0.538, 0.0555},
                               {"S003H50", 0.003, 0.05, 0.202, 0.214, 0.244, 0.253, 0.282, 0.0152},
                               {"S003H60", 0.003, 0.06, 0.156, 0.266, 0.294, 0.301, 0.330, 0.0209},
                               {"S003H70", 0.003, 0.07, 0.135, 0.302, 0.330, 0.336, 0.364, 0.0267},
                               {"S003H80", 0.003, 0.08, 0.116, 0.342, 0.369, 0.375, 0.402, 0.0334},
                               {"S002H60", 0.002, 0.06, 0.172, 0.203, 0.227, 0.233, 0.258, 0.0164},
                               {"S002H70", 0.002, 0.07, 0.137, 0.244, 0.267, 0.272, 0.295, 0.0216},
                               {"S002H80", 0.002, 0.08, 0.113, 0.283, 0.306, 0.309, 0.332, 0.0276}};

Column rough_column(double roughness, double diameter = 0.024, double kappa = 0.41, int cells = 400) {
  Column c;
  c.cells = cells;
  c.interfaces = {roughness};
  c.quadratic_drag = [=](double z) { return porous_drag::spheres(z, roughness, diameter, 1).quadratic; };
  c.mixing_length = [=](double z, double level) { return mixing_length::nezu_rodi(z, level, kappa); };
  return c;
}

struct ArmourCase {
  const char* id;
  double level;                                                    // m: Table 6-2
  double discharge, mean, surface, crest, middle, trough, in_bed;  // m2/s, m/s
};
const ArmourCase armour_cases[] = {{"B1-Q60", 0.184, 0.04372, 0.4033, 0.4790, 0.2700, 0.0910, 0.0076, 0.00227},
                                   {"B1-Q90", 0.217, 0.06990, 0.4979, 0.6025, 0.3069, 0.1021, 0.0075, 0.00227},
                                   {"B1-Q120", 0.248, 0.09969, 0.5842, 0.7147, 0.3378, 0.1115, 0.0075, 0.00227},
                                   {"B1-Q150", 0.271, 0.12495, 0.6466, 0.7958, 0.3591, 0.1180, 0.0075, 0.00227},
                                   {"B1-Q180", 0.296, 0.15535, 0.7132, 0.8818, 0.3808, 0.1247, 0.0075, 0.00227},
                                   {"B2-Q60", 0.166, 0.04449, 0.3903, 0.4548, 0.2805, 0.0984, 0.0115, 0.00437},
                                   {"B2-Q90", 0.200, 0.07023, 0.4800, 0.5720, 0.3179, 0.1096, 0.0115, 0.00437},
                                   {"B2-Q120", 0.230, 0.09762, 0.5573, 0.6731, 0.3476, 0.1186, 0.0115, 0.00437},
                                   {"B2-Q150", 0.256, 0.12483, 0.6230, 0.7589, 0.3714, 0.1259, 0.0115, 0.00437},
                                   {"B2-Q180", 0.279, 0.15152, 0.6801, 0.8335, 0.3913, 0.1320, 0.0116, 0.00437},
                                   {"B2-Q220", 0.306, 0.18591, 0.7461, 0.9193, 0.4133, 0.1388, 0.0116, 0.00437},
                                   {"B2-Q250", 0.330, 0.21921, 0.8038, 0.9943, 0.4320, 0.1446, 0.0116, 0.00437}};

double slope_of(const ArmourCase& c) {
  return c.id[1] == '1' ? 0.0026 : 0.0028;
}
ArmourBed bed_of(const ArmourCase& c) {
  ArmourBed bed;
  const bool first = c.id[1] == '1';
  bed.trough = first ? 0.0366 : -0.0055;
  bed.crest = first ? 0.0876 : 0.0715;
  bed.bottom = bed.trough - 0.05;
  bed.middle = 0.5 * (bed.trough + bed.crest);
  bed.diameter = first ? 0.0136 : 0.0196;
  bed.offset = first ? 0.02 : 0;
  bed.kappa_rough = first ? 0.27 : 0.15;
  return bed;
}

TEST(RoughBedColumn, HasTheVelocitiesTabulatedWithBothReadingsOfTheDepth) {
  for (const RoughBed& c : rough_beds) {
    const double rough = c.relative_roughness * c.depth;
    const Column column = rough_column(rough);
    const ColumnFlow flow = ColumnFlow::of_slope(column, c.depth, c.slope);
    EXPECT_NEAR(flow.mean_velocity(0, c.depth), c.mean, 1.1e-3) << c.id;  // the table has three digits, 400 cells
    EXPECT_NEAR(flow.mean_velocity(rough, c.depth), c.mean_above_crest, 1.1e-3) << c.id;
    const ColumnFlow deep = ColumnFlow::of_slope(column, c.depth + rough, c.slope);
    EXPECT_NEAR(deep.mean_velocity(0, c.depth + rough), c.mean_deep, 1.1e-3) << c.id;
    EXPECT_NEAR(deep.mean_velocity(rough, c.depth + rough), c.mean_above_crest_deep, 1.1e-3) << c.id;
    EXPECT_NEAR(deep.discharge() / c.discharge_deep, 1, 5e-3) << c.id;
  }
}

TEST(RoughBedColumn, SharesTheWeightOfTheWaterBetweenWallAndSpheresAsTabulated) {
  const ColumnFlow flow = ColumnFlow::of_slope(rough_column(0.0103), 0.05, 0.004);
  const double weight = g * 0.004 * 0.05;
  EXPECT_NEAR(flow.stress(0.0103) / weight, 0.794, 1e-3);
  EXPECT_NEAR(flow.stress(0) / weight, 0.067, 1e-3);
  EXPECT_NEAR(flow.drag_below(0.05) / weight, 0.933, 1e-3);
  EXPECT_NEAR(flow.stress(0) + flow.drag_below(0.05), weight, 1e-13 * weight);
}

TEST(RoughBedColumn, FeelsRoughnessAndKappaAsTabulated) {
  const auto mean = [](double roughness, double kappa) {
    return ColumnFlow::of_slope(rough_column(roughness, 0.024, kappa), 0.05, 0.004).discharge() / 0.05;
  };
  EXPECT_NEAR(mean(0.1 * 0.05, 0.41), 0.387, 1e-3);
  EXPECT_NEAR(mean(0.15 * 0.05, 0.41), 0.304, 1e-3);
  EXPECT_NEAR(mean(0.4 * 0.05, 0.41), 0.137, 1e-3);
  EXPECT_NEAR(mean(0.0103, 0.3), 0.288, 1e-3);
  EXPECT_NEAR(mean(0.0103, 0.45), 0.233, 1e-3);
}

TEST(ArmourBedColumn, HasDischargeAndVelocitiesOfTheTwelveCasesTabulated) {
  for (const ArmourCase& c : armour_cases) {
    const ArmourBed bed = bed_of(c);
    const ColumnFlow flow = ColumnFlow::of_slope(bed.column(), c.level, slope_of(c));
    EXPECT_NEAR(flow.discharge() / c.discharge, 1, 1e-3) << c.id;
    EXPECT_NEAR(flow.mean_velocity(bed.crest, c.level) / c.mean, 1, 1e-3) << c.id;
    EXPECT_NEAR(flow.velocity(c.level) / c.surface, 1, 1e-3) << c.id;
    EXPECT_NEAR(flow.velocity(bed.crest) / c.crest, 1, 1e-3) << c.id;
    EXPECT_NEAR(flow.velocity(bed.middle), c.middle, 1e-4) << c.id;
    EXPECT_NEAR(flow.velocity(bed.trough), c.trough, 2e-4) << c.id;  // thin: two cells, and two digits in the table
    EXPECT_NEAR(flow.velocity(bed.bottom + 0.02), c.in_bed, 5e-6) << c.id;
    EXPECT_NEAR(flow.velocity(bed.bottom + 0.02) / bed.velocity_in_bed(slope_of(c)), 1, 1e-4) << c.id;
  }
}

TEST(ArmourBedColumn, CarriesExactlyTheWeightOfTheWaterAboveTheCrest) {
  for (const ArmourCase& c : armour_cases) {
    const ArmourBed bed = bed_of(c);
    const ColumnFlow flow = ColumnFlow::of_slope(bed.column(), c.level, slope_of(c));
    EXPECT_LE(flow.imbalance(), 1e-10) << c.id;
    for (const double z : {bed.crest, bed.crest + 0.01, 0.5 * (bed.crest + c.level)}) {
      EXPECT_NEAR(flow.stress(z) / (g * slope_of(c) * (c.level - z)), 1, 1e-10) << c.id;
    }
  }
}

TEST(ArmourBedColumn, FindsSlopeAndLevelAgain) {
  for (const ArmourCase& c : armour_cases) {
    const Column column = bed_of(c).column();
    const double q = ColumnFlow::of_slope(column, c.level, slope_of(c)).discharge();
    const ColumnFlow by_discharge = ColumnFlow::of_discharge(column, c.level, q);
    EXPECT_NEAR(by_discharge.slope() / slope_of(c), 1, 1e-8) << c.id;
    EXPECT_NEAR(by_discharge.discharge() / q, 1, 1e-12) << c.id;
    EXPECT_NEAR(ColumnFlow::of_slope_and_discharge(column, slope_of(c), q).level(), c.level, 1e-8) << c.id;
  }
}

TEST(ArmourBedColumn, NeedsTheSlopeAndTheLevelTabulatedForTheMeasuredDischarge) {
  const double slopes[] = {0.00604, 0.00532, 0.00465, 0.00462, 0.00431, 0.00628,
                           0.00567, 0.00522, 0.00499, 0.00488, 0.00484, 0.00450};
  const double levels[] = {213.3, 248.3, 278.2, 304.7, 329.0, 195.7, 232.4, 263.6, 291.2, 316.4, 347.1, 368.5};
  const double rates[] = {60, 90, 120, 150, 180, 60, 90, 120, 150, 180, 220, 250};  // l/s in a flume of 0.9 m
  for (std::size_t k = 0; k < 12; ++k) {
    const ArmourCase& c = armour_cases[k];
    const Column column = bed_of(c).column();
    const double q = rates[k] / 900;
    EXPECT_NEAR(ColumnFlow::of_discharge(column, c.level, q).slope(), slopes[k], 1e-5) << c.id;
    EXPECT_NEAR(1000 * ColumnFlow::of_slope_and_discharge(column, slope_of(c), q).level(), levels[k], 0.1) << c.id;
  }
}

TEST(ArmourBedColumn, HasThePorosityThatTheLayerHolds) {
  for (const double at : {0.25, 0.4, 0.5, 0.75}) {  // of the layer, where the middle of the ramp is
    ArmourBed bed = bed_of(armour_cases[0]);
    bed.middle = bed.trough + at * (bed.crest - bed.trough);
    EXPECT_NEAR(bed.porosity_at(bed.trough + 1e-12), 0.22, 1e-10);  // a ramp that begins there rises by 3e-11
    EXPECT_NEAR(bed.porosity_at(bed.crest - 1e-12), 1, 1e-10);
    double solid = 0;
    const int n = 4000;
    for (int k = 0; k < n; ++k) {
      const double z = bed.trough + (bed.crest - bed.trough) * (k + 0.5) / n;
      solid += (1 - bed.porosity_at(z)) * (bed.crest - bed.trough) / n;
    }
    // The splines have variances h^2 / 3; where their reaches differ, so do the grains that they move up and down.
    const double h_t = 0.5 * (bed.middle - bed.half_ramp() - bed.trough);
    const double h_c = 0.5 * (bed.crest - bed.middle - bed.half_ramp()), ramp = 2 * bed.half_ramp();
    EXPECT_NEAR(solid, 0.78 * (bed.middle - bed.trough + (h_c * h_c - h_t * h_t) / (6 * ramp)), 1e-8);
  }
}

TEST(Column, ConvergesWithSecondOrder) {
  const ArmourBed bed = bed_of(armour_cases[11]);
  const double level = armour_cases[11].level;
  const auto q = [&bed, level](int cells) {
    return ColumnFlow::of_slope(bed.column(cells), level, 0.0028).discharge();
  };
  const double fine = q(3200), first = fine - q(100), second = fine - q(200), third = fine - q(400);
  EXPECT_LT(std::abs(first / fine), 1.5e-3);
  EXPECT_NEAR(first / second, 4, 1);
  EXPECT_NEAR(second / third, 4, 1);
}

TEST(Column, OfViscosityAloneIsTheParabolaOfNusselt) {
  Column c;
  c.viscosity = 1e-3;
  c.cells = 40;
  const ColumnFlow flow = ColumnFlow::of_slope(c, 0.1, 0.01);
  EXPECT_NEAR(flow.discharge() / (g * 0.01 * 1e-3 / (3 * 1e-3)), 1, 1e-3);  // 1/(4 n^2) with 40 cells
  EXPECT_NEAR(flow.velocity(0.1) / (g * 0.01 * 0.01 / (2 * 1e-3)), 1, 1e-3);
}

// Grains, slopes and depths over several powers of ten; parts of the column may be orders thinner than others.
TEST(Column, IsFoundWhateverTheBedIs) {
  std::mt19937_64 random(3);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, std::uniform_real_distribution<double>(0, 1)(random));
  };
  for (int k = 0; k < 3000; ++k) {
    ArmourBed bed;
    bed.trough = between(1e-3, 1);
    bed.crest = bed.trough + between(1e-3, 0.5);
    bed.middle = 0.5 * (bed.trough + bed.crest);
    bed.diameter = between(1e-4, 0.1);
    bed.porosity = between(0.05, 0.95);
    bed.drag_coefficient = between(0.01, 10);
    bed.in_bed = between(1e-6, 0.02);
    bed.kappa_rough = between(0.01, 1);
    bed.kappa_free = between(0.01, 1);
    bed.viscosity = between(1e-9, 1e-4);
    const double level = bed.crest + between(1e-3, 5), slope = between(1e-6, 0.3);
    const ColumnFlow flow = ColumnFlow::of_slope(bed.column(60), level, slope);
    EXPECT_LE(flow.imbalance(), 1e-10) << k;
    EXPECT_LE(flow.iterations(), 40) << k;
    EXPECT_NEAR(ColumnFlow::of_discharge(bed.column(60), level, flow.discharge()).slope() / slope, 1, 1e-8) << k;
  }
}

TEST(Column, RefusesWhatIsNoFlow) {
  const Column c = rough_column(0.01);
  EXPECT_THROW((void)ColumnFlow::of_slope(c, 0.01, 0.004), std::invalid_argument);
  EXPECT_THROW((void)ColumnFlow::of_slope(c, 0.05, 0), std::invalid_argument);
  EXPECT_THROW((void)ColumnFlow::of_discharge(c, 0.05, -1), std::invalid_argument);
  EXPECT_THROW((void)ColumnFlow::of_slope_and_discharge(c, 0.004, 1e-9), std::invalid_argument);
  Column solid = c;
  solid.porosity = [](double) { return 0.0; };
  EXPECT_THROW((void)ColumnFlow::of_slope(solid, 0.05, 0.004), std::invalid_argument);
}

}  // namespace
}  // namespace riffle::test::column
