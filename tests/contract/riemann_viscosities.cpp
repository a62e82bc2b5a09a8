// lax-friedrichs, riemann and riemann-muscl against what their formulas say where they can be worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/contract/block_case.hpp"

namespace riffle::contract {
namespace {

// The pass of a plugin that writes viscous_pressure, on one pair: values by name of field, those at i and j as "name.i".
double pressure(const std::string& id, const std::map<std::string, double>& parameters,
                const std::map<std::string, double>& values, int dim = 1) {
  const riffle_plugin& table = plugin("viscosity", id);
  const Instance instance(table, dim, parameters);
  for (const riffle_pass* pass : entries(table.passes)) {
    if (std::string(entries(pass->writes)[0]->field->name) != "viscous_pressure") continue;
    BlockCase block(*pass, dim, 8);
    const auto reads = entries(pass->reads);
    for (std::size_t k = 0; k < reads.size(); ++k) {
      std::string name = reads[k]->field->name;
      if (reads[k]->where == RIFFLE_AT_I) name += ".i";
      if (reads[k]->where == RIFFLE_AT_J) name += ".j";
      for (std::size_t c = 0; c < block.read(k).size(); ++c) {
        const std::string component = block.read(k).size() == 1 ? name : name + "." + std::to_string(c);
        std::fill(block.in(k, c).begin(), block.in(k, c).end(), values.at(component));
      }
    }
    block.run(instance, 0, 8);
    return block.out(0)[0];
  }
  throw std::logic_error("no pass writes viscous_pressure");
}

// u_ij . x_ij = -6 at r = 2: the pair closes at 3 m/s. All numbers are exact in binary.
constexpr double r = 2, closing = 3;
std::map<std::string, double> pair_of(double speed, double gi, double gj) {
  return {{"approach", -speed * r},
          {"distance", r},
          {"separation", r},
          {"wave_speed.i", 4},
          {"wave_speed.j", 8},
          {"wave_speed", 6},
          {"renormalised_velocity_gradient.i", gi},
          {"renormalised_velocity_gradient.j", gj}};
}

TEST(LaxFriedrichs, TakesTheFasterWave) {
  EXPECT_EQ(pressure("lax-friedrichs", {{"alpha", 0.5}}, pair_of(closing, 0, 0)), 0.5 * 8 * 3);
  EXPECT_EQ(pressure("lax-friedrichs", {{"alpha", 0.5}}, pair_of(-closing, 0, 0)), -0.5 * 8 * 3);
}
TEST(Riemann, TakesTheMeanWaveAndTheSquareOfTheClosingSpeed) {
  EXPECT_EQ(pressure("riemann", {{"alpha", 0.5}, {"beta", 2}}, pair_of(closing, 0, 0)), 0.5 * 6 * 3 + 2 * 9);
  EXPECT_EQ(pressure("riemann", {{"alpha", 0.5}, {"beta", 2}}, pair_of(-closing, 0, 0)), -0.5 * 6 * 3);
}
TEST(RiemannLike, LeavePartingPairsAloneWhenTold) {
  for (const char* id : {"lax-friedrichs", "riemann", "riemann-muscl"}) {
    EXPECT_EQ(pressure(id, {{"approaching_only", 1}}, pair_of(-closing, 0, 0)), 0) << id;
    EXPECT_GT(pressure(id, {{"approaching_only", 1}}, pair_of(closing, 0, 0)), 0) << id;
  }
}

class RiemannMuscl : public testing::TestWithParam<double> {};  // the limiter

TEST_P(RiemannMuscl, VanishesWhereTheVelocityIsLinear) {
  for (const double speed : {closing, -closing}) {
    const double slope = -speed / r;  // du/dx
    EXPECT_EQ(pressure("riemann-muscl", {{"limiter", GetParam()}}, pair_of(speed, slope, slope)), 0);
  }
}
TEST_P(RiemannMuscl, IsThatOfConstantStatesBetweenPlateaus) {
  for (const double speed : {closing, -closing}) {
    EXPECT_EQ(pressure("riemann-muscl", {{"limiter", GetParam()}}, pair_of(speed, 0, 0)),
              pressure("riemann", {}, pair_of(speed, 0, 0)));
  }
}
TEST_P(RiemannMuscl, LiesBetweenThoseOfLinearAndConstantStates) {
  const double most = pressure("riemann", {}, pair_of(closing, 0, 0));
  for (const double gi : {-40.0, -2.0, -1.0, 0.0, 3.0}) {
    for (const double gj : {-40.0, -1.6, -1.2, 0.0, 3.0}) {
      const double found = pressure("riemann-muscl", {{"limiter", GetParam()}}, pair_of(closing, gi, gj));
      EXPECT_GE(found, 0) << gi << " " << gj;
      EXPECT_LE(found, most) << gi << " " << gj;
    }
  }
}
// x_ij = (2, 0): only the gradient's first entry acts. Turned by 45 degrees: e . G e = (xx + xy + yx + yy) / 2.
TEST_P(RiemannMuscl, TakesTheGradientAlongThePair) {
  auto values = pair_of(closing, 0, 0);
  const auto set = [&](const std::string& where, double xx, double xy, double yx, double yy) {
    const double entries[] = {xx, xy, yx, yy};
    for (int c = 0; c < 4; ++c)
      values["renormalised_velocity_gradient." + where + "." + std::to_string(c)] = entries[c];
  };
  const std::map<std::string, double> limiter{{"limiter", GetParam()}};
  values["separation.0"] = r;
  values["separation.1"] = 0;
  set("i", -0.6, 7, -3, 5);
  set("j", -1, 2, 9, -4);
  EXPECT_NEAR(pressure("riemann-muscl", limiter, values, 2),
              pressure("riemann-muscl", limiter, pair_of(closing, -0.6, -1)), 1e-14);
  values["separation.0"] = values["separation.1"] = r * std::sqrt(0.5);
  set("i", -0.2, -0.3, -0.3, -0.4);
  set("j", -1, 2, -2, -1);
  EXPECT_NEAR(pressure("riemann-muscl", limiter, values, 2),
              pressure("riemann-muscl", limiter, pair_of(closing, -0.6, -1)), 1e-13);  // a square root and ten sums
}
INSTANTIATE_TEST_SUITE_P(Limiters, RiemannMuscl, testing::Values(0, 1, 2, 3));

// What is read decides all: a frame that moves adds one velocity to all particles, and differences do not see it.
TEST(Viscosities, SeeOnlyDifferencesOfVelocity) {
  for (const Loaded& loaded : plugins_of("viscosity")) {
    for (const riffle_pass* pass : entries(loaded.plugin->passes)) {
      for (const riffle_read* read : entries(pass->reads)) {
        EXPECT_FALSE(std::string(read->field->name) == "velocity" && read->where != RIFFLE_DIFFERENCE) << loaded;
      }
    }
  }
}

}  // namespace
}  // namespace riffle::contract
