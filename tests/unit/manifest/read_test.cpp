// What a right manifest becomes.
#include "host/manifest/read.hpp"

#include <nlohmann/json.hpp>

#include "tests/unit/manifest/fake_catalogue.hpp"

namespace riffle::test {
namespace {

using ReadCase = ManifestTest;

TEST_F(ReadCase, AMinimalManifestIsFilledWithDefaults) {
  const Case c = read(dam_break);
  EXPECT_EQ(c.name, "dam-break");
  EXPECT_EQ(c.title, "dam-break");
  EXPECT_EQ(c.file, folder_ / "case.toml");
  EXPECT_EQ(c.dimension, 1);
  EXPECT_EQ(c.lower[0], 0);
  EXPECT_EQ(c.upper[0], 200);
  EXPECT_EQ(c.smoothing_ratio, 2);
  EXPECT_EQ(c.gravity, 9.81);
  EXPECT_EQ(c.density, 1000);
  EXPECT_EQ(c.viscosity, 1e-6);
  EXPECT_EQ(c.placement.mode, Placement::Mode::count);
  EXPECT_EQ(c.placement.count, 400);
  EXPECT_EQ(c.placement.perturbation, 0);
  EXPECT_EQ(c.placement.seed, 1u);
  EXPECT_FALSE(c.placement.inside.valid());
  EXPECT_EQ(c.time.end, 6);
  EXPECT_EQ(c.time.cfl, 0.5);
  EXPECT_FALSE(c.time.fixed_step.has_value());
  EXPECT_EQ(c.time.integrator, "leap-frog");
  EXPECT_TRUE(c.time.drag_implicit);
  EXPECT_TRUE(c.output.picture);
  EXPECT_EQ(c.output.snapshot_interval, 0);
  EXPECT_TRUE(c.output.fields.empty());
  EXPECT_FALSE(c.reference.has_value());
  EXPECT_TRUE(c.overrides.empty());
}

TEST_F(ReadCase, PluginsComeInTheOrderOfTheManifestWithOneValuePerParameter) {
  const Case c = read(dam_break);
  ASSERT_EQ(c.plugins.size(), 3u);
  EXPECT_EQ(c.plugins[0].kind, "equations");
  EXPECT_EQ(c.plugins[1].kind, "kernel");
  const PluginChoice& viscosity = c.plugins[2];
  EXPECT_EQ(viscosity.slot, "viscosity");
  EXPECT_EQ(viscosity.id, "monaghan");
  EXPECT_EQ(viscosity.description, catalogue_.find("viscosity", "monaghan"));
  ASSERT_EQ(viscosity.values.size(), 2u);
  EXPECT_EQ(viscosity.values[0].name, "alpha");
  EXPECT_EQ(viscosity.values[0].number, 2);
  EXPECT_TRUE(viscosity.values[0].given);
  EXPECT_EQ(viscosity.values[1].name, "beta");
  EXPECT_EQ(viscosity.values[1].number, 0);
  EXPECT_FALSE(viscosity.values[1].given);
}

TEST_F(ReadCase, AChoiceIsAnIndexAndAWord) {
  const Case c = read(with(dam_break, "id = \"shallow-water\"", "id = \"shallow-water\"\nsupport = \"inverse-depth\""));
  EXPECT_EQ(c.plugins[0].values[0].number, 1);
  EXPECT_EQ(c.plugins[0].values[0].text, "inverse-depth");
  const Case by_default = read(dam_break);
  EXPECT_EQ(by_default.plugins[0].values[0].number, 0);
  EXPECT_EQ(by_default.plugins[0].values[0].text, "constant");
}

TEST_F(ReadCase, ParametersInheritQuantitiesOfTheManifest) {
  const std::string manifest =
      with(dam_break, "[initial]", "[fluid]\ngravity = \"1.62 m/s2\"\n\n[initial]") +
      "\n[plugins.left]\nkind = \"boundary\"\nid = \"mirror-wall\"\n"
      "\n[plugins.right]\nkind = \"boundary\"\nid = \"mirror-wall\"\nposition = \"20000 cm\"\n";
  const Case c = read(manifest);
  EXPECT_EQ(c.plugins[0].values[1].number, 1.62);
  EXPECT_FALSE(c.plugins[0].values[1].given);
  EXPECT_EQ(c.plugins[3].slot, "left");
  EXPECT_EQ(c.plugins[3].kind, "boundary");
  EXPECT_EQ(c.plugins[3].values[0].number, 0);
  EXPECT_EQ(c.plugins[4].values[0].number, 200);
}

TEST_F(ReadCase, QuantitiesMayCarryUnitsEverywhere) {
  std::string manifest = with(dam_break, "x = [0, 200]", "x = [\"-10 cm\", \"0.2 km\"]");
  manifest = with(manifest, "end = 6", "end = \"2 min\"\nstep = \"10 ms\"\nmax_step = 0.5\nmax_steps = 1e6");
  manifest = with(manifest, "count = 400", "spacing = \"25 mm\", perturbation = \"10 %\"");
  const Case c = read(manifest);
  EXPECT_EQ(c.lower[0], -0.1);
  EXPECT_EQ(c.upper[0], 200);
  EXPECT_EQ(c.time.end, 120);
  EXPECT_EQ(c.time.fixed_step, 0.01);
  EXPECT_EQ(c.time.max_step, 0.5);
  EXPECT_EQ(c.time.max_steps, 1000000);
  EXPECT_EQ(c.placement.mode, Placement::Mode::spacing);
  EXPECT_EQ(c.placement.spacing, 0.025);
  EXPECT_EQ(c.placement.perturbation, 0.1);
}

TEST_F(ReadCase, EqualVolumeAndInsideReachThePlacement) {
  const Case c = read(
      with(dam_break, "count = 400 }", "count = 400, placement = \"equal-volume\", seed = 7 }\ninside = \"x - 5\""));
  EXPECT_EQ(c.placement.mode, Placement::Mode::equal_volume);
  EXPECT_EQ(c.placement.seed, 7u);
  ASSERT_TRUE(c.placement.inside.valid());
  EXPECT_EQ(c.placement.inside(7), 2);
}

TEST_F(ReadCase, InitialFieldsHaveOneFunctionPerComponentAndOnlyThoseGivenAreThere) {
  const Case c = read(with(dam_break, "depth =", "velocity = \"0.5 m/s\"\ndepth ="));
  ASSERT_EQ(c.initial.size(), 2u);
  ASSERT_EQ(c.initial.at("depth").size(), 1u);
  EXPECT_EQ(c.initial.at("depth")[0](99), 10);
  EXPECT_EQ(c.initial.at("depth")[0](100), 5);
  ASSERT_EQ(c.initial.at("velocity").size(), 1u);
  EXPECT_EQ(c.initial.at("velocity")[0](3), 0.5);
}

TEST_F(ReadCase, AVerticalPlaneHasTheAxesXAndZ) {
  const std::string manifest = R"([case]
name = "column"
title = "Still water"
[domain]
dimension = 2
x = [0, 2]
z = [-0.5, 1]
smoothing_ratio = 1.4
[initial]
particles = { spacing = "2 cm" }
density = "1000 + z"
velocity = [0, "0.1*x"]
[plugins.equations]
id = "compressible"
sound_speed = "20 m/s"
[plugins.kernel]
id = "wendland-c2"
[time]
end = 1
[output]
snapshots = "0.1 s"
profiles = 0.2
checkpoint = "1 min"
checkpoint_wall = "10 min"
picture = false
fields = ["density", "pressure"]
)";
  const Case c = read(manifest);
  EXPECT_EQ(c.title, "Still water");
  EXPECT_EQ(c.lower[1], -0.5);
  EXPECT_EQ(c.upper[1], 1);
  EXPECT_EQ(c.initial.at("density")[0](0, 0, 0.5), 1000.5);
  ASSERT_EQ(c.initial.at("velocity").size(), 2u);
  EXPECT_EQ(c.initial.at("velocity")[1](2), 0.2);
  EXPECT_EQ(c.output.snapshot_interval, 0.1);
  EXPECT_EQ(c.output.profile_interval, 0.2);
  EXPECT_EQ(c.output.checkpoint_interval, 60);
  EXPECT_EQ(c.output.checkpoint_wall_interval, 600);
  EXPECT_FALSE(c.output.picture);
  EXPECT_EQ(c.output.fields, (Lines{"density", "pressure"}));
}

TEST_F(ReadCase, TheIntegratorIsTheFirstOfTheEquationSetWhenItCannotBearTheDefault) {
  const std::string plane = with(with(dam_break, "x = [0, 200]", "dimension = 2\nx = [0, 2]\nz = [0, 1]"),
                                 "particles = { count = 400 }\ndepth = { x = [100], values = [10, 5] }",
                                 "particles = { spacing = 0.1 }\ndensity = 1000");
  const Case c = read(with(plane, "\"shallow-water\"", "\"compressible\"\nsound_speed = 20"));
  EXPECT_EQ(c.time.integrator, "predictor-corrector");
}

TEST_F(ReadCase, AReferenceHasParametersLimitsAndARegion) {
  const Case c = read(dam_break + R"(
[reference]
id = "stoker"
h_right = "50 cm"
ignore_below = { depth = "0.25 mm" }
region = [10, "190 m"]
)");
  ASSERT_TRUE(c.reference.has_value());
  EXPECT_EQ(c.reference->plugin.slot, "reference");
  EXPECT_EQ(c.reference->plugin.id, "stoker");
  EXPECT_EQ(c.reference->plugin.values[1].number, 0.5);
  EXPECT_EQ(c.reference->ignore_below.at("depth"), 0.00025);
  EXPECT_EQ((*c.reference->region)[1], 190);
  EXPECT_EQ(c.plugins.size(), 3u);
}

TEST_F(ReadCase, FunctionParametersAndFilesOfPluginsAreRead) {
  write("flow.txt", "anything");
  const Case c = read(dam_break + R"(
[plugins.inlet]
kind = "boundary"
id = "inflow"
discharge = { t = [0, "1 min"], values = [0, "0.1*t", "20 l/s/m"] }
record = "flow.txt"
)");
  const PluginChoice& inflow = c.plugins.back();
  ASSERT_NE(inflow.values[0].function, nullptr);
  EXPECT_EQ((*inflow.values[0].function)(0, 0, 0, 30), 3);
  EXPECT_EQ((*inflow.values[0].function)(0, 0, 0, 60), 0.02);
  EXPECT_TRUE(std::filesystem::path(inflow.values[1].text).is_absolute());
  EXPECT_TRUE(std::filesystem::equivalent(inflow.values[1].text, folder_ / "flow.txt"));
  const Case by_default = read(dam_break + "\n[plugins.inlet]\nkind = \"boundary\"\nid = \"inflow\"\n");
  EXPECT_EQ((*by_default.plugins.back().values[0].function)(0), 0.25);
}

TEST_F(ReadCase, TheEffectiveManifestHoldsEveryKeyInForceInSi) {
  const auto effective = nlohmann::json::parse(read(dam_break + R"(
[fluid]
viscosity = "1 mm2/s"
[reference]
id = "stoker"
ignore_below = { depth = "0.25 mm" }
)",
                                                    {"plugins.viscosity.alpha=1.5", "initial.bed_level=\"0.1*x\""})
                                                   .effective);
  EXPECT_EQ(effective["case"]["title"], "dam-break");
  EXPECT_EQ(effective["domain"]["dimension"], 1);
  EXPECT_EQ(effective["domain"]["x"], nlohmann::json::parse("[0.0, 200.0]"));
  EXPECT_EQ(effective["fluid"]["viscosity"], 1e-6);
  EXPECT_EQ(effective["fluid"]["gravity"], 9.81);
  EXPECT_EQ(effective["initial"]["particles"]["count"], 400);
  EXPECT_EQ(effective["initial"]["particles"]["placement"], "equal-spacing");
  EXPECT_EQ(effective["initial"]["depth"]["values"], nlohmann::json::parse("[10.0, 5.0]"));
  EXPECT_EQ(effective["initial"]["bed_level"], "0.1*x");
  EXPECT_EQ(effective["plugins"]["viscosity"]["kind"], "viscosity");
  EXPECT_EQ(effective["plugins"]["viscosity"]["alpha"], 1.5);
  EXPECT_EQ(effective["plugins"]["viscosity"]["beta"], 0);
  EXPECT_EQ(effective["plugins"]["equations"]["gravity"], 9.81);
  EXPECT_EQ(effective["time"]["integrator"], "leap-frog");
  EXPECT_FALSE(effective["time"].contains("step"));
  EXPECT_EQ(effective["output"]["fields"], nlohmann::json::array());
  EXPECT_EQ(effective["reference"]["h_right"], 0.5);
  EXPECT_EQ(effective["reference"]["ignore_below"]["depth"], 0.00025);
}

TEST_F(ReadCase, ReadingLeavesTheFolderAsItWas) {
  read(dam_break);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++files;
  EXPECT_EQ(files, 1u);
}

}  // namespace
}  // namespace riffle::test
