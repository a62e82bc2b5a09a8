#include <fmt/format.h>

#include <algorithm>

#include "host/manifest/keys.hpp"
#include "host/manifest/nearest.hpp"
#include "host/manifest/rules.hpp"
#include "host/manifest/sections.hpp"
#include "host/manifest/tables.hpp"
#include "host/manifest/values.hpp"

namespace riffle {
namespace {

// The kind of a slot: its name, or its key `kind`. Empty after a mistake.
std::string kind_of_slot(Reading& reading, const TomlEntry& slot) {
  const ParameterDescription& kind = manifest_key("plugins.kind").value;
  const std::string key = "plugins." + slot.key + ".kind";
  if (slot.key == "reference") {
    reading.mistakes.add(slot.place,
                         "a reference solution has a table of its own: write [reference], not [plugins.reference]");
    return "";
  }
  const bool named = std::find(kind.choices.begin(), kind.choices.end(), slot.key) != kind.choices.end();
  const TomlEntry* const given = slot.value.find("kind");
  if (given == nullptr) {
    if (named) return slot.key;
    const std::string near = nearest(slot.key, kind.choices);
    reading.mistakes.add(
        slot.place, fmt::format("{} is missing, as \"{}\" is no kind itself; it must be {}{}", key, slot.key,
                                any_of(kind.choices), near.empty() ? "" : "; did you mean [plugins." + near + "]?"));
    return "";
  }
  const auto read = read_value(reading, given->value, key, kind);
  if (!read) return "";
  if (named && read->value.text != slot.key) {
    reading.mistakes.add(given->value.place, fmt::format("{} must be \"{}\", as the name of the table says, got {}",
                                                         key, slot.key, given->value.shown()));
    return "";
  }
  return read->value.text;
}

void check_number_of(Reading& reading, const std::string& kind, const std::vector<const TomlEntry*>& slots) {
  const TomlNode* const plugins =
      reading.root.find("plugins") != nullptr ? &reading.root.find("plugins")->value : nullptr;
  if (slots.empty()) {
    const std::vector<std::string> ids = ids_of(reading.catalogue, kind);
    reading.mistakes.add(plugins != nullptr ? plugins->place : top_of(reading),
                         fmt::format("there must be exactly one {} plugin, got none; add [plugins.{}] with id = {}",
                                     kind, kind, ids.empty() ? "..." : any_of(ids)));
  }
  for (std::size_t k = 1; k < slots.size(); ++k) {
    reading.mistakes.add(slots[k]->place,
                         fmt::format("there must be exactly one {} plugin, [plugins.{}] is one too many "
                                     "beside [plugins.{}]",
                                     kind, slots[k]->key, slots[0]->key));
  }
}

void at_most_one(Reading& reading, const std::string& kind, const std::vector<const TomlEntry*>& slots) {
  for (std::size_t k = 1; k < slots.size(); ++k) {
    reading.mistakes.add(slots[k]->place,
                         fmt::format("there must be at most one {} plugin, [plugins.{}] is one too many "
                                     "beside [plugins.{}]",
                                     kind, slots[k]->key, slots[0]->key));
  }
}

// What the equation set says it cannot be run with.
void check_refusals(Reading& reading) {
  const PluginDescription* const equations = equation_set(reading);
  if (equations == nullptr) return;
  for (const PluginChoice& plugin : reading.result.plugins) {
    for (const Refusal& refusal : equations->refuses) {
      if (refusal.kind != plugin.kind || (refusal.id.empty() ? plugin.id == "none" : refusal.id != plugin.id)) continue;
      const TomlEntry* const slot = reading.root.find("plugins")->value.find(plugin.slot);
      const TomlEntry* const id = slot->value.find("id");
      reading.mistakes.add(id != nullptr ? id->value.place : slot->place,
                           fmt::format("{} \"{}\" cannot be used with equations \"{}\": {}", plugin.kind, plugin.id,
                                       equations->id, refusal.reason));
    }
  }
}

// The integrator must be one that the equation set can bear; unless it is given, one that can is taken.
void choose_integrator(Reading& reading) {
  const PluginDescription* const equations = equation_set(reading);
  if (equations == nullptr || equations->integrators.empty()) return;
  const auto& allowed = equations->integrators;
  std::string& integrator = reading.result.time.integrator;
  if (std::find(allowed.begin(), allowed.end(), integrator) != allowed.end()) return;
  const TomlEntry* const time = reading.root.find("time");
  const TomlEntry* const given = time != nullptr ? time->value.find("integrator") : nullptr;
  if (given != nullptr) {
    reading.mistakes.add(given->value.place, fmt::format("time.integrator must be {} with equations \"{}\", got {}",
                                                         any_of(allowed), equations->id, given->value.shown()));
    return;
  }
  integrator = allowed.front();
  reading.effective["time"]["integrator"] = integrator;
}

}  // namespace

const PluginDescription* equation_set(const Reading& reading) {
  for (const PluginChoice& plugin : reading.result.plugins) {
    if (plugin.kind == "equations") return plugin.description;
  }
  return nullptr;
}

namespace {

// What the equation set is given, other plugins may take as their default: "equations.bed_slope".
void offer_to_inherit(Reading& reading, const PluginChoice& equations) {
  for (const ParameterValue& value : equations.values) {
    const auto& all = equations.description->parameters;
    const auto of = std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == value.name; });
    if (of->type == ParameterType::text || of->type == ParameterType::function) continue;
    reading.quantities["equations." + value.name] = value.number;
  }
}

}  // namespace

void read_plugins(Reading& reading) {
  std::map<std::string, std::vector<const TomlEntry*>> slots_of_kind;
  bool kind_unclear = false;
  const TomlNode* const plugins = find_table(reading, "plugins");
  if (plugins != nullptr) {
    std::vector<std::pair<const TomlEntry*, std::string>> slots;
    for (const TomlEntry& slot : plugins->entries) {
      if (!slot.value.is_table()) {
        reading.mistakes.add(slot.place, fmt::format("plugins.{} must be a table [plugins.{}] with an id, got {}",
                                                     slot.key, slot.key, slot.value.shown()));
        kind_unclear = true;
        continue;
      }
      const std::string kind = kind_of_slot(reading, slot);
      if (kind.empty()) {
        kind_unclear = kind_unclear || slot.key != "reference";
        continue;
      }
      slots_of_kind[kind].push_back(&slot);
      reading.effective["plugins"][slot.key]["kind"] = kind;
      slots.emplace_back(&slot, kind);
    }
    std::map<const TomlEntry*, std::optional<PluginChoice>> read;
    for (const bool equations : {true, false}) {  // first, because others inherit from it
      for (const auto& [slot, kind] : slots) {
        if ((kind == "equations") != equations) continue;
        auto plugin = read_plugin(reading, slot->value, "plugins." + slot->key, kind, {"kind"},
                                  reading.effective["plugins"][slot->key]);
        if (equations && plugin) offer_to_inherit(reading, *plugin);
        read[slot] = std::move(plugin);
      }
    }
    for (const auto& slot : slots) {
      if (auto& plugin = read[slot.first]) reading.result.plugins.push_back(std::move(*plugin));
    }
  }
  if (plugins != nullptr) {
    for (const char* kind : {"equations", "kernel"}) {
      // A slot of unclear kind may be the one that seems to lack.
      if (!kind_unclear || slots_of_kind[kind].size() > 1) check_number_of(reading, kind, slots_of_kind[kind]);
    }
  }
  for (const char* kind : {"bed", "width", "porosity"}) at_most_one(reading, kind, slots_of_kind[kind]);
  check_refusals(reading);
  choose_integrator(reading);
}

}  // namespace riffle
