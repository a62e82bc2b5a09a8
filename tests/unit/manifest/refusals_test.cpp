// What does not go together: plugins that an equation set refuses, a second bed, a depth beside a level.
#include "tests/unit/manifest/fake_catalogue.hpp"

namespace riffle::test {
namespace {

class ManifestRefusals : public ManifestTest {
 protected:
  // A plane with the equation set "compressible" and these tables of plugins from line 13 on.
  Lines refused(const std::string& plugins) const {
    return mistakes(
        "[case]\nname = \"plane\"\n[domain]\ndimension = 2\nx = [0, 1]\nz = [0, 1]\nsmoothing_ratio = 2\n"
        "[initial]\nparticles = { spacing = 0.1 }\ndensity = 1000\n[time]\nend = 1\n" +
        plugins +
        "[plugins.equations]\nid = \"compressible\"\nsound_speed = 10\n[plugins.kernel]\nid = \"wendland-c2\"\n");
  }
};

TEST_F(ManifestRefusals, WaterHasADepthOrALevel) {
  EXPECT_EQ(mistakes(with(dam_break, "particles = { count = 400 }", "particles = { count = 400 }\nlevel = 3")),
            (Lines{"case.toml:10:1: initial must have either depth or level, got both"}));
  EXPECT_EQ(mistakes(with(dam_break, "depth = { x = [100], values = [10, 5] }", "level = \"3 m\"")), Lines{});
}

TEST_F(ManifestRefusals, AFieldMayBeginAsTheReferenceHasIt) {
  const std::string from_reference =
      with(dam_break, "values = [10, 5] }", "values = [10, 5] }\nvelocity = \"reference\"");
  const Case c = read(from_reference + "[reference]\nid = \"stoker\"\n");
  EXPECT_EQ(c.initial_from_reference, std::vector<std::string>{"velocity"});
  EXPECT_EQ(c.initial.count("velocity"), 0u);
  EXPECT_EQ(mistakes(from_reference),
            (Lines{"case.toml:11:12: initial.velocity = \"reference\" needs the table [reference]"}));
  EXPECT_EQ(mistakes(from_reference + "[reference]\nid = \"ritter\"\n"),
            (Lines{"case.toml:11:12: initial.velocity: reference \"ritter\" gives no velocity"}));
}

TEST_F(ManifestRefusals, WhatAnEquationSetRefusesIsSaidWithItsReason) {
  EXPECT_EQ(
      refused("[plugins.viscosity]\nid = \"riemann\"\n[plugins.drag]\nid = \"manning\"\nn = 0.1\n"),
      (Lines{"case.toml:14:6: viscosity \"riemann\" cannot be used with equations \"compressible\": it has no faces to "
             "solve for",
             "case.toml:16:6: drag \"manning\" cannot be used with equations \"compressible\": there is no depth to "
             "rub on"}));
  EXPECT_EQ(refused("[plugins.viscosity]\nid = \"monaghan\"\n"), Lines{});
}

TEST_F(ManifestRefusals, AWholeKindMayBeRefusedButNeverNone) {
  EXPECT_EQ(refused("[plugins.turbulence]\nid = \"mixing-length\"\n"),
            (Lines{"case.toml:14:6: turbulence \"mixing-length\" cannot be used with equations \"compressible\": its "
                   "stresses are its own; use none"}));
  EXPECT_EQ(refused("[plugins.turbulence]\nid = \"none\"\n"), Lines{});
}

TEST_F(ManifestRefusals, ThereIsAtMostOneBed) {
  EXPECT_EQ(refused("[plugins.bed]\nid = \"flat\"\n[plugins.hill]\nkind = \"bed\"\nid = \"flat\"\n"),
            (Lines{"case.toml:15:10: there must be at most one bed plugin, [plugins.hill] is one too many beside "
                   "[plugins.bed]"}));
}

}  // namespace
}  // namespace riffle::test
