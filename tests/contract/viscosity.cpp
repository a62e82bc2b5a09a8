// Viscosities: symmetric in the two particles and dissipative; Monaghan's against numbers worked out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/contract/block_case.hpp"

namespace riffle::contract {
namespace {

const riffle_pass& only_pass(const riffle_plugin& plugin) {
  return *entries(plugin.passes).at(0);
}

class EveryViscosity : public testing::TestWithParam<Loaded> {};

// A pair gains kinetic energy at a rate proportional to Pi (u_ij . x_ij), since F <= 0: it must never be above 0. What
// is read at i and at j must count alike for momentum to be kept.
TEST_P(EveryViscosity, IsSymmetricAndTakesEnergyOut) {
  const riffle_plugin& plugin = *GetParam().plugin;
  const Instance instance(plugin, 1);
  for (const riffle_pass* pass : entries(plugin.passes)) {
    if (pass->type != RIFFLE_PASS_PAIR || std::string(entries(pass->writes)[0]->field->name) != "viscous_pressure") {
      continue;
    }
    for (const double approach : {-2.0, -1e-3, 0.0, 1e-3, 2.0}) {
      BlockCase pair(*pass, 1, 8), swapped(*pass, 1, 8);
      const auto reads = entries(pass->reads);
      for (std::size_t k = 0; k < reads.size(); ++k) {
        const std::string field = reads[k]->field->name;
        const bool at_i = reads[k]->where == RIFFLE_AT_I, at_j = reads[k]->where == RIFFLE_AT_J;
        const bool odd = reads[k]->where == RIFFLE_DIFFERENCE || field == "separation";  // changes sign when swapped
        const double value = field == "approach" ? approach : at_i ? 0.7 : at_j ? 1.2 : 0.9;
        std::fill(pair.in(k).begin(), pair.in(k).end(), value);
        std::fill(swapped.in(k).begin(), swapped.in(k).end(), at_i ? 1.2 : at_j ? 0.7 : odd ? -value : value);
      }
      pair.run(instance, 0, 8);
      swapped.run(instance, 0, 8);
      EXPECT_EQ(pair.out(0)[0], swapped.out(0)[0]) << approach;
      EXPECT_LE(pair.out(0)[0] * approach, 0) << approach;
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Contract, EveryViscosity, testing::ValuesIn(plugins_of("viscosity")),
                         [](const auto& info) { return test_name(info.param); });

class Monaghan : public testing::Test {
 protected:
  // Pi times the pair-mean density for r = 2, l = 2, c = 5 and the closing u_ij . x_ij.
  static double at(double alpha, double beta, double approach, double r = 2) {
    const riffle_plugin& table = plugin("viscosity", "monaghan");
    const Instance instance(table, 1, {{"alpha", alpha}, {"beta", beta}, {"epsilon", 0.25}});
    BlockCase block(only_pass(table), 1, 4);
    const std::map<std::string, double> values{{"approach", approach},
                                               {"distance", r},
                                               {"distance_squared", r * r},
                                               {"smoothing_length", 2},
                                               {"wave_speed", 5}};
    const auto reads = entries(only_pass(table).reads);
    for (std::size_t k = 0; k < reads.size(); ++k) {
      std::fill(block.in(k).begin(), block.in(k).end(), values.at(reads[k]->field->name));
    }
    block.run(instance, 0, 4);
    return block.out(0)[0];
  }
};

// mu = l (u . x) / (r^2 + eps l^2) = 2 * (-10) / (4 + 1) = -4; all numbers are exact in binary.
TEST_F(Monaghan, GivesTheLinearTermByHand) {
  EXPECT_EQ(at(0.5, 0, -10), 0.5 * 5 * 4);
}
TEST_F(Monaghan, GivesTheQuadraticTermByHand) {
  EXPECT_EQ(at(0, 2, -10), 2 * 4 * 4);
}
TEST_F(Monaghan, AddsTheTwo) {
  EXPECT_EQ(at(0.5, 2, -10), 0.5 * 5 * 4 + 2 * 4 * 4);
}
TEST_F(Monaghan, LeavesPartingPairsAlone) {
  EXPECT_EQ(at(0.5, 2, 10), 0);
  EXPECT_EQ(at(0.5, 2, 0), 0);
}
TEST_F(Monaghan, IsFiniteForParticlesAtOnePlace) {
  EXPECT_TRUE(std::isfinite(at(1, 1, -1e-30, 0)));
}

}  // namespace
}  // namespace riffle::contract
