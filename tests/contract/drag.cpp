// Drags: Manning's against numbers worked out by hand. That no drag is ever negative, passes.cpp and the host's own
// contract see to.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/contract/block_case.hpp"

namespace riffle::contract {
namespace {

// The rate that a first drag of `before` [1/s] becomes, with roughness 0.5 and gravity 8.
double manning_rate(const std::vector<double>& velocity, double depth, double before = 0) {
  const riffle_plugin& table = plugin("drag", "manning");
  const riffle_pass& pass = *entries(table.passes).at(0);
  const auto dim = static_cast<int>(velocity.size());
  const Instance instance(table, dim, {{"roughness", 0.5}, {"gravity", 8}});
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

// lambda = g n^2 |u| / h^(4/3) = 8 * 0.25 * 3 / 16; cube roots are good to an ulp, hence not EXPECT_EQ.
TEST(Manning, GivesTheRateByHand) {
  EXPECT_DOUBLE_EQ(manning_rate({3}, 8), 0.375);
}
TEST(Manning, TakesTheSizeOfTheVelocityInThePlane) {
  EXPECT_DOUBLE_EQ(manning_rate({-3, 4}, 8), 0.625);
}
TEST(Manning, IsTheSameWhicheverWayTheWaterRuns) {
  EXPECT_EQ(manning_rate({-3}, 8), manning_rate({3}, 8));
}
TEST(Manning, LeavesWaterAtRestAlone) {
  EXPECT_EQ(manning_rate({0}, 8), 0);
}
TEST(Manning, AddsToTheDragOfOthers) {
  EXPECT_DOUBLE_EQ(manning_rate({3}, 8, 2), 2.375);
}

}  // namespace
}  // namespace riffle::contract
