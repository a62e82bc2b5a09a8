// Plugins that load and are created, but break what their kind owes: found before a run by a few calls on made-up numbers.
#include <gtest/gtest.h>

#include "host/plugins/contracts.hpp"
#include "host/plugins/library.hpp"
#include "tests/hostile/files.hpp"

namespace riffle {
namespace {

std::vector<std::string> broken(const std::string& name, int dim) {
  const Library loaded(hostile::library(name));
  const Plugin& plugin = loaded.plugins().front();
  return contract_problems(PluginInstance(plugin, dim, default_values(plugin.description)));
}
using Lines = std::vector<std::string>;

TEST(Contract, AGoodDragBreaksNothing) {
  for (const int dim : {1, 2, 3}) EXPECT_EQ(broken("good", dim), Lines{});
}

TEST(Contract, NegativeDragIsFoundWithItsValue) {
  EXPECT_EQ(broken("negative-drag", 2),
            Lines{"drag \"negative-drag\": pass \"friction\": \"drag_rate\" is -0.238847; it must not be negative"});
}

TEST(Contract, WhatIsNoNumberIsFound) {
  EXPECT_EQ(broken("nan-in-run", 1),
            Lines{"drag \"nan-in-run\": pass \"friction\": \"drag_rate\" is no number, or not written"});
}

TEST(Contract, AWritePastTheBlockIsFound) {
  EXPECT_EQ(broken("writes-past-block", 1),
            Lines{"drag \"writes-past-block\": pass \"friction\": writes past the end of \"drag_rate\""});
}

TEST(Contract, AnErrorIsPassedOn) {
  EXPECT_EQ(
      broken("error-in-run", 1),
      Lines{"drag \"error-in-run\": pass \"friction\": fails on made-up numbers: the bed has no grain size here"});
}

TEST(Contract, AnExceptionIsSurvived) {
  EXPECT_EQ(broken("throws-in-run", 1),
            Lines{"drag \"throws-in-run\": pass \"friction\": fails on made-up numbers: an exception left the plugin: "
                  "particle 0 is not in the table of roughness"});
}

TEST(Contract, AsymmetricViscosityLosesMomentum) {
  EXPECT_EQ(broken("asymmetric-viscosity", 1),
            Lines{"viscosity \"asymmetric\": pass \"viscosity\": viscous_pressure is 0.0022957 for (i, j) but "
                  "0.00186811 for (j, i), so momentum would not be conserved"});
}

TEST(Contract, AKernelWithTheFactorOfAnotherDimensionIsFound) {
  // In one dimension the cubic spline wants 2/3; with 10 / (7 pi) its integral is 15 / (7 pi) = 0.682093.
  EXPECT_EQ(broken("wrong-integral", 1),
            Lines{"kernel \"wrong-integral\": its integral over space is 0.682092613251, but it says 1"});
  EXPECT_EQ(broken("wrong-integral", 2), Lines{});
}

}  // namespace
}  // namespace riffle
