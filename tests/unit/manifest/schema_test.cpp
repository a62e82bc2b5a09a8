#include "host/manifest/schema.hpp"

#include <set>

#include "host/manifest/keys.hpp"
#include "tests/unit/manifest/fake_catalogue.hpp"

namespace riffle::test {
namespace {

using nlohmann::json;

class Schema : public testing::Test {
 protected:
  const FakeCatalogue catalogue_;
  const json schema_ = manifest_schema(catalogue_);

  const json& definition(const std::string& name) const { return schema_.at("definitions").at(name); }
  // The schema of one of the manifest's own keys.
  const json& key(const ManifestKey& key) const {
    if (key.table == "reference") return definition("reference:stoker").at("properties").at(key.value.name);
    if (key.table == "initial.particles") {
      return schema_.at("properties")
          .at("initial")
          .at("properties")
          .at("particles")
          .at("properties")
          .at(key.value.name);
    }
    if (key.table == "plugins") return definition("viscosity:monaghan").at("properties").at(key.value.name);
    return schema_.at("properties").at(key.table).at("properties").at(key.value.name);
  }
};

// Calls `visit` for every object of the tree.
void walk(const json& node, const std::function<void(const json&)>& visit) {
  if (node.is_object()) visit(node);
  for (const json& child : node) {
    if (child.is_structured()) walk(child, visit);
  }
}

TEST_F(Schema, IsDraft07AndClosedSoThatEditorsFindUnknownTables) {
  EXPECT_EQ(schema_.at("$schema"), "http://json-schema.org/draft-07/schema#");
  EXPECT_EQ(schema_.at("additionalProperties"), false);
  EXPECT_EQ(schema_.at("required"), (json{"case", "domain", "initial", "plugins", "time"}));
  EXPECT_EQ(schema_.at("properties").at("time").at("additionalProperties"), false);
}

TEST_F(Schema, HasEveryKeyOfTheManifestWithItsMeaning) {
  for (const ManifestKey& known : manifest_keys()) {
    if (known.path() == "plugins.id" || known.path() == "reference.id") continue;  // the plugin's own summary instead
    const std::string description = key(known).at("description").get<std::string>();
    EXPECT_EQ(description.rfind(known.value.doc, 0), 0u) << known.path();
  }
}

TEST_F(Schema, RangesAndDefaultsAreThoseOfTheReader) {
  const json& cfl = key(manifest_key("time.cfl"));
  EXPECT_EQ(cfl.at("default"), 0.5);
  EXPECT_EQ(cfl.at("anyOf")[0].at("exclusiveMinimum"), 0);
  EXPECT_EQ(cfl.at("anyOf")[1].at("$ref"), "#/definitions/quantity");
  const json& perturbation = key(manifest_key("initial.particles.perturbation"));
  EXPECT_EQ(perturbation.at("anyOf")[0].at("minimum"), 0);
  EXPECT_EQ(perturbation.at("anyOf")[0].at("exclusiveMaximum"), 0.5);
  const json& dimension = key(manifest_key("domain.dimension"));
  EXPECT_EQ(dimension.at("type"), "integer");
  EXPECT_EQ(dimension.at("maximum"), 3);
  EXPECT_EQ(key(manifest_key("time.drag")).at("enum"), (json{"implicit", "explicit"}));
  EXPECT_EQ(key(manifest_key("case.name")).at("pattern"), "^[a-z0-9][a-z0-9.-]*$");
  EXPECT_EQ(key(manifest_key("domain.x")).at("minItems"), 2);
  EXPECT_FALSE(key(manifest_key("time.step")).contains("default"));
}

TEST_F(Schema, EveryPluginHasItsParametersAndNoOthers) {
  for (const PluginDescription* plugin : catalogue_.all()) {
    const json& own = definition(plugin->kind + ':' + plugin->id);
    EXPECT_EQ(own.at("additionalProperties"), false);
    EXPECT_EQ(own.at("description"), plugin->summary);
    EXPECT_EQ(own.at("properties").at("id").at("const"), plugin->id);
    for (const ParameterDescription& parameter : plugin->parameters) {
      EXPECT_TRUE(own.at("properties").contains(parameter.name)) << plugin->id << ' ' << parameter.name;
    }
  }
  const json& alpha = definition("viscosity:monaghan").at("properties").at("alpha");
  EXPECT_EQ(alpha.at("default"), 1);
  EXPECT_EQ(alpha.at("anyOf")[0].at("maximum"), 100);
  EXPECT_EQ(alpha.at("description"), "what alpha means (from 0 to 100)");
  EXPECT_EQ(definition("drag:manning").at("required"), (json{"id", "n"}));
  EXPECT_EQ(definition("equations:shallow-water").at("properties").at("gravity").at("description"),
            "what gravity means (above 0 m.s-2); default: fluid.gravity");
}

TEST_F(Schema, TheIdOfASlotDecidesWhichParametersItTakes) {
  const json& viscosity = schema_.at("properties").at("plugins").at("properties").at("viscosity");
  EXPECT_EQ(viscosity.at("properties").at("id").at("enum"), (json{"monaghan", "riemann", "none"}));
  EXPECT_EQ(viscosity.at("allOf")[1].at("if").at("properties").at("id").at("const"), "riemann");
  EXPECT_EQ(viscosity.at("allOf")[1].at("then").at("$ref"), "#/definitions/viscosity:riemann");
  const json& any_slot = schema_.at("properties").at("plugins").at("additionalProperties");
  EXPECT_EQ(any_slot.at("required"), (json{"kind", "id"}));
}

TEST_F(Schema, TheEquationSetDecidesWhichInitialFieldsThereAre) {
  const json& rule = schema_.at("allOf")[0];
  EXPECT_EQ(rule.at("if")
                .at("properties")
                .at("plugins")
                .at("properties")
                .at("equations")
                .at("properties")
                .at("id")
                .at("const"),
            "shallow-water");
  const json& initial = rule.at("then").at("properties").at("initial");
  EXPECT_EQ(initial.at("oneOf"), json::parse(R"([{"required": ["depth"]}, {"required": ["level"]}])"));
  EXPECT_TRUE(initial.at("properties").contains("bed_level"));
  EXPECT_EQ(initial.at("additionalProperties"), false);
}

TEST_F(Schema, EveryReferenceInItLeadsToADefinition) {
  std::set<std::string> used;
  walk(schema_, [&](const json& node) {
    if (node.contains("$ref") && node.at("$ref").is_string()) used.insert(node.at("$ref").get<std::string>());
  });
  EXPECT_FALSE(used.empty());
  for (const std::string& pointer : used) {
    EXPECT_TRUE(schema_.contains(json::json_pointer(pointer.substr(1)))) << pointer;
  }
}

}  // namespace
}  // namespace riffle::test
