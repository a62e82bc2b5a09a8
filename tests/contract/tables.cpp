// What every plugin says about itself: complete, in words and units that the host and its readers can use.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>

#include "host/plugins/unit.hpp"
#include "tests/contract/loaded.hpp"

namespace riffle::contract {
namespace {

bool is_text(const char* text) {
  return text != nullptr && *text != '\0';
}
bool only(const std::string& text, const std::string& letters) {
  return text.find_first_not_of(letters) == std::string::npos;
}
const std::string small = "abcdefghijklmnopqrstuvwxyz", digits = "0123456789";

bool is_name(const char* name, const std::string& also) {
  return is_text(name) && only({name[0]}, small) && only(name, small + digits + also);
}

bool is_unit(const char* unit) {
  return is_text(unit) && parse_unit(unit).has_value();
}
void expect_sound(const riffle_field* field) {
  ASSERT_NE(field, nullptr);
  EXPECT_TRUE(is_name(field->name, "_"));
  EXPECT_TRUE(is_unit(field->unit)) << field->name;
  EXPECT_TRUE(is_text(field->meaning)) << field->name;
}

class EveryPlugin : public testing::TestWithParam<Loaded> {
 protected:
  const riffle_plugin& plugin = *GetParam().plugin;
};

TEST_P(EveryPlugin, SaysWhatItIsWhereItComesFromAndWhatItLeavesOut) {
  EXPECT_TRUE(is_name(plugin.id, "-"));
  int major = -1, minor = -1, patch = -1, end = 0;
  EXPECT_EQ(std::sscanf(plugin.version, "%d.%d.%d%n", &major, &minor, &patch, &end), 3) << plugin.version;
  EXPECT_EQ(static_cast<std::size_t>(end), std::string(plugin.version).size()) << plugin.version;
  EXPECT_TRUE(is_text(plugin.summary));
  EXPECT_EQ(std::string(plugin.summary).find('\n'), std::string::npos);
  EXPECT_TRUE(is_text(plugin.source));
  EXPECT_NE(plugin.leaves_out, nullptr);
  const std::set<std::string> kinds{"equations", "kernel", "viscosity", "drag",     "turbulence", "boundary",
                                    "filter",    "bed",    "width",     "porosity", "reference"};
  EXPECT_EQ(kinds.count(plugin.kind), 1u) << plugin.kind;
  EXPECT_NE(plugin.dims & 0xEu, 0u);
}

TEST_P(EveryPlugin, IsAloneWithItsIdInItsKind) {
  int namesakes = 0;
  for (const Loaded& other : plugins_of(plugin.kind)) namesakes += std::string(other.plugin->id) == plugin.id;
  EXPECT_EQ(namesakes, 1);
}

TEST_P(EveryPlugin, ExplainsEachParameterAndHasItsDefaultInRange) {
  for (const riffle_parameter* p : entries(plugin.parameters)) {
    EXPECT_TRUE(is_name(p->name, "_"));
    EXPECT_TRUE(is_unit(p->unit)) << p->name;
    EXPECT_TRUE(is_text(p->doc)) << p->name;
    EXPECT_TRUE(p->inherit == nullptr || std::string(p->inherit).find('.') != std::string::npos) << p->name;
    const bool has_default = (p->flags & RIFFLE_REQUIRED) == 0 && p->inherit == nullptr;
    if ((p->type != RIFFLE_REAL && p->type != RIFFLE_INTEGER) || !has_default) continue;
    EXPECT_TRUE(std::isfinite(p->fallback)) << p->name;
    EXPECT_TRUE((p->flags & RIFFLE_ABOVE_MIN) != 0 ? p->fallback > p->min : p->fallback >= p->min) << p->name;
    EXPECT_TRUE((p->flags & RIFFLE_BELOW_MAX) != 0 ? p->fallback < p->max : p->fallback <= p->max) << p->name;
  }
}

TEST_P(EveryPlugin, NamesSoundFieldsWithUnits) {
  for (const riffle_pass* pass : entries(plugin.passes)) {
    EXPECT_TRUE(is_text(pass->name));
    for (const riffle_read* read : entries(pass->reads)) expect_sound(read->field);
    for (const riffle_write* write : entries(pass->writes)) expect_sound(write->field);
    EXPECT_FALSE(entries(pass->writes).empty()) << pass->name;
    EXPECT_TRUE(pass->type == RIFFLE_PASS_GLOBAL ? pass->run_global != nullptr : pass->run != nullptr) << pass->name;
  }
  for (const riffle_vote* vote : entries(plugin.votes)) {
    EXPECT_TRUE(is_text(vote->name));
    EXPECT_NE(vote->limit, nullptr);
    for (const riffle_read* read : entries(vote->reads)) expect_sound(read->field);
  }
  for (const riffle_field* field : entries(plugin.gives)) expect_sound(field);
  for (const riffle_field* field : entries(plugin.initial)) expect_sound(field);
}

TEST_P(EveryPlugin, WritesTheRateOfEachFieldThatItEvolves) {
  for (const riffle_evolved* evolved : entries(plugin.evolved)) {
    expect_sound(evolved->field);
    expect_sound(evolved->rate);
    const std::string rate = evolved->rate->name;
    bool written = false;
    for (const riffle_evolved* other : entries(plugin.evolved)) written = written || rate == other->field->name;
    for (const riffle_pass* pass : entries(plugin.passes)) {
      for (const riffle_write* write : entries(pass->writes)) written = written || rate == write->field->name;
    }
    EXPECT_TRUE(written) << rate << ", the rate of " << evolved->field->name;
  }
}

TEST_P(EveryPlugin, HasTheFunctionsOfItsKind) {
  const std::string kind = plugin.kind;
  EXPECT_NE(plugin.create, nullptr);
  EXPECT_NE(plugin.destroy, nullptr);
  EXPECT_EQ(plugin.kernel != nullptr, kind == "kernel");
  EXPECT_EQ(plugin.evaluate_kernel != nullptr, kind == "kernel");
  EXPECT_EQ(plugin.evaluate_reference != nullptr, kind == "reference");
  EXPECT_EQ(plugin.evaluate_profile != nullptr, kind == "bed" || kind == "width");
  EXPECT_EQ(entries(plugin.gives).empty(), kind != "reference");
  EXPECT_EQ(entries(plugin.evolved).empty(), kind != "equations");
}

INSTANTIATE_TEST_SUITE_P(Tables, EveryPlugin, testing::ValuesIn(all_plugins()),
                         [](const auto& info) { return test_name(info.param); });

TEST(Libraries, AreWhatTheFoundationPromises) {
  const std::vector<std::pair<std::string, std::string>> promised{
      {"kernel", "cubic-spline"}, {"kernel", "quintic-spline"}, {"kernel", "wendland-c2"}, {"kernel", "wendland-c4"},
      {"kernel", "gaussian"},     {"viscosity", "monaghan"},    {"viscosity", "none"},     {"boundary", "mirror-wall"},
      {"reference", "ritter"},    {"reference", "stoker"}};
  for (const auto& [kind, id] : promised) EXPECT_NO_THROW(plugin(kind, id)) << kind << " " << id;
}

TEST(Viscosity, NoneCostsNothingBecauseItHasNoPass) {
  EXPECT_TRUE(entries(plugin("viscosity", "none").passes).empty());
  EXPECT_NO_THROW(Instance(plugin("viscosity", "none"), 1));
}

}  // namespace
}  // namespace riffle::contract
