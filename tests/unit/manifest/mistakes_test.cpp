// What a wrong manifest is told, word by word: the messages are part of the product.
#include "tests/unit/manifest/fake_catalogue.hpp"

namespace riffle::test {
namespace {

class ManifestMistakes : public ManifestTest {
 protected:
  Lines when(const std::string& from, const std::string& to) const { return mistakes(with(dam_break, from, to)); }
};

TEST_F(ManifestMistakes, AllAreFoundInOneGoInTheOrderOfTheFile) {
  EXPECT_EQ(mistakes(R"([case]
name = "Dam Break"
titel = "x"

[domain]
x = ["0 m", "200 kg"]
smothing_ratio = 2

[initial]
particles = { count = 400, perturbation = 0.5 }
depth = { x = [100], values = [10, "5 + y0"] }
bed = 0

[plugins.equations]
id = "shallow-water"

[plugins.kernel]
id = "cubic-splin"

[plugins.viscosity]
id = "monaghan"
alpha = -1

[time]
end = "6 min"
)",
                     {"output.pictures=false"}),
            (Lines{
                "case.toml:2:8: case.name must be a word of a-z, 0-9, - and . that begins with a letter or digit, got "
                "\"Dam Break\"; did you mean \"dam-break\"?",
                "case.toml:3:1: unknown key \"titel\" in [case]; did you mean \"title\"?",
                "case.toml:6:13: domain.x[1] must be a length [m], got \"200 kg\", which is a mass",
                "case.toml:7:1: unknown key \"smothing_ratio\" in [domain]; did you mean \"smoothing_ratio\"?",
                "case.toml:10:43: initial.particles.perturbation must be a number of at least 0 and below 0.5, got 0.5",
                "case.toml:11:41: initial.depth.values[1]: the formula \"5 + y0\" does not parse at character 5: "
                "unexpected token \"y0\"; did you mean \"y\"?",
                "case.toml:12:1: equations \"shallow-water\" has no initial field \"bed\"; did you mean \"bed_level\"?",
                "case.toml:18:6: unknown kernel plugin \"cubic-splin\"; did you mean \"cubic-spline\"?",
                "case.toml:22:9: plugins.viscosity.alpha must be a number from 0 to 100, got -1",
                "--set output.pictures=false: unknown key \"pictures\" in [output]; did you mean \"picture\"?",
            }));
}

TEST_F(ManifestMistakes, AFileThatIsNotThereOrNoTomlIsSaidAtOnce) {
  try {
    read_case(folder_ / "absent.toml", {}, catalogue_);
    FAIL() << "a missing file was read";
  } catch (const ManifestError& error) {
    EXPECT_EQ(error.lines(), (Lines{(folder_ / "absent.toml").string() + ": no such manifest"}));
    EXPECT_EQ(std::string(error.what()), error.lines().front());
  }
  EXPECT_THROW(read_case(folder_, {}, catalogue_), ManifestError);
  EXPECT_EQ(
      when("end = 6", "end = 6 s"),
      (Lines{"case.toml:23:9: not valid TOML: parsing key-value pair: expected a comment or whitespace, saw 's'"}));
  EXPECT_EQ(when("[time]", "[case]"),
            (Lines{"case.toml:22:1: not valid TOML: parsing table header: cannot redefine existing table 'case'"}));
}

TEST_F(ManifestMistakes, AnEmptyManifestIsToldWhatItNeeds) {
  EXPECT_EQ(mistakes(""),
            (Lines{
                "case.toml:1:1: the table [case] is missing (what the case is called)",
                "case.toml:1:1: the table [domain] is missing (where it happens)",
                "case.toml:1:1: the table [initial] is missing (particles and fields at t = 0)",
                "case.toml:1:1: the table [plugins] is missing (the physics: one table [plugins.<slot>] per "
                "plugin)",
                "case.toml:1:1: the table [time] is missing (how long, and in which steps)",
            }));
}

TEST_F(ManifestMistakes, UnknownTablesAndKeysGetTheNearestName) {
  EXPECT_EQ(when("[time]", "[tiem]"), (Lines{"case.toml:22:2: unknown table \"tiem\"; did you mean \"time\"?"}));
  EXPECT_EQ(
      when("end = 6", "end = 6\nduration = 3"),
      (Lines{"case.toml:24:1: unknown key \"duration\" in [time]; it takes \"end\", \"cfl\", \"step\", \"max_step\", "
             "\"max_steps\", \"integrator\" and \"drag\""}));
  EXPECT_EQ(when("count = 400", "count = 400, placment = \"equal-volume\""),
            (Lines{"case.toml:9:28: unknown key \"placment\" in [initial.particles]; did you mean \"placement\"?"}));
  EXPECT_EQ(mistakes("title = 3\n" + dam_break),
            (Lines{"case.toml:1:1: unknown key \"title\"; did you mean \"time\"?"}));
  EXPECT_EQ(when("[case]\nname = \"dam-break\"", "case = 5"),
            (Lines{"case.toml:1:1: case must be a table [case], got 5"}));
}

TEST_F(ManifestMistakes, WrongTypesSayTheRuleAndTheValue) {
  EXPECT_EQ(when("name = \"dam-break\"", "name = 5"),
            (Lines{"case.toml:2:8: case.name must be a text in quotes, got 5"}));
  EXPECT_EQ(when("name = \"dam-break\"", "name = \" Wet 0.5\""),
            (Lines{"case.toml:2:8: case.name must be a word of a-z, 0-9, - and . that begins with a letter or digit, "
                   "got \" Wet 0.5\"; did you mean "
                   "\"wet-0.5\"?"}));
  EXPECT_EQ(when("x = [0, 200]", "x = 200"),
            (Lines{"case.toml:5:5: domain.x must be [low, high], each a length [m], got 200"}));
  EXPECT_EQ(when("x = [0, 200]", "x = [0, 100, 200]"),
            (Lines{"case.toml:5:5: domain.x must be [low, high], each a length [m], got an array"}));
  EXPECT_EQ(when("smoothing_ratio = 2", "smoothing_ratio = true"),
            (Lines{"case.toml:6:19: domain.smoothing_ratio must be a number above 0, got true"}));
  EXPECT_EQ(when("end = 6", "end = 1979-05-27"),
            (Lines{"case.toml:23:7: time.end must be a time above 0 s, got a date"}));
  EXPECT_EQ(when("count = 400", "count = 400.5"),
            (Lines{"case.toml:9:23: initial.particles.count must be an integer from 1 to 2147483647, got 400.5"}));
  EXPECT_EQ(when("end = 6", "end = 6\n[output]\npicture = \"yes\"\nfields = [\"depth\", 2]"),
            (Lines{"case.toml:25:11: output.picture must be true or false, got \"yes\"",
                   "case.toml:26:20: output.fields[1] must be a text in quotes, got 2"}));
  EXPECT_EQ(when("end = 6", "end = 6\ndrag = \"implicitly\""),
            (Lines{"case.toml:24:8: time.drag must be \"implicit\" or \"explicit\", got \"implicitly\"; did you mean "
                   "\"implicit\"?"}));
}

TEST_F(ManifestMistakes, ValuesOutOfRangeSayTheBoundsWithTheirUnit) {
  EXPECT_EQ(when("smoothing_ratio = 2", "smoothing_ratio = 0"),
            (Lines{"case.toml:6:19: domain.smoothing_ratio must be a number above 0, got 0"}));
  EXPECT_EQ(when("end = 6", "end = \"-1 min\""),
            (Lines{"case.toml:23:7: time.end must be a time above 0 s, got \"-1 min\""}));
  EXPECT_EQ(when("end = 6", "end = inf"),
            (Lines{"case.toml:23:7: time.end must be a time above 0 s, got inf, which is not finite"}));
  EXPECT_EQ(when("end = 6", "end = nan"),
            (Lines{"case.toml:23:7: time.end must be a time above 0 s, got nan, which is not finite"}));
  EXPECT_EQ(when("end = 6", "end = 6\n[fluid]\ndensity = 0\nviscosity = -1e-6"),
            (Lines{"case.toml:25:11: fluid.density must be a density above 0 kg.m-3, got 0",
                   "case.toml:26:13: fluid.viscosity must be a quantity of at least 0 m2.s-1, got -1e-06"}));
  EXPECT_EQ(when("x = [0, 200]", "x = [200, 0]"),
            (Lines{"case.toml:5:5: domain.x must be [low, high] with low < high, got [200, 0]"}));
}

TEST_F(ManifestMistakes, WrongMissingAndUnknownUnitsAreToldApart) {
  EXPECT_EQ(
      when("count = 400", "spacing = \"15.9 kg\""),
      (Lines{
          "case.toml:9:25: initial.particles.spacing must be a length above 0 m, got \"15.9 kg\", which is a mass"}));
  EXPECT_EQ(when("count = 400", "spacing = \"15.9 kg2\""),
            (Lines{"case.toml:9:25: initial.particles.spacing must be a length above 0 m, got \"15.9 kg2\": wrong unit "
                   "\"kg2\""}));
  EXPECT_EQ(
      when("count = 400", "spacing = \"15.9\""),
      (Lines{"case.toml:9:25: initial.particles.spacing must be a length above 0 m, got \"15.9\": missing unit; write "
             "\"15.9 m\", or 15.9 without quotes for SI"}));
  EXPECT_EQ(
      when("count = 400", "spacing = \"15.9 mmm\""),
      (Lines{"case.toml:9:25: initial.particles.spacing must be a length above 0 m, got \"15.9 mmm\": unknown unit "
             "\"mmm\"; did you mean \"mm\"?"}));
  EXPECT_EQ(when("count = 400", "spacing = \"half a metre\""),
            (Lines{"case.toml:9:25: initial.particles.spacing must be a length above 0 m, got \"half a metre\""}));
  EXPECT_EQ(when("smoothing_ratio = 2", "smoothing_ratio = \"2\""), Lines{});  // a number needs no unit
}

TEST_F(ManifestMistakes, RequiredKeysAreNamedWithTheirRule) {
  EXPECT_EQ(when("smoothing_ratio = 2", ""),
            (Lines{"case.toml:4:1: domain.smoothing_ratio is missing; it must be a number above 0"}));
  EXPECT_EQ(when("x = [0, 200]", ""),
            (Lines{"case.toml:4:1: domain.x is missing; it must be [low, high], each a length [m]"}));
  EXPECT_EQ(
      when("particles = { count = 400 }", ""),
      (Lines{
          "case.toml:8:1: initial.particles is missing; it must be a table such as { spacing = \"5 mm\" } or { count = "
          "1000 }"}));
  EXPECT_EQ(when("count = 400", ""),
            (Lines{"case.toml:9:13: initial.particles must have either spacing or count, got neither"}));
  EXPECT_EQ(when("count = 400", "count = 400, spacing = 1"),
            (Lines{"case.toml:9:15: initial.particles must have either spacing or count, got both"}));
  EXPECT_EQ(
      when("count = 400", "spacing = 1, placement = \"equal-volume\""),
      (Lines{"case.toml:9:15: initial.particles with placement = \"equal-volume\" must have count, got spacing"}));
}

TEST_F(ManifestMistakes, TheAxesMustFitTheDimension) {
  EXPECT_EQ(when("x = [0, 200]", "x = [0, 200]\nz = [0, 1]"),
            (Lines{"case.toml:6:1: domain.z does not exist with domain.dimension = 1, there is only x"}));
  EXPECT_EQ(
      when("x = [0, 200]", "x = [0, 200]\ndimension = 2\ny = [0, 1]"),
      (Lines{"case.toml:4:1: domain.z is missing; with domain.dimension = 2 it must be [low, high], each a length [m]",
             "case.toml:7:1: domain.y does not exist with domain.dimension = 2, there are only x and z",
             "case.toml:11:15: initial.particles must be placed by spacing when domain.dimension is 2, got count"}));
  EXPECT_EQ(when("x = [0, 200]", "x = [0, 200]\ndimension = 4"),
            (Lines{"case.toml:6:13: domain.dimension must be an integer from 1 to 3, got 4"}));
}

TEST_F(ManifestMistakes, PluginsMustExistAndBeOfTheirKind) {
  EXPECT_EQ(when("id = \"monaghan\"", "id = \"monagan\""),
            (Lines{"case.toml:19:6: unknown viscosity plugin \"monagan\"; did you mean \"monaghan\"?"}));
  EXPECT_EQ(
      when("id = \"monaghan\"", "id = \"superfluid\""),
      (Lines{
          "case.toml:19:6: unknown viscosity plugin \"superfluid\"; there is \"monaghan\", \"riemann\" and \"none\""}));
  EXPECT_EQ(when("id = \"monaghan\"", "id = \"manning\""),
            (Lines{"case.toml:19:6: \"manning\" is a drag, not a viscosity"}));
  EXPECT_EQ(when("id = \"monaghan\"", "id = \"shallow-water\""),
            (Lines{"case.toml:19:6: \"shallow-water\" is an equation set, not a viscosity"}));
  EXPECT_EQ(when("[plugins.viscosity]", "[plugins.filter]"),
            (Lines{"case.toml:19:6: \"monaghan\" is a viscosity, not a filter"}));
  EXPECT_EQ(
      when("id = \"monaghan\"", ""),
      (Lines{"case.toml:18:1: plugins.viscosity.id is missing; it must be \"monaghan\", \"riemann\" or \"none\""}));
  EXPECT_EQ(when("id = \"monaghan\"", "id = 3"),
            (Lines{"case.toml:19:6: plugins.viscosity.id must be a text in quotes, got 3"}));
}

TEST_F(ManifestMistakes, KindsMustExistAndAgreeWithTheNameOfTheTable) {
  EXPECT_EQ(when("[plugins.viscosity]", "[plugins.friction]"),
            (Lines{"case.toml:18:10: plugins.friction.kind is missing, as \"friction\" is no kind itself; it must be "
                   "\"equations\", \"kernel\", \"viscosity\", \"drag\", \"turbulence\", \"boundary\", \"filter\", "
                   "\"bed\", \"width\" or \"porosity\""}));
  EXPECT_EQ(when("[plugins.viscosity]", "[plugins.viscocity]"),
            (Lines{"case.toml:18:10: plugins.viscocity.kind is missing, as \"viscocity\" is no kind itself; it must be "
                   "\"equations\", \"kernel\", \"viscosity\", \"drag\", \"turbulence\", \"boundary\", \"filter\", "
                   "\"bed\", \"width\" or \"porosity\"; did you "
                   "mean [plugins.viscosity]?"}));
  EXPECT_EQ(when("[plugins.viscosity]", "[plugins.friction]\nkind = \"draag\""),
            (Lines{"case.toml:19:8: plugins.friction.kind must be \"equations\", \"kernel\", \"viscosity\", \"drag\", "
                   "\"turbulence\", \"boundary\", \"filter\", \"bed\", \"width\" or \"porosity\", got \"draag\"; did "
                   "you mean \"drag\"?"}));
  EXPECT_EQ(when("[plugins.viscosity]", "[plugins.viscosity]\nkind = \"drag\""),
            (Lines{"case.toml:19:8: plugins.viscosity.kind must be \"viscosity\", as the name of the table says, got "
                   "\"drag\""}));
  EXPECT_EQ(mistakes(dam_break + "[plugins.reference]\nid = \"stoker\"\n"),
            (Lines{"case.toml:24:10: a reference solution has a table of its own: write [reference], not "
                   "[plugins.reference]"}));
  EXPECT_EQ(mistakes(dam_break + "[plugins]\ndrag = \"manning\"\n"),
            (Lines{"case.toml:25:1: plugins.drag must be a table [plugins.drag] with an id, got \"manning\""}));
}

TEST_F(ManifestMistakes, ThereIsOneEquationSetAndOneKernel) {
  EXPECT_EQ(when("[plugins.kernel]\nid = \"cubic-spline\"", ""),
            (Lines{"case.toml:12:1: there must be exactly one kernel plugin, got none; add [plugins.kernel] with id = "
                   "\"cubic-spline\" or \"wendland-c2\""}));
  EXPECT_EQ(
      mistakes(dam_break + "[plugins.other]\nkind = \"equations\"\nid = \"shallow-water\"\n"),
      (Lines{"case.toml:24:10: there must be exactly one equations plugin, [plugins.other] is one too many beside "
             "[plugins.equations]"}));
}

TEST_F(ManifestMistakes, ParametersAreCheckedLikeKeys) {
  EXPECT_EQ(when("alpha = 2.0", "alfa = 2.0"),
            (Lines{"case.toml:20:1: viscosity \"monaghan\" has no parameter \"alfa\"; did you mean \"alpha\"?"}));
  EXPECT_EQ(
      when("alpha = 2.0", "strength = 2.0"),
      (Lines{"case.toml:20:1: viscosity \"monaghan\" has no parameter \"strength\"; it takes \"alpha\" and \"beta\""}));
  EXPECT_EQ(
      when("alpha = 2.0", "alpha = \"2 m\""),
      (Lines{
          "case.toml:20:9: plugins.viscosity.alpha must be a number from 0 to 100, got \"2 m\", which is a length"}));
  EXPECT_EQ(
      mistakes(dam_break + "[plugins.drag]\nid = \"manning\"\n"),
      (Lines{"case.toml:24:1: plugins.drag.n is missing; drag \"manning\" needs it, it must be a quantity from 0 to 1 "
             "s.m-1/3"}));
  EXPECT_EQ(
      mistakes(dam_break + "[plugins.drag]\nid = \"manning\"\nn = \"0.03\"\n"),
      (Lines{"case.toml:26:5: plugins.drag.n must be a quantity from 0 to 1 s.m-1/3, got \"0.03\": missing unit; write "
             "\"0.03 s.m-1/3\", or 0.03 without quotes for SI"}));
  EXPECT_EQ(mistakes(dam_break + "[plugins.inlet]\nkind = \"boundary\"\nid = \"inflow\"\nrecord = \"absent.txt\"\n"),
            (Lines{"case.toml:27:10: plugins.inlet.record: no such file \"absent.txt\""}));
}

TEST_F(ManifestMistakes, ADefaultThatTheCaseDoesNotHaveMustBeGiven) {
  EXPECT_EQ(
      mistakes(dam_break + "[plugins.top]\nkind = \"boundary\"\nid = \"lid\"\n"),
      (Lines{
          "case.toml:24:1: plugins.top.roof is missing; it must be a length [m] (its default domain.z_max is not known "
          "here)"}));
}

TEST_F(ManifestMistakes, AnInheritedValueMustSuitTheParameterToo) {
  EXPECT_EQ(when("end = 6", "end = 6\n[fluid]\ngravity = 0"),
            (Lines{"case.toml:12:1: plugins.equations.gravity must be an acceleration above 0 m.s-2, got 0 from "
                   "fluid.gravity"}));
}

TEST_F(ManifestMistakes, AMistakeIsNotRepeatedForWhatDependsOnIt) {
  EXPECT_EQ(when("end = 6", "end = 6\n[fluid]\ngravity = \"fast\""),
            (Lines{"case.toml:25:11: fluid.gravity must be an acceleration of at least 0 m.s-2, got \"fast\""}));
  EXPECT_EQ(when("id = \"shallow-water\"", "id = \"shalow-water\""),
            (Lines{"case.toml:13:6: unknown equations plugin \"shalow-water\"; did you mean \"shallow-water\"?"}));
}

TEST_F(ManifestMistakes, AnUnknownEquationSetDoesNotHideMistakesInItsFields) {
  EXPECT_EQ(mistakes(with(with(dam_break, "\"shallow-water\"", "\"shalow-water\""), "[10, 5]", "[10, \"5 s\"]")),
            (Lines{"case.toml:10:36: initial.depth.values[1] must be a length [m], got \"5 s\", which is a time",
                   "case.toml:13:6: unknown equations plugin \"shalow-water\"; did you mean \"shallow-water\"?"}));
}

TEST_F(ManifestMistakes, InitialFieldsMustBeThoseOfTheEquationSet) {
  EXPECT_EQ(
      when("depth =", "dept ="),
      (Lines{"case.toml:10:1: equations \"shallow-water\" has no initial field \"dept\"; did you mean \"depth\"?"}));
  EXPECT_EQ(when("depth =", "salinity = 3\ndepth ="),
            (Lines{"case.toml:10:1: equations \"shallow-water\" has no initial field \"salinity\"; it knows \"depth\", "
                   "\"velocity\", \"bed_level\", \"porosity\", \"level\", \"particles\" and \"inside\""}));
  EXPECT_EQ(when("depth = { x = [100], values = [10, 5] }", ""),
            (Lines{"case.toml:8:1: initial.depth is missing; equations \"shallow-water\" needs it [m]"}));
  EXPECT_EQ(when("depth =", "porosity = -0.5\ndepth ="),
            (Lines{"case.toml:10:12: initial.porosity must not be negative, got -0.5"}));
  EXPECT_EQ(when("depth =", "velocity = [1, 2]\ndepth ="),
            (Lines{"case.toml:10:12: initial.velocity must be an array of 1 function, one per component, got 2"}));
}

TEST_F(ManifestMistakes, APlaneWantsTwoComponentsAPluginForItAndAnIntegratorThatSuits) {
  EXPECT_EQ(
      mistakes(R"([case]
name = "plane"
[domain]
dimension = 2
x = [0, 1]
z = [0, 1]
smoothing_ratio = 1.2
[initial]
particles = { count = 400, placement = "equal-volume" }
velocity = 3
inside = "y"
[plugins.equations]
id = "compressible"
sound_speed = 0
[plugins.kernel]
id = "wendland-c2"
[time]
end = 1
integrator = "leap-frog"
[reference]
id = "stoker"
)"),
      (Lines{
          "case.toml:8:1: initial.density is missing; equations \"compressible\" needs it [kg.m-3]",
          "case.toml:9:15: initial.particles must be placed by spacing when domain.dimension is 2, got count",
          "case.toml:10:12: initial.velocity must be an array of 2 functions (x, z), one per component, got 3",
          "case.toml:11:10: initial.inside uses y, but with domain.dimension = 2 there are only x and z",
          "case.toml:14:15: plugins.equations.sound_speed must be a velocity above 0 m.s-1, got 0",
          "case.toml:19:14: time.integrator must be \"predictor-corrector\" or \"semi-implicit-euler\" with equations "
          "\"compressible\", got \"leap-frog\"",
          "case.toml:21:6: reference \"stoker\" works in dimension 1 only, domain.dimension is 2",
      }));
  EXPECT_EQ(when("\"cubic-spline\"", "\"wendland-c2\""),
            (Lines{"case.toml:16:6: kernel \"wendland-c2\" works in dimension 2 and 3 only, domain.dimension is 1"}));
}

TEST_F(ManifestMistakes, AReferenceIsCheckedLikeAPlugin) {
  EXPECT_EQ(mistakes(dam_break + R"([reference]
id = "stocker"
)"),
            (Lines{"case.toml:25:6: unknown reference plugin \"stocker\"; did you mean \"stoker\"?"}));
  EXPECT_EQ(mistakes(dam_break + R"([reference]
id = "stoker"
h_lft = 3
ignore_below = { dept = 1, depth = "1 s" }
region = [5, 1]
)"),
            (Lines{"case.toml:26:1: reference \"stoker\" has no parameter \"h_lft\"; did you mean \"h_left\"?",
                   "case.toml:27:18: reference \"stoker\" gives no field \"dept\"; did you mean \"depth\"?",
                   "case.toml:27:36: reference.ignore_below.depth must be a length [m], got \"1 s\", which is a time",
                   "case.toml:28:10: reference.region must be [low, high] with low < high, got [5, 1]"}));
  EXPECT_EQ(mistakes(dam_break + "[reference]\nid = \"stoker\"\nignore_below = 3\n"),
            (Lines{"case.toml:26:16: reference.ignore_below must be a table such as { depth = \"1 mm\" }, got 3"}));
}

}  // namespace
}  // namespace riffle::test
