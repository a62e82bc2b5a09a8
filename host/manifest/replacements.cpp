#include "host/manifest/replacements.hpp"

#include <algorithm>

namespace riffle {
namespace {

using Path = std::vector<std::string>;

const TomlNode* find_node(const TomlNode& root, const Path& path) {
  const TomlNode* at = &root;
  for (const std::string& part : path) {
    const TomlEntry* const entry = at->find(part);
    if (entry == nullptr) return nullptr;
    at = &entry->value;
  }
  return at;
}

Path joined(Path path, const std::string& key) {
  path.push_back(key);
  return path;
}

bool any_override_of(const std::vector<KeyOverride>& changes, const Path& path) {
  return std::any_of(changes.begin(), changes.end(), [&](const KeyOverride& change) {
    return change.path.size() >= path.size() && std::equal(path.begin(), path.end(), change.path.begin());
  });
}

std::string text_at(const TomlNode& root, const Path& path) {
  const TomlNode* const node = find_node(root, path);
  return node != nullptr && node->is_text() ? node->text : "";
}

const PluginDescription* plugin_at(const TomlNode& root, const Path& table, const PluginCatalogue& catalogue) {
  std::string kind = text_at(root, joined(table, "kind"));
  if (kind.empty()) kind = table.back();
  return catalogue.find(kind, text_at(root, joined(table, "id")));
}

bool takes(const PluginDescription& plugin, const std::string& key) {
  const auto& parameters = plugin.parameters;
  return std::any_of(parameters.begin(), parameters.end(),
                     [&](const ParameterDescription& parameter) { return parameter.name == key; });
}

void erase_entries(TomlNode& root, const Path& table, const std::vector<std::string>& keys) {
  auto* const node = const_cast<TomlNode*>(find_node(root, table));
  if (node == nullptr) return;
  auto& entries = node->entries;
  entries.erase(std::remove_if(entries.begin(), entries.end(),
                               [&](const TomlEntry& entry) {
                                 return std::find(keys.begin(), keys.end(), entry.key) != keys.end();
                               }),
                entries.end());
}

void drop_former_parameters(const TomlNode& original, TomlNode& root, const Path& table,
                            const std::vector<KeyOverride>& changes, const PluginCatalogue& catalogue) {
  const TomlNode* const before = find_node(original, table);
  const PluginDescription* const now = plugin_at(root, table, catalogue);
  if (before == nullptr || now == nullptr || !before->is_table()) return;
  const PluginDescription* const former = plugin_at(original, table, catalogue);
  if (former == now) return;
  std::vector<std::string> dropped;
  for (const TomlEntry& entry : before->entries) {
    if (entry.key == "kind" || entry.key == "id" || takes(*now, entry.key)) continue;
    // A key that the former plugin did not have either is a slip of the file and stays to be reported.
    if (former != nullptr && !takes(*former, entry.key)) continue;
    if (!any_override_of(changes, joined(table, entry.key))) dropped.push_back(entry.key);
  }
  erase_entries(root, table, dropped);
}

}  // namespace

void apply_overrides(const std::vector<std::string>& overrides, TomlNode& root, const PluginCatalogue& catalogue,
                     Mistakes& mistakes) {
  const TomlNode original = root;
  std::vector<KeyOverride> changes;
  for (const std::string& given : overrides) {
    changes.push_back(read_override(given, static_cast<int>(changes.size()), mistakes));
    apply_override(changes.back(), root, mistakes);
  }
  for (const KeyOverride& change : changes) {
    const Path& path = change.path;
    const bool of_slot = path.size() == 3 && path[0] == "plugins" && path[2] == "id";
    const bool of_reference = path == Path{"reference", "id"};
    if (of_slot || of_reference) {
      drop_former_parameters(original, root, Path(path.begin(), path.end() - 1), changes, catalogue);
    }
  }
  const Path particles{"initial", "particles"};
  for (const auto& [given, other] : {std::pair("count", "spacing"), std::pair("spacing", "count")}) {
    if (any_override_of(changes, joined(particles, given)) && !any_override_of(changes, joined(particles, other))) {
      erase_entries(root, particles, {other});
    }
  }
}

}  // namespace riffle
