#include "host/manifest/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "host/manifest/keys.hpp"
#include "host/manifest/rules.hpp"

namespace riffle {
namespace {

using nlohmann::json;

json reference_to(const std::string& definition) {
  return {{"$ref", "#/definitions/" + definition}};
}

// The names of definitions stand in JSON pointers, where "/" and "~" would need escapes; ids have neither.
std::string definition_of(const PluginDescription& plugin) {
  return plugin.kind + ':' + plugin.id;
}

json bounded(const std::string& type, const ParameterDescription& parameter) {
  json schema = {{"type", type}};
  const AllowedRange range = range_of(parameter);
  if (range.has_min) schema[range.above_min ? "exclusiveMinimum" : "minimum"] = range.min;
  if (range.has_max) schema[range.below_max ? "exclusiveMaximum" : "maximum"] = range.max;
  return schema;
}

// A choice among sets ("B1+B2") may also be an array of their words.
json choice_schema(const ParameterDescription& parameter) {
  const json word = {{"type", "string"}, {"enum", parameter.choices}};
  const bool sets = std::any_of(parameter.choices.begin(), parameter.choices.end(),
                                [](const std::string& c) { return c.find('+') != std::string::npos; });
  if (!sets) return word;
  return {{"anyOf", {word, {{"type", "array"}, {"items", {{"type", "string"}}}, {"uniqueItems", true}}}}};
}

json value_schema(const ParameterDescription& parameter) {
  switch (parameter.type) {
    case ParameterType::real: return {{"anyOf", {bounded("number", parameter), reference_to("quantity")}}};
    case ParameterType::integer: return bounded("integer", parameter);
    case ParameterType::boolean: return {{"type", "boolean"}};
    case ParameterType::choice: return choice_schema(parameter);
    case ParameterType::text: return {{"type", "string"}};
    case ParameterType::function: break;
  }
  return {{"anyOf", {reference_to("function")}}};  // draft-07 ignores what stands beside a bare $ref
}

std::string description_of(const ParameterDescription& parameter) {
  const bool has_unit = !parameter.unit.empty() && parameter.unit != "1";
  std::string text = parameter.doc;
  const std::string bounds = bounds_in_words(parameter);
  if (!bounds.empty()) {
    text += " (" + bounds + ")";
  } else if (has_unit) {
    text += " [" + parameter.unit + "]";
  }
  if (!parameter.inherit.empty()) text += "; default: " + parameter.inherit;
  return text;
}

json parameter_schema(const ParameterDescription& parameter, bool has_default) {
  json schema = value_schema(parameter);
  schema["description"] = description_of(parameter);
  if (!has_default || parameter.required || !parameter.inherit.empty()) return schema;
  switch (parameter.type) {
    case ParameterType::boolean: schema["default"] = parameter.fallback != 0; break;
    case ParameterType::integer: schema["default"] = static_cast<std::int64_t>(parameter.fallback); break;
    case ParameterType::choice:
    case ParameterType::text: schema["default"] = parameter.fallback_text; break;
    default: schema["default"] = parameter.fallback; break;
  }
  return schema;
}

json key_schema(const ManifestKey& key) {
  json schema = parameter_schema(key.value, !key.optional && key.form == ManifestKey::Form::single);
  const json description = schema["description"];
  if (!key.pattern.empty()) schema["pattern"] = "^" + key.pattern + "$";
  if (key.form == ManifestKey::Form::single) return schema;
  schema.erase("description");
  json formed;
  switch (key.form) {
    case ManifestKey::Form::interval:
      formed = {{"type", "array"}, {"items", schema}, {"minItems", 2}, {"maxItems", 2}};
      break;
    case ManifestKey::Form::words: formed = {{"type", "array"}, {"items", schema}, {"default", json::array()}}; break;
    default: formed = {{"type", "object"}, {"additionalProperties", schema}}; break;
  }
  formed["description"] = description;
  return formed;
}

json closed_object(const json& properties, const std::vector<std::string>& required) {
  json schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  return schema;
}

json table_schema(const std::string& table) {
  json properties = json::object();
  std::vector<std::string> required;
  for (const ManifestKey* key : keys_of(table)) {
    properties[key->value.name] = key_schema(*key);
    if (key->value.required) required.push_back(key->value.name);
  }
  return closed_object(properties, required);
}

json function_schema() {
  const json axis = {{"type", "array"}, {"items", reference_to("constant")}, {"minItems", 1}};
  const json column = {{"type", "string"}};
  json pieces = json::object(), table = json::object(), one_axis = json::array();
  for (const char* name : {"x", "y", "z", "t"}) {
    pieces[name] = axis;
    table[name] = column;
    one_axis.push_back({{"required", {name}}});
  }
  pieces["values"] = {{"type", "array"},
                      {"items", {{"type", {"number", "string"}}}},
                      {"minItems", 2},
                      {"description", "one value more than there are breaks; quantities or formulas"}};
  table["csv"] = {{"type", "string"}, {"description", "file, relative to the manifest's folder"}};
  table["value"] = {{"type", "string"}, {"description", "column of the values"}};
  table["outside"] = {{"enum", {"constant", "error"}}, {"default", "constant"}};
  json piecewise = closed_object(pieces, {"values"}), csv = closed_object(table, {"csv", "value"});
  piecewise["oneOf"] = one_axis;
  csv["oneOf"] = one_axis;
  return {{"description", "a quantity, a formula in x, y, z and t, piecewise values, or a table in CSV"},
          {"anyOf", {{{"type", "number"}}, {{"type", "string"}}, piecewise, csv}}};
}

// What a plugin adds to its table; `own` are the keys that the table has besides.
json plugin_schema(const PluginDescription& plugin, json own) {
  std::vector<std::string> required{"id"};
  own["id"] = {{"const", plugin.id}, {"description", plugin.summary}};
  for (const ParameterDescription& parameter : plugin.parameters) {
    own[parameter.name] = parameter_schema(parameter, true);
    if (parameter.required) required.push_back(parameter.name);
  }
  json schema = closed_object(own, required);
  schema["description"] = plugin.summary;
  return schema;
}

// A table whose id decides about the rest.
json choice_of_plugins(const std::vector<const PluginDescription*>& plugins) {
  json ids = json::array(), cases = json::array();
  for (const PluginDescription* plugin : plugins) {
    ids.push_back(plugin->id);
    cases.push_back({{"if", {{"properties", {{"id", {{"const", plugin->id}}}}}, {"required", {"id"}}}},
                     {"then", reference_to(definition_of(*plugin))}});
  }
  json schema = {{"type", "object"}, {"required", {"id"}}};
  if (plugins.empty()) return schema;
  schema["properties"]["id"]["enum"] = ids;
  schema["allOf"] = cases;
  return schema;
}

class SchemaWriter {
 public:
  explicit SchemaWriter(const PluginCatalogue& catalogue) {
    for (const PluginDescription* plugin : catalogue.all()) plugins_[plugin->kind].push_back(plugin);
  }

  json write() {
    json properties = json::object();
    std::vector<std::string> required;
    for (const ManifestTable& table : manifest_tables()) {
      if (table.required) required.push_back(table.name);
      json schema = table.name == "plugins"     ? slots()
                    : table.name == "reference" ? choice_of_plugins(plugins_["reference"])
                                                : table_schema(table.name);
      schema["description"] = table.doc;
      properties[table.name] = schema;
    }
    json particles = table_schema("initial.particles");
    particles["oneOf"] = {{{"required", {"spacing"}}}, {{"required", {"count"}}}};
    particles["description"] = "how particles are placed at t = 0";
    properties["initial"]["properties"]["particles"] = particles;
    properties["initial"]["required"] = {"particles"};
    // Without knowing the equation set: any field. `initial_of_equations` narrows this down.
    properties["initial"]["additionalProperties"] = reference_to("components");

    json schema = closed_object(properties, required);
    schema["$schema"] = "http://json-schema.org/draft-07/schema#";
    schema["title"] = "Riffle manifest";
    schema["definitions"] = definitions();
    const json narrowed = initial_of_equations();
    if (!narrowed.empty()) schema["allOf"] = narrowed;
    return schema;
  }

 private:
  static std::vector<std::string> slot_kinds() { return manifest_key("plugins.kind").value.choices; }

  // [plugins.viscosity] is of kind viscosity; any other slot names its kind.
  json slots() {
    json named = json::object(), cases = json::array();
    for (const std::string& kind : slot_kinds()) {
      json schema = choice_of_plugins(plugins_[kind]);
      cases.push_back(
          {{"if", {{"properties", {{"kind", {{"const", kind}}}}}, {"required", {"kind"}}}}, {"then", schema}});
      schema["properties"]["kind"] = {{"const", kind}};
      schema["description"] = "the " + kind + " plugin";
      named[kind] = schema;
    }
    const json other = {{"type", "object"},
                        {"required", {"kind", "id"}},
                        {"properties", {{"kind", key_schema(manifest_key("plugins.kind"))}}},
                        {"allOf", cases}};
    return {{"type", "object"}, {"properties", named}, {"additionalProperties", other}};
  }

  json definitions() {
    json all = {
        {"quantity",
         {{"type", "string"},
          {"pattern", R"(^\s*[+-]?\.?\d)"},
          {"description", "a number with its unit, such as \"15.9 mm\""}}},
        {"constant", {{"anyOf", {{{"type", "number"}}, reference_to("quantity")}}}},
        {"function", function_schema()},
        {"components",
         {{"anyOf",
           {reference_to("function"), {{"type", "array"}, {"items", reference_to("function")}, {"minItems", 1}}}}}}};
    for (const auto& [kind, plugins] : plugins_) {
      json own = json::object();
      if (kind == "reference") {
        for (const ManifestKey* key : keys_of("reference")) own[key->value.name] = key_schema(*key);
      } else {
        own["kind"] = {{"const", kind}, {"description", manifest_key("plugins.kind").value.doc}};
      }
      for (const PluginDescription* plugin : plugins) all[definition_of(*plugin)] = plugin_schema(*plugin, own);
    }
    return all;
  }

  // Which fields [initial] takes, for manifests whose equation set stands in [plugins.equations].
  json initial_of_equations() {
    json cases = json::array();
    for (const PluginDescription* plugin : plugins_["equations"]) {
      json fields = {{"particles", json::object()}, {"inside", json::object()}};
      std::vector<std::string> needed;
      for (const FieldDescription& field : plugin->initial) {
        fields[field.name] = {{"anyOf", {reference_to(field.shape == Shape::scalar ? "function" : "components")}},
                              {"description", fmt::format("{} [{}]", field.meaning, field.unit)}};
        if (field.name == "depth") {
          fields["level"] = key_schema(manifest_key("initial.level"));
        } else if (field.needed) {
          needed.push_back(field.name);
        }
      }
      json initial = {{"properties", fields}, {"additionalProperties", false}};
      if (!needed.empty()) initial["required"] = needed;
      if (fields.contains("level")) initial["oneOf"] = {{{"required", {"depth"}}}, {{"required", {"level"}}}};
      const json chosen = {{"properties", {{"id", {{"const", plugin->id}}}}}, {"required", {"id"}}};
      const json slot = {{"properties", {{"equations", chosen}}}, {"required", {"equations"}}};
      cases.push_back({{"if", {{"properties", {{"plugins", slot}}}, {"required", {"plugins"}}}},
                       {"then", {{"properties", {{"initial", initial}}}}}});
    }
    return cases;
  }

  std::map<std::string, std::vector<const PluginDescription*>> plugins_;
};

}  // namespace

nlohmann::json manifest_schema(const PluginCatalogue& catalogue) {
  return SchemaWriter(catalogue).write();
}

}  // namespace riffle
