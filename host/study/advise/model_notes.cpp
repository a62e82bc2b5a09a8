#include "host/study/advise/model_notes.hpp"

#include <algorithm>
#include <filesystem>

#include "host/manifest/document.hpp"

namespace riffle {
namespace {

std::filesystem::path notes_file(const PluginDescription& plugin) {
  return std::filesystem::path(plugin.library_path).replace_extension(".model.toml");
}

// Words stand without quotes, as one would type them.
std::string typed(const TomlNode& value) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyz0123456789-";
  const std::string& text = value.text;
  const bool word = value.is_text() && !text.empty() && text.find_first_not_of(plain) == std::string::npos &&
                    text.front() >= 'a' && text != "true" && text != "false" && text != "inf" && text != "nan";
  return word ? text : value.as_toml();
}

void add_changes(const TomlNode& table, const std::string& prefix, Overrides& changes) {
  for (const TomlEntry& entry : table.entries) {
    const std::string key = prefix.empty() ? entry.key : prefix + '.' + entry.key;
    if (entry.value.is_table() && !entry.value.in_braces) {
      add_changes(entry.value, key, changes);
    } else {
      changes.push_back(key + '=' + typed(entry.value));
    }
  }
}

ModelNotes read_notes(const PluginDescription& plugin, const std::filesystem::path& file) {
  ModelNotes notes;
  notes.plugin = &plugin;
  Mistakes mistakes;
  for (const TomlEntry& entry : read_document(file).entries) {
    const TomlNode& value = entry.value;
    if (entry.key == "keeps" && value.is_array()) {
      for (const TomlNode& item : value.items) notes.keeps.push_back(item.text);
    } else if (entry.key == "contains" && value.is_array()) {
      for (const TomlNode& item : value.items) notes.contains.push_back(item.text);
    } else if (entry.key == "from" && value.is_table()) {
      for (const TomlEntry& one : value.entries) notes.from.emplace_back(one.key, one.value.text);
    } else if (entry.key == "remark_where_water_breaks" && value.is_text()) {
      notes.remark_where_water_breaks = value.text;
    } else if (entry.key == "preference" && value.is_number()) {
      notes.preference = value.number;
    } else if (entry.key == "cells_per_depth" && value.is_number()) {
      notes.cells_per_depth = value.number;
    } else if (entry.key == "needs_water_everywhere" && value.type == TomlNode::Type::boolean) {
      notes.needs_water_everywhere = value.boolean;
    } else if (entry.key == "set" && value.is_table()) {
      add_changes(value, "", notes.set);
    } else if (entry.key == "set_where_water_breaks" && value.is_table()) {
      add_changes(value, "", notes.set_where_water_breaks);
    } else {
      mistakes.add(
          entry.place,
          "notes of a model have keeps and contains (words), from (a table), preference and cells_per_depth (numbers), "
          "needs_water_everywhere (true or false), [set] and [set_where_water_breaks], got " +
              entry.key + " = " + value.shown());
    }
  }
  mistakes.throw_if_any();
  return notes;
}

}  // namespace

bool ModelNotes::keeps_term(const std::string& term) const {
  return std::find(keeps.begin(), keeps.end(), term) != keeps.end();
}

std::vector<ModelNotes> known_models(const PluginCatalogue& catalogue) {
  std::vector<ModelNotes> models;
  for (const PluginDescription* plugin : catalogue.all()) {
    if (plugin->kind != "equations" && plugin->kind != "reference") continue;
    const std::filesystem::path file = notes_file(*plugin);
    if (std::filesystem::exists(file)) models.push_back(read_notes(*plugin, file));
  }
  std::stable_sort(models.begin(), models.end(), [](const ModelNotes& a, const ModelNotes& b) {
    return a.keeps.size() != b.keeps.size() ? a.keeps.size() < b.keeps.size() : a.preference < b.preference;
  });
  return models;
}

std::string in_slots(const std::string& change, const Case& scene) {
  constexpr const char* beginning = "plugins.";
  if (change.rfind(beginning, 0) != 0) return change;
  const std::size_t at = std::string(beginning).size(), dot = change.find('.', at);
  const std::string kind = change.substr(at, dot - at);
  for (const PluginChoice& choice : scene.plugins) {
    if (choice.kind == kind && choice.slot != kind) return beginning + choice.slot + change.substr(dot);
  }
  return change;
}

Overrides overrides_for(const ModelNotes& model, const Case& scene, bool water_breaks) {
  Overrides changes{in_slots("plugins.equations.id=" + model.plugin->id, scene)};
  for (const std::string& change : model.set) changes.push_back(in_slots(change, scene));
  if (water_breaks) {
    for (const std::string& change : model.set_where_water_breaks) changes.push_back(in_slots(change, scene));
  }
  return changes;
}

}  // namespace riffle
