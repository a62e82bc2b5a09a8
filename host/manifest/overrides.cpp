// The overrides of --set.
#include <fmt/format.h>

#include <algorithm>

#include "host/manifest/document.hpp"
#include "host/manifest/units.hpp"

namespace riffle {
namespace {

bool word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

// Empty when a part is empty or holds a character that no key has.
std::vector<std::string> split_key(std::string_view key) {
  std::vector<std::string> parts(1);
  for (const char c : key) {
    if (c == '.') {
      parts.emplace_back();
    } else if (word_character(c)) {
      parts.back() += c;
    } else {
      return {};
    }
  }
  const bool empty_part = std::any_of(parts.begin(), parts.end(), [](const std::string& p) { return p.empty(); });
  return empty_part ? std::vector<std::string>{} : parts;
}

void stand_at(TomlNode& node, const SourcePlace& place) {
  node.place = place;
  node.plain_text = false;
  for (TomlNode& item : node.items) stand_at(item, place);
  for (TomlEntry& entry : node.entries) {
    entry.place = place;
    stand_at(entry.value, place);
  }
}

TomlNode bare_text(const std::string& text, const SourcePlace& place) {
  TomlNode node;
  node.place = place;
  node.text = text;
  node.type = TomlNode::Type::text;
  // ".5" and "5." are numbers to everybody but TOML.
  const auto quantity = split_quantity(text);
  if (quantity && quantity->unit.empty()) {
    if (const auto number = in_si(*quantity, {})) {
      node.type = TomlNode::Type::real;
      node.number = *number;
    }
  }
  return node;
}

}  // namespace

KeyOverride read_override(const std::string& given, int index, Mistakes& mistakes) {
  const SourcePlace place{"--set " + given, 0, index};
  const std::size_t equals = given.find('=');
  KeyOverride change;
  if (equals != std::string::npos) change.path = split_key(std::string_view(given).substr(0, equals));
  if (change.path.empty()) {
    mistakes.add(place, "an override must be key=value with a dotted key, such as plugins.viscosity.alpha=1.0");
    return change;
  }
  const std::string text = given.substr(equals + 1);
  try {
    const TomlNode parsed = read_toml("value = " + text, "");
    if (parsed.entries.size() != 1) throw ManifestError({"more than one value"});
    change.value = parsed.entries.front().value;
    stand_at(change.value, place);
    if (!change.value.is_text()) change.value.text = text;
  } catch (const ManifestError&) {
    change.value = bare_text(text, place);
  }
  return change;
}

void apply_override(const KeyOverride& change, TomlNode& root, Mistakes& mistakes) {
  if (change.path.empty()) return;
  const SourcePlace& place = change.value.place;
  TomlNode* table = &root;
  std::string path;
  for (std::size_t k = 0; k + 1 < change.path.size(); ++k) {
    path += (path.empty() ? "" : ".") + change.path[k];
    TomlEntry* next = table->find(change.path[k]);
    if (next == nullptr) {
      TomlNode fresh;
      fresh.place = place;
      table->entries.push_back({change.path[k], place, fresh});
      next = &table->entries.back();
    }
    if (!next->value.is_table()) {
      mistakes.add(place, fmt::format("{} is {}, not a table that could hold \"{}\"", path, next->value.shown(),
                                      change.path[k + 1]));
      return;
    }
    table = &next->value;
  }
  TomlEntry* entry = table->find(change.path.back());
  if (entry == nullptr) {
    table->entries.push_back({change.path.back(), place, change.value});
  } else {
    entry->place = place;
    entry->value = change.value;
  }
}

}  // namespace riffle
