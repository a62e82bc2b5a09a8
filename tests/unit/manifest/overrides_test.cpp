#include "tests/unit/manifest/fake_catalogue.hpp"

namespace riffle::test {
namespace {

using Overrides = ManifestTest;

TEST_F(Overrides, AnyKeyCanBeSetAndIsRecorded) {
  const Lines given{"plugins.viscosity.alpha=1.0", "case.title=Hello there", "initial.depth=10 m", "time.end=\"2 min\"",
                    "domain.x=[0, \"50 m\"]"};
  const Case c = read(dam_break, given);
  EXPECT_EQ(c.plugins[2].values[0].number, 1);
  EXPECT_EQ(c.title, "Hello there");
  EXPECT_EQ(c.initial.at("depth")[0](3), 10);
  EXPECT_EQ(c.time.end, 120);
  EXPECT_EQ(c.upper[0], 50);
  EXPECT_EQ(c.overrides, given);
}

TEST_F(Overrides, TheLastOneWins) {
  EXPECT_EQ(read(dam_break, {"time.end=1", "time.end=2"}).time.end, 2);
}

TEST_F(Overrides, NumbersAndWordsNeedNoQuotesWhereATextIsMeant) {
  EXPECT_EQ(read(dam_break, {"case.title=2024"}).title, "2024");
  EXPECT_EQ(read(dam_break, {"case.name=true"}).name, "true");
  EXPECT_EQ(read(dam_break, {"time.cfl=.25"}).time.cfl, 0.25);
  EXPECT_EQ(read(dam_break, {"time.drag=explicit"}).time.drag_implicit, false);
  EXPECT_EQ(read(dam_break, {"initial.velocity=0.1*x"}).initial.at("velocity")[0](10), 1);
}

TEST_F(Overrides, AWholeTableCanBeMade) {
  const Case c = read(dam_break, {"reference.id=stoker", "reference.h_left=10", "fluid={gravity=1}"});
  EXPECT_EQ(c.reference->plugin.values[0].number, 10);
  EXPECT_EQ(c.gravity, 1);
  const Case wall = read(dam_break, {"plugins.left.kind=boundary", "plugins.left.id=mirror-wall"});
  EXPECT_EQ(wall.plugins.back().id, "mirror-wall");
}

TEST_F(Overrides, AnotherPluginDropsTheParametersOfTheFormerOneThatItDoesNotHave) {
  EXPECT_EQ(read(dam_break, {"plugins.viscosity.id=none"}).plugins[2].id, "none");
  const std::string with_beta = with(dam_break, "alpha = 2.0", "alpha = 2.0\nbeta = 1.5");
  const Case riemann = read(with_beta, {"plugins.viscosity.id=riemann"});
  EXPECT_EQ(riemann.plugins[2].values[0].name, "beta");
  EXPECT_EQ(riemann.plugins[2].values[0].number, 1.5);  // both have a beta
  const Case ritter =
      read(dam_break + "\n[reference]\nid = \"stoker\"\nh_left = 3\nh_right = 1\n", {"reference.id=ritter"});
  EXPECT_EQ(ritter.reference->plugin.values[0].number, 3);
}

TEST_F(Overrides, WhatIsSetTogetherWithAnotherPluginMustSuitIt) {
  EXPECT_EQ(
      mistakes(dam_break, {"plugins.viscosity.alpha=1", "plugins.viscosity.id=none"}),
      (Lines{
          "--set plugins.viscosity.alpha=1: viscosity \"none\" has no parameter \"alpha\"; it takes no parameters"}));
}

TEST_F(Overrides, ASlipInTheFileIsReportedEvenWhenThePluginIsSwapped) {
  EXPECT_EQ(mistakes(with(dam_break, "alpha =", "alfa ="), {"plugins.viscosity.id=none"}),
            (Lines{"case.toml:20:1: viscosity \"none\" has no parameter \"alfa\"; it takes no parameters"}));
}

TEST_F(Overrides, CountTakesThePlaceOfSpacingAndTheOtherWayRound) {
  const Case spaced = read(dam_break, {"initial.particles.spacing=0.5"});
  EXPECT_EQ(spaced.placement.mode, Placement::Mode::spacing);
  EXPECT_EQ(spaced.placement.spacing, 0.5);
  const Case counted = read(with(dam_break, "count = 400", "spacing = 1"), {"initial.particles.count=50"});
  EXPECT_EQ(counted.placement.mode, Placement::Mode::count);
  EXPECT_EQ(counted.placement.count, 50);
}

TEST_F(Overrides, MistakesInThemAreLocatedByTheirOwnText) {
  EXPECT_EQ(
      mistakes(dam_break, {"plugins.viscosity.alfa=1", "time.end=-1", "novalue", "a b=1", ".x=1", "case.name.x=1",
                           "tyme.end=3", "initial.depth=10*xx"}),
      (Lines{
          "--set plugins.viscosity.alfa=1: viscosity \"monaghan\" has no parameter \"alfa\"; did you mean \"alpha\"?",
          "--set time.end=-1: time.end must be a time above 0 s, got -1",
          "--set novalue: an override must be key=value with a dotted key, such as plugins.viscosity.alpha=1.0",
          "--set a b=1: an override must be key=value with a dotted key, such as plugins.viscosity.alpha=1.0",
          "--set .x=1: an override must be key=value with a dotted key, such as plugins.viscosity.alpha=1.0",
          "--set case.name.x=1: case.name is \"dam-break\", not a table that could hold \"x\"",
          "--set tyme.end=3: unknown table \"tyme\"; did you mean \"time\"?",
          "--set initial.depth=10*xx: initial.depth: the formula \"10*xx\" does not parse at character 4: "
          "unexpected token \"xx\"; did you mean \"x\"?"}));
}

}  // namespace
}  // namespace riffle::test
