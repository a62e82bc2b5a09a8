#include "host/study/read_variations.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <set>

namespace riffle {
namespace {

using Leaf = std::function<void(const std::string& key, const TomlEntry& entry)>;

// Tables with headers or dotted keys are part of the key; a table in braces is a value.
void each_key(const TomlNode& table, const std::string& prefix, const Leaf& leaf) {
  for (const TomlEntry& entry : table.entries) {
    const std::string key = prefix.empty() ? entry.key : prefix + '.' + entry.key;
    if (entry.value.is_table() && !entry.value.in_braces) {
      each_key(entry.value, key, leaf);
    } else {
      leaf(key, entry);
    }
  }
}

StudyOverride override_of(const std::string& key, const TomlNode& value, const SourcePlace& place) {
  return {key, key + '=' + value.as_toml(), place};
}

std::string label_of(const TomlNode& value) {
  return value.is_text() ? value.text : value.as_toml();
}

const TomlNode* table_of(const TomlNode& root, const std::string& name, Mistakes& mistakes) {
  const TomlEntry* const entry = root.find(name);
  if (entry == nullptr) return nullptr;
  if (entry->value.is_table()) return &entry->value;
  mistakes.add(entry->place, fmt::format("{} must be a table [{}], got {}", name, name, entry->value.shown()));
  return nullptr;
}

bool is_list(const std::string& table, const std::string& key, const TomlEntry& entry, Mistakes& mistakes) {
  if (entry.value.is_array() && !entry.value.items.empty()) return true;
  mistakes.add(entry.place, fmt::format("{} in [{}] must be an array of at least one value, got {}{}", key, table,
                                        entry.value.shown(),
                                        entry.value.is_array() ? ": the study would have no runs"
                                                               : "; a value that all runs share belongs into [set]"));
  return false;
}

void read_vary(const TomlNode& table, Study& study, Mistakes& mistakes) {
  each_key(table, "", [&](const std::string& key, const TomlEntry& entry) {
    if (!is_list("vary", key, entry, mistakes)) return;
    Axis axis{key, {}};
    for (const TomlNode& item : entry.value.items) {
      axis.choices.push_back({label_of(item), {override_of(key, item, item.place)}, item.place});
    }
    study.vary.push_back(std::move(axis));
  });
}

// Several keys go in step: the first with the first, the second with the second.
void read_resolution(const TomlNode& table, Study& study, Mistakes& mistakes) {
  Axis axis;
  each_key(table, "", [&](const std::string& key, const TomlEntry& entry) {
    if (!is_list("resolution", key, entry, mistakes)) return;
    const auto& items = entry.value.items;
    if (axis.name.empty()) {
      axis.name = key;
      for (const TomlNode& item : items) axis.choices.push_back({label_of(item), {}, item.place});
    } else if (items.size() != axis.choices.size()) {
      mistakes.add(entry.place,
                   fmt::format("{} has {} values and {} has {}; keys of [resolution] go in step and need as "
                               "many each",
                               key, items.size(), axis.name, axis.choices.size()));
      return;
    }
    for (std::size_t k = 0; k < items.size(); ++k) {
      axis.choices[k].overrides.push_back(override_of(key, items[k], items[k].place));
    }
  });
  if (!axis.choices.empty()) study.resolution = std::move(axis);
}

void read_closures(const TomlNode& table, Study& study, Mistakes& mistakes) {
  Axis axis{"closure", {}};
  for (const TomlEntry& entry : table.entries) {
    if (!entry.value.is_table()) {
      mistakes.add(entry.place, fmt::format("closures.{} must be a table of keys of the manifest, got {}", entry.key,
                                            entry.value.shown()));
      continue;
    }
    Choice closure{entry.key, {}, entry.place};
    each_key(entry.value, "", [&](const std::string& key, const TomlEntry& leaf) {
      closure.overrides.push_back(override_of(key, leaf.value, leaf.place));
    });
    axis.choices.push_back(std::move(closure));
  }
  if (axis.choices.empty()) {
    mistakes.add(table.place, "[closures] is empty: the study would have no runs");
  } else {
    study.closures = std::move(axis);
  }
}

// A key may stand in [set] and be overridden, but must not vary in two ways at once.
void refuse_twice(const Study& study, Mistakes& mistakes) {
  std::map<std::string, std::string> varied;
  for (const Axis& axis : study.vary) varied.emplace(axis.name, "[vary]");
  const auto add = [&](const Axis& axis, const std::string& where) {
    std::set<std::string> reported;
    for (const Choice& choice : axis.choices) {
      for (const StudyOverride& change : choice.overrides) {
        const auto [known, fresh] = varied.emplace(change.key, where);
        if (fresh || known->second == where || !reported.insert(change.key).second) continue;
        mistakes.add(change.place, fmt::format("{} varies in {} already", change.key, known->second));
      }
    }
  };
  if (study.resolution) add(*study.resolution, "[resolution]");
  if (study.closures) add(*study.closures, "[closures]");
}

// Short where no two axes would have the same name.
void shorten_names(Study& study) {
  std::map<std::string, int> times;
  for (const Axis& axis : study.vary) ++times[short_name(axis.name)];
  if (study.resolution) ++times[short_name(study.resolution->name)];
  const auto shorten = [&](Axis& axis) {
    if (times[short_name(axis.name)] == 1) axis.name = short_name(axis.name);
  };
  for (Axis& axis : study.vary) shorten(axis);
  if (study.resolution) shorten(*study.resolution);
}

}  // namespace

std::string short_name(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  if (dot == std::string::npos) return key;
  const std::string last = key.substr(dot + 1);
  return last == "id" ? short_name(key.substr(0, dot)) : last;
}

void read_variations(const TomlNode& root, Study& study, Mistakes& mistakes) {
  if (const TomlNode* const set = table_of(root, "set", mistakes)) {
    each_key(*set, "", [&](const std::string& key, const TomlEntry& entry) {
      study.set.push_back(override_of(key, entry.value, entry.place));
    });
  }
  if (const TomlNode* const table = table_of(root, "vary", mistakes)) read_vary(*table, study, mistakes);
  if (const TomlNode* const table = table_of(root, "resolution", mistakes)) read_resolution(*table, study, mistakes);
  if (const TomlNode* const table = table_of(root, "closures", mistakes)) read_closures(*table, study, mistakes);
  refuse_twice(study, mistakes);
  shorten_names(study);
}

}  // namespace riffle
