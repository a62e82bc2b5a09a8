#include <fmt/format.h>

#include <algorithm>

#include "host/manifest/keys.hpp"
#include "host/manifest/nearest.hpp"
#include "host/manifest/sections.hpp"
#include "host/manifest/tables.hpp"
#include "host/manifest/values.hpp"

namespace riffle {
namespace {

// Fields that shall begin as the reference has them: there must be one, and it must give them.
void check_initial_fields(Reading& reading, const PluginDescription* reference) {
  for (const std::string& name : reading.result.initial_from_reference) {
    const SourcePlace& place = reading.root.find("initial")->value.find(name)->value.place;
    if (reference == nullptr) {
      reading.mistakes.add(place, fmt::format("initial.{} = \"reference\" needs the table [reference]", name));
      continue;
    }
    const bool given = std::any_of(reference->gives.begin(), reference->gives.end(),
                                   [&](const FieldDescription& field) { return field.name == name; });
    if (!given) {
      reading.mistakes.add(place, fmt::format("initial.{}: reference \"{}\" gives no {}", name, reference->id, name));
    }
  }
}

}  // namespace

void read_reference(Reading& reading) {
  const TomlNode* const table = find_table(reading, "reference");
  if (table == nullptr) {
    check_initial_fields(reading, nullptr);
    reading.effective.erase("reference");
    return;
  }
  nlohmann::ordered_json& effective = reading.effective["reference"];
  auto plugin = read_plugin(reading, *table, "reference", "reference", {"ignore_below", "region"}, effective);
  ReferenceControl control;
  if (const TomlEntry* const region = table->find("region")) {
    control.region = read_interval(reading, region->value, "reference.region", manifest_key("reference.region").value);
    if (control.region) effective["region"] = *control.region;
  }
  const TomlEntry* const limits = table->find("ignore_below");
  if (limits != nullptr && !limits->value.is_table()) {
    reading.mistakes.add(limits->value.place,
                         fmt::format("reference.ignore_below must be a table such as {{ depth = \"1 "
                                     "mm\" }}, got {}",
                                     limits->value.shown()));
  } else if (limits != nullptr && plugin) {
    std::vector<std::string> fields;
    for (const FieldDescription& field : plugin->description->gives) fields.push_back(field.name);
    for (const TomlEntry& entry : limits->value.entries) {
      const auto field = std::find(fields.begin(), fields.end(), entry.key);
      if (field == fields.end()) {
        std::string hint = did_you_mean(entry.key, fields);
        if (hint.empty()) hint = "; it gives " + all_of(fields);
        reading.mistakes.add(entry.place,
                             fmt::format("reference \"{}\" gives no field \"{}\"{}", plugin->id, entry.key, hint));
        continue;
      }
      ParameterDescription limit;
      limit.name = entry.key;
      limit.unit = plugin->description->gives[static_cast<std::size_t>(field - fields.begin())].unit;
      if (const auto value = read_real(reading, entry.value, "reference.ignore_below." + entry.key, limit)) {
        control.ignore_below[entry.key] = *value;
        effective["ignore_below"][entry.key] = *value;
      }
    }
  }
  if (!plugin) return;
  check_initial_fields(reading, plugin->description);
  control.plugin = std::move(*plugin);
  reading.result.reference = std::move(control);
}

}  // namespace riffle
