// Every pair and particle pass of every plugin on made-up values: finite results, the same in any block, nothing else
// written. The values are positive and of order one, so that no pass has a reason to fail.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/contract/block_case.hpp"

namespace riffle::contract {
namespace {

struct PassCase {
  Loaded loaded;
  const riffle_pass* pass;
  int dim;
};
void PrintTo(const PassCase& c, std::ostream* out) {
  *out << c.loaded << " " << c.pass->name << " in " << c.dim << "d";
}

std::vector<PassCase> all_passes() {
  std::vector<PassCase> cases;
  for (const Loaded& loaded : all_plugins()) {
    for (const riffle_pass* pass : entries(loaded.plugin->passes)) {
      for (int dim = 1; dim <= 3; ++dim) {
        if (((loaded.plugin->dims >> dim) & 1u) != 0 && pass->type != RIFFLE_PASS_GLOBAL) {
          cases.push_back({loaded, pass, dim});
        }
      }
    }
  }
  return cases;
}

class EveryPass : public testing::TestWithParam<PassCase> {
 protected:
  static constexpr std::size_t n = 64;
  const PassCase c = GetParam();
  [[nodiscard]] BlockCase block() const {
    BlockCase block(*c.pass, c.dim, n);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> value(0.5, 1.5);
    for (std::size_t k = 0; k < entries(c.pass->reads).size(); ++k) {
      // Kernel derivatives are never positive; pairs that approach are the ones that viscosities act on.
      const std::string field = entries(c.pass->reads)[k]->field->name;
      const double sign = field == "kernel_gradient" || field == "approach" ? -1 : 1;
      for (auto& component : block.read(k)) {
        for (double& x : component) x = sign * value(random);
      }
    }
    return block;
  }
};

TEST_P(EveryPass, GivesFiniteValuesAndStaysInItsBlock) {
  const Instance instance(*c.loaded.plugin, c.dim);
  BlockCase whole = block();
  whole.run(instance, 0, n);
  for (std::size_t w = 0; w < whole.outputs().size(); ++w) {
    const std::uint32_t how = entries(c.pass->writes)[w]->how;  // of a least or largest, infinity says: not this one
    const bool extreme = how == RIFFLE_MIN || how == RIFFLE_MAX;
    for (const auto& component : whole.outputs()[w]) {
      for (std::size_t k = 0; k < n; ++k)
        EXPECT_TRUE(std::isfinite(component[k]) || (extreme && std::isinf(component[k]))) << component[k];
      for (std::size_t k = n; k < component.size(); ++k) EXPECT_EQ(component[k], canary);
    }
  }
}

TEST_P(EveryPass, GivesTheSameBitsInAnyBlock) {
  const Instance instance(*c.loaded.plugin, c.dim);
  BlockCase whole = block(), parts = block();
  whole.run(instance, 0, n);
  for (std::size_t first = 0, count = 4; first < n; first += count, count += 4) {
    parts.run(instance, first, std::min(count, n - first));
  }
  EXPECT_EQ(whole.outputs(), parts.outputs());
}

TEST_P(EveryPass, DoesNotLookAtTheTimeWhereItSaysSo) {
  if ((c.pass->flags & RIFFLE_STEADY) == 0) return;
  const Instance instance(*c.loaded.plugin, c.dim);
  BlockCase now = block(), later = block();
  later.at(17, 0.3);
  now.run(instance, 0, n);
  later.run(instance, 0, n);
  EXPECT_EQ(now.outputs(), later.outputs());
}

INSTANTIATE_TEST_SUITE_P(Passes, EveryPass, testing::ValuesIn(all_passes()), [](const auto& info) {
  std::string pass = info.param.pass->name;
  for (char& letter : pass) letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  return test_name(info.param.loaded) + "_" + pass + "_" + std::to_string(info.index);
});

}  // namespace
}  // namespace riffle::contract
