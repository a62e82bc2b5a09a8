// Drags against numbers worked out by hand. That no drag is ever negative, passes.cpp and the host's own contract see
// to.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/contract/block_case.hpp"

namespace riffle::contract {
namespace {

struct Law {
  std::string id;
  std::map<std::string, double> given;
  double rate;  // of water 8 m deep at 3 m/s
};

// Rates by hand, with gravity 8:
//   manning        g n^2 |u| / h^(4/3) = 8 * 0.25 * 3 / 16
//   chezy          g |u| / (C^2 h)     = 8 * 3 / (4 * 8)
//   darcy-weisbach f |u| / (8 h)       = 0.5 * 3 / (8 * 8)
const std::vector<Law> laws{{"manning", {{"roughness", 0.5}, {"gravity", 8}}, 0.375},
                            {"chezy", {{"coefficient", 2}, {"gravity", 8}}, 0.75},
                            {"darcy-weisbach", {{"friction_factor", 0.5}}, 0.0234375}};
void PrintTo(const Law& law, std::ostream* out) {
  *out << law.id;
}

class Friction : public testing::TestWithParam<Law> {
 protected:
  // The rate that a first drag of `before` [1/s] becomes.
  [[nodiscard]] static double rate(const std::vector<double>& velocity, double depth, double before = 0) {
    const riffle_plugin& table = plugin("drag", GetParam().id);
    const riffle_pass& pass = *entries(table.passes).at(0);
    const auto dim = static_cast<int>(velocity.size());
    const Instance instance(table, dim, GetParam().given);
    BlockCase block(pass, dim, 4);
    const auto reads = entries(pass.reads);
    for (std::size_t k = 0; k < reads.size(); ++k) {
      const bool is_velocity = std::string(reads[k]->field->name) == "velocity";
      for (std::size_t c = 0; c < block.read(k).size(); ++c) {
        std::fill(block.in(k, c).begin(), block.in(k, c).end(), is_velocity ? velocity[c] : depth);
      }
    }
    std::fill(block.out(0).begin(), block.out(0).end(), before);
    block.run(instance, 0, 4);
    return block.out(0)[0];
  }
};

// Cube roots are good to an ulp, hence not EXPECT_EQ.
TEST_P(Friction, GivesTheRateByHand) {
  EXPECT_DOUBLE_EQ(rate({3}, 8), GetParam().rate);
}
TEST_P(Friction, TakesTheSizeOfTheVelocityInThePlane) {
  EXPECT_DOUBLE_EQ(rate({-3, 4}, 8), GetParam().rate * 5 / 3);
}
TEST_P(Friction, IsTheSameWhicheverWayTheWaterRuns) {
  EXPECT_EQ(rate({-3}, 8), rate({3}, 8));
}
TEST_P(Friction, LeavesWaterAtRestAlone) {
  EXPECT_EQ(rate({0}, 8), 0);
}
TEST_P(Friction, AddsToTheDragOfOthers) {
  EXPECT_DOUBLE_EQ(rate({3}, 8, 2), GetParam().rate + 2);
}

INSTANTIATE_TEST_SUITE_P(Laws, Friction, testing::ValuesIn(laws), [](const auto& info) {
  std::string name = info.param.id;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// Where n, C and f describe the same uniform flow, C = h^(1/6) / n and f = 8 g / C^2, the rates agree.
TEST(FrictionLaws, AgreeWhereTheirCoefficientsDescribeOneFlow) {
  const double n = 0.013, h = 0.7, g = 9.81, chezy = std::pow(h, 1.0 / 6) / n;
  const std::vector<Law> same{{"manning", {{"roughness", n}, {"gravity", g}}, 0},
                              {"chezy", {{"coefficient", chezy}, {"gravity", g}}, 0},
                              {"darcy-weisbach", {{"friction_factor", 8 * g / (chezy * chezy)}}, 0}};
  std::vector<double> rates;
  for (const Law& law : same) {
    const riffle_plugin& table = plugin("drag", law.id);
    const Instance instance(table, 1, law.given);
    BlockCase block(*entries(table.passes).at(0), 1, 4);
    std::fill(block.in(0).begin(), block.in(0).end(), 1.3);
    std::fill(block.in(1).begin(), block.in(1).end(), h);
    std::fill(block.out(0).begin(), block.out(0).end(), 0.0);
    block.run(instance, 0, 4);
    rates.push_back(block.out(0)[0]);
  }
  EXPECT_NEAR(rates[1] / rates[0], 1, 1e-14);  // some roundings
  EXPECT_NEAR(rates[2] / rates[0], 1, 1e-14);
}

}  // namespace
}  // namespace riffle::contract
