// Every rule of a plugin's tables, each broken once.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/unit/plugins/toy.hpp"

namespace riffle {
namespace {

using test::Toy;
using Lines = std::vector<std::string>;

const std::string toy = "toy.so: drag \"toy\": ";

Lines refusal_after(const std::function<void(Toy&)>& spoil) {
  Toy it;
  spoil(it);
  return it.refusal();
}

TEST(Descriptor, AGoodOneIsAccepted) {
  Toy it;
  EXPECT_EQ(it.refusal(), Lines{});
  const PluginDescription d = it.read().front().description;
  EXPECT_EQ(d.parameters[2].choices, (std::vector<std::string>{"linear", "quadratic"}));
  EXPECT_EQ(d.parameters[3].type, ParameterType::function);
  EXPECT_EQ(d.library_path, "toy.so");
}

TEST(Descriptor, AllMistakesAreListedAtOnce) {
  EXPECT_EQ(refusal_after([](Toy& t) {
              t.plugin.id = "Toy";
              t.plugin.dims = 0x10;
              t.real.name = "Alpha";
            }),
            (Lines{"toy.so: drag \"Toy\": id \"Toy\" is not [a-z][a-z0-9-]*",
                   "toy.so: drag \"Toy\": supports dimensions 0x10; bits 1, 2 and 3 are possible",
                   "toy.so: drag \"Toy\": parameter \"Alpha\": the name is not [a-z][a-z0-9_]*"}));
}

TEST(Descriptor, TheKindIsOneOfThose) {
  EXPECT_EQ(
      refusal_after([](Toy& t) { t.plugin.kind = "friction"; }),
      Lines{"toy.so: friction \"toy\": there is no kind \"friction\"; kinds are equations, kernel, viscosity, drag, "
            "turbulence, boundary, filter, bed, width, porosity, reference"});
}

struct Rule {
  std::string name, line;
  std::function<void(Toy&)> spoil;
};
void PrintTo(const Rule& rule, std::ostream* out) {
  *out << rule.name;
}

class DescriptorRule : public testing::TestWithParam<Rule> {};

TEST_P(DescriptorRule, IsChecked) {
  EXPECT_EQ(refusal_after(GetParam().spoil), Lines{toy + GetParam().line});
}

const riffle_field speed_in_knots{sizeof(riffle_field), RIFFLE_VECTOR, 0, 0, "velocity", "m.s-2", "wrong unit"};
const riffle_read read_knots{sizeof(riffle_read), RIFFLE_AT_I, 0, 0, &speed_in_knots};
const riffle_read at_j{sizeof(riffle_read), RIFFLE_AT_J, 0, 0, &fields::velocity};
const riffle_read kernel_as_pair{sizeof(riffle_read), RIFFLE_PAIR, 0, 0, &fields::kernel};
const riffle_read distance_at_i{sizeof(riffle_read), RIFFLE_AT_I, 0, 0, &fields::distance};
const riffle_write sum_pair_field{sizeof(riffle_write), RIFFLE_SUM, 0, 0, &fields::viscous_pressure};
const riffle_write set_distance{sizeof(riffle_write), RIFFLE_SET, 0, 0, &fields::distance};
const riffle_write add_depth{sizeof(riffle_write), RIFFLE_SUM, 0, 0, &fields::depth};
const riffle_evolved wrong_rate{sizeof(riffle_evolved), 0, &fields::depth, &fields::velocity, nullptr, nullptr};
const riffle_iteration iteration{sizeof(riffle_iteration), 0, "support", &fields::depth, "coefficient", "steps"};

void make_pair_pass(Toy& t) {
  t.pass.type = RIFFLE_PASS_PAIR;
  t.votes = {nullptr};
}

const std::vector<Rule> rules{
    {"DefaultInRange", "parameter \"coefficient\": default 0 is outside (0, 1]",
     [](Toy& t) { t.real.flags = RIFFLE_ABOVE_MIN, t.real.fallback = 0; }},
    {"DefaultIsANumber", "parameter \"coefficient\": default nan is outside [0, 1]",
     [](Toy& t) { t.real.fallback = std::numeric_limits<double>::quiet_NaN(); }},
    {"RangeNotEmpty", "parameter \"coefficient\": the range [2, 1] is empty", [](Toy& t) { t.real.min = 2; }},
    {"IntegerDefaultIsWhole", "parameter \"steps\": default 2.5 of an integer is no whole number",
     [](Toy& t) { t.integer.fallback = 2.5; }},
    {"ChoicesHoldTheDefault", "parameter \"law\": default \"cubic\" is none of its choices \"linear|quadratic\"",
     [](Toy& t) { t.word.fallback_text = "cubic"; }},
    {"ChoicesDiffer", "parameter \"law\": choices \"linear|linear\" hold one word twice",
     [](Toy& t) { t.word.choices = "linear|linear"; }},
    {"UnitsParse", "parameter \"coefficient\": unit \"kg/m3\" is no product of powers such as kg.m-3",
     [](Toy& t) { t.real.unit = "kg/m3"; }},
    {"NamesDiffer", "parameter \"coefficient\": declared twice", [](Toy& t) { t.integer.name = "coefficient"; }},
    {"ManifestKeysAreTaken", "parameter \"id\": the name is taken by the manifest itself",
     [](Toy& t) { t.real.name = "id"; }},
    {"TypesAreKnown", "parameter \"coefficient\": unknown type 9", [](Toy& t) { t.real.type = 9; }},
    {"FlagsAreKnown", "parameter \"coefficient\": unknown flags 0x100", [](Toy& t) { t.real.flags = 0x100; }},
    {"CreateIsThere", "has no create function", [](Toy& t) { t.plugin.create = nullptr; }},
    {"DestroyIsThere", "has no destroy function", [](Toy& t) { t.plugin.destroy = nullptr; }},
    {"VersionIsThere", "has no version", [](Toy& t) { t.plugin.version = nullptr; }},
    {"RunIsThere", "pass \"friction\": has no run function", [](Toy& t) { t.pass.run = nullptr; }},
    {"PassesWrite", "pass \"friction\": writes nothing", [](Toy& t) { t.writes = {nullptr}; }},
    {"PassTypesAreKnown", "pass \"friction\": unknown type 7", [](Toy& t) { t.pass.type = 7; }},
    {"RolesAreKnown", "pass \"friction\": unknown particle roles", [](Toy& t) { t.pass.targets = 1U << 20U; }},
    {"ParticlePassesReadThemselves",
     "pass \"friction\" reads \"velocity\": a particle pass reads its own particle only (RIFFLE_AT_I)",
     [](Toy& t) {
       t.reads = {&at_j, nullptr}, t.votes = {nullptr};
     }},
    {"KernelNeedsALength",
     "pass \"friction\" reads \"kernel\": the kernel is read with the smoothing length of i, of j, or their mean",
     [](Toy& t) {
       make_pair_pass(t), t.reads = {&kernel_as_pair, nullptr};
     }},
    {"PairValuesAreReadAsSuch", "pass \"friction\" reads \"distance\": a value of a pair is read as RIFFLE_PAIR",
     [](Toy& t) {
       make_pair_pass(t), t.reads = {&distance_at_i, nullptr};
     }},
    {"PairValuesAreSet", "pass \"friction\" writes \"viscous_pressure\": a value of a pair is written with RIFFLE_SET",
     [](Toy& t) {
       make_pair_pass(t), t.writes = {&sum_pair_field, nullptr};
     }},
    {"ParticlePassesWriteParticles",
     "pass \"friction\" writes \"viscous_pressure\": only a pair pass writes values of pairs",
     [](Toy& t) {
       t.writes = {&sum_pair_field, nullptr};
     }},
    {"GeometryIsTheHosts", "pass \"friction\" writes \"distance\": the host itself provides this field",
     [](Toy& t) {
       make_pair_pass(t), t.writes = {&set_distance, nullptr};
     }},
    {"OnlyAccumulatingFieldsAreAddedTo",
     "pass \"friction\" writes \"depth\": only a field with RIFFLE_ACCUMULATES can be added to by several passes",
     [](Toy& t) {
       t.writes = {&add_depth, nullptr};
     }},
    {"ConditionsNameParameters", "pass \"friction\": condition \"model=linear\" names no parameter of the plugin",
     [](Toy& t) { t.pass.when = "model=linear"; }},
    {"ConditionsNameChoices",
     "pass \"friction\": condition \"law=linear|cubic\": \"cubic\" is none of the choices \"linear|quadratic\"",
     [](Toy& t) { t.pass.when = "law=linear|cubic"; }},
    {"OccasionalPassesSayWhen", "pass \"friction\": does not say how often it runs",
     [](Toy& t) { t.pass.flags = RIFFLE_OCCASIONAL; }},
    {"OnlyOccasionalPassesSayWhen", "pass \"friction\": says how often it runs, but is not RIFFLE_OCCASIONAL",
     [](Toy& t) { t.pass.every = "steps"; }},
    {"EveryIsAnInteger", "pass \"friction\": \"coefficient\" is no integer parameter of the plugin",
     [](Toy& t) { t.pass.flags = RIFFLE_OCCASIONAL, t.pass.every = "coefficient"; }},
    {"IterationsExist", "pass \"friction\": belongs to iteration \"support\", which does not exist",
     [](Toy& t) { t.pass.iteration = "support"; }},
    {"ResidualsAreWritten", "iteration \"support\": none of its passes writes its residual \"depth\"",
     [](Toy& t) {
       t.iterations = {&iteration, nullptr};
     }},
    {"RatesAreRates", "evolved field \"depth\" [m]: \"velocity\" [m.s-1] cannot be its rate",
     [](Toy& t) {
       t.evolved = {&wrong_rate, nullptr};
     }},
    {"VotesHaveAFunction", "vote \"friction\": has no function", [](Toy& t) { t.vote.limit = nullptr; }},
    {"FieldsHaveNames", "pass \"friction\" reads \"Grain\": the name is not [a-z][a-z0-9_]*",
     [](Toy& t) { t.own_field.name = "Grain", t.votes = {nullptr}; }},
};

INSTANTIATE_TEST_SUITE_P(All, DescriptorRule, testing::ValuesIn(rules),
                         [](const auto& info) { return info.param.name; });

TEST(Descriptor, ANameOfTheDictionaryMeansWhatTheDictionarySays) {
  EXPECT_EQ(
      refusal_after([](Toy& t) {
        t.reads = {&read_knots, nullptr}, t.votes = {nullptr};
      }),
      Lines{toy + "pass \"friction\" reads \"velocity\": is a vector in m.s-2 here, but the dictionary has a vector "
                  "in m.s-1"});
}

TEST(Descriptor, EachKindNeedsItsFunctions) {
  const auto refused_as = [](const char* kind) {
    const Lines lines = refusal_after([&](Toy& t) {
      t.plugin.kind = kind;
      t.passes = {nullptr};
    });
    return lines.empty() ? std::string("accepted") : lines.front().substr(lines.front().find("\": ") + 3);
  };
  EXPECT_EQ(refused_as("kernel"), "a kernel needs the functions kernel and evaluate_kernel");
  EXPECT_EQ(refused_as("reference"), "a reference needs the function evaluate_reference and fields that it gives");
  EXPECT_EQ(refused_as("boundary"), "a boundary needs one of the functions begin, edit, images, or a pass");
  EXPECT_EQ(refused_as("equations"), "equations need an evolved field");
  EXPECT_EQ(refused_as("viscosity"), "accepted") << "a viscosity may be none";
}

TEST(Descriptor, ALibraryWithoutPluginsIsRefused) {
  EXPECT_EQ(refusal_after([](Toy& t) { t.plugins = {nullptr}; }), Lines{"toy.so: holds no plugin"});
}

TEST(Descriptor, OnePluginTwiceInALibraryIsRefused) {
  EXPECT_EQ(refusal_after([](Toy& t) {
              t.plugins = {&t.plugin, &t.plugin, nullptr};
            }),
            Lines{toy + "declared twice in this library"});
}

TEST(Descriptor, ATableWithoutEndIsRefused) {
  EXPECT_EQ(refusal_after([](Toy& t) {
              t.parameters.assign(10000, &t.real);
              t.parameters.push_back(nullptr);
            }),
            Lines{"toy.so: a table of riffle_parameter does not end with a null pointer"});
}

TEST(Descriptor, ANumberWithoutADefaultMayHaveAnyFallback) {
  EXPECT_EQ(refusal_after([](Toy& t) { t.real.flags = RIFFLE_REQUIRED, t.real.fallback = -1; }), Lines{});
  EXPECT_EQ(refusal_after([](Toy& t) { t.real.inherit = "fluid.gravity", t.real.fallback = -1; }), Lines{});
}

}  // namespace
}  // namespace riffle
