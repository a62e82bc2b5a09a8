#include <fmt/format.h>

#include <algorithm>

#include "host/manifest/keys.hpp"
#include "host/manifest/nearest.hpp"
#include "host/manifest/rules.hpp"
#include "host/manifest/sections.hpp"
#include "host/manifest/values.hpp"

namespace riffle {
namespace {

std::string with_article(const std::string& kind) {
  if (kind == "equations") return "an equation set";
  return "a " + kind;
}

std::string unknown_id(const PluginCatalogue& catalogue, const std::string& kind, const std::string& id) {
  if (const std::string why = catalogue.why_missing(kind, id); !why.empty()) {
    return fmt::format("the {} plugin \"{}\" cannot be used: {}", kind, id, why);
  }
  for (const PluginDescription* plugin : catalogue.all()) {
    if (plugin->id == id)
      return fmt::format("\"{}\" is {}, not {}", id, with_article(plugin->kind), with_article(kind));
  }
  const std::vector<std::string> ids = ids_of(catalogue, kind);
  std::string hint = did_you_mean(id, ids);
  if (hint.empty()) hint = ids.empty() ? "; no plugin of this kind is installed" : "; there is " + all_of(ids);
  return fmt::format("unknown {} plugin \"{}\"{}", kind, id, hint);
}

void check_dimension(Reading& reading, const PluginDescription& plugin, const SourcePlace& place) {
  const auto& dims = plugin.dimensions;
  if (reading.dim == 0 || std::find(dims.begin(), dims.end(), reading.dim) != dims.end()) return;
  std::string list;
  for (std::size_t k = 0; k < dims.size(); ++k) {
    list += (k == 0 ? "" : k + 1 == dims.size() ? " and " : ", ") + std::to_string(dims[k]);
  }
  reading.mistakes.add(place, fmt::format("{} \"{}\" works in dimension {} only, domain.dimension is {}", plugin.kind,
                                          plugin.id, list, reading.dim));
}

}  // namespace

std::vector<std::string> ids_of(const PluginCatalogue& catalogue, const std::string& kind) {
  std::vector<std::string> ids;
  for (const PluginDescription* plugin : catalogue.all()) {
    if (plugin->kind == kind) ids.push_back(plugin->id);
  }
  return ids;
}

std::optional<PluginChoice> read_plugin(Reading& reading, const TomlNode& table, const std::string& shown,
                                        const std::string& kind, const std::vector<std::string>& besides,
                                        nlohmann::ordered_json& effective) {
  const TomlEntry* const id = table.find("id");
  if (id == nullptr) {
    const std::vector<std::string> ids = ids_of(reading.catalogue, kind);
    reading.mistakes.add(table.place, fmt::format("{}.id is missing; it must be {}", shown,
                                                  ids.empty() ? "the name of a plugin" : any_of(ids)));
    return std::nullopt;
  }
  const auto read_id = read_value(reading, id->value, shown + ".id", manifest_key("plugins.id").value);
  if (!read_id) return std::nullopt;
  const PluginDescription* const plugin = reading.catalogue.find(kind, read_id->value.text);
  if (plugin == nullptr) {
    reading.mistakes.add(id->value.place, unknown_id(reading.catalogue, kind, read_id->value.text));
    return std::nullopt;
  }
  check_dimension(reading, *plugin, id->value.place);

  PluginChoice choice;
  choice.slot = shown.substr(shown.find('.') + 1);  // all of it when there is no dot
  choice.kind = kind;
  choice.id = plugin->id;
  choice.description = plugin;
  effective["id"] = plugin->id;
  std::vector<std::string> names;
  for (const ParameterDescription& parameter : plugin->parameters) names.push_back(parameter.name);
  std::vector<std::string> known = names;
  known.insert(known.end(), besides.begin(), besides.end());
  known.push_back("id");
  for (const ParameterDescription& parameter : plugin->parameters) {
    const std::string key = shown + '.' + parameter.name;
    const TomlEntry* const given = table.find(parameter.name);
    std::optional<ReadValue> read;
    if (given != nullptr) {
      read = read_value(reading, given->value, key, parameter);
    } else if (!parameter.required) {
      read = default_value(reading, table.place, key, parameter);
    } else if (!misspelt(table, parameter.name, known)) {
      reading.mistakes.add(table.place, fmt::format("{} is missing; {} \"{}\" needs it, it must be {}", key, kind,
                                                    plugin->id, rule_in_words(parameter, reading.dim)));
    }
    if (!read) continue;
    effective[parameter.name] = read->effective;
    choice.values.push_back(read->value);
  }
  for (const TomlEntry& entry : table.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    std::string hint = did_you_mean(entry.key, known);
    if (hint.empty()) hint = names.empty() ? "; it takes no parameters" : "; it takes " + all_of(names);
    reading.mistakes.add(entry.place,
                         fmt::format("{} \"{}\" has no parameter \"{}\"{}", kind, plugin->id, entry.key, hint));
  }
  return choice;
}

}  // namespace riffle
