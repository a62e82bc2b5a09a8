#include "host/manifest/tables.hpp"

#include <fmt/format.h>

#include <regex>

#include "host/manifest/keys.hpp"
#include "host/manifest/rules.hpp"
#include "host/manifest/values.hpp"

namespace riffle {
namespace {

std::string rule_of(const ManifestKey& key, int dim) {
  const std::string rule = rule_in_words(key.value, dim);
  return key.form == ManifestKey::Form::interval ? "[low, high], each " + rule : rule;
}

// What a name could have been: "dam-break-0.5" for "Dam Break 0.5".
std::string as_name(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c == '.' && !out.empty());
    if (c >= 'A' && c <= 'Z') {
      out += static_cast<char>(c - 'A' + 'a');
    } else if (kept || !out.empty()) {
      out += kept ? c : '-';
    }
  }
  return out;
}

class KeyReader {
 public:
  KeyReader(Reading& reading, const ManifestKey& key) : reading_(reading), key_(key), path_(key.path()) {}

  std::optional<OwnValue> read(const TomlNode& node) {
    switch (key_.form) {
      case ManifestKey::Form::single: return single(node);
      case ManifestKey::Form::interval: return interval(node);
      case ManifestKey::Form::words: return words(node);
      case ManifestKey::Form::limits: break;
    }
    return std::nullopt;
  }

  std::optional<OwnValue> absent(const SourcePlace& table, bool misspelt) {
    if (key_.value.required && !misspelt) {
      reading_.mistakes.add(table, fmt::format("{} is missing; it must be {}", path_, rule_of(key_, reading_.dim)));
    }
    if (key_.value.required || key_.optional) return std::nullopt;
    if (key_.form == ManifestKey::Form::words) {
      effective() = nlohmann::ordered_json::array();
      return OwnValue{};
    }
    return take(default_value(reading_, table, path_, key_.value));
  }

  void note_mistaken() { reading_.mistaken.insert({path_, path_ + "_min", path_ + "_max"}); }

 private:
  nlohmann::ordered_json& effective() { return effective_at(reading_, key_.table)[key_.value.name]; }

  std::optional<OwnValue> take(const std::optional<ReadValue>& read) {
    if (!read) return std::nullopt;
    effective() = read->effective;
    const bool number = key_.value.type == ParameterType::real || key_.value.type == ParameterType::integer;
    if (number) reading_.quantities[path_] = read->value.number;
    return OwnValue{read->value, {}, {}};
  }

  std::optional<OwnValue> single(const TomlNode& node) {
    const auto read = read_value(reading_, node, path_, key_.value);
    if (read && !key_.pattern.empty() && !std::regex_match(read->value.text, std::regex(key_.pattern))) {
      const std::string suggestion = as_name(read->value.text);
      reading_.mistakes.add(node.place,
                            fmt::format("{} must be {}, got {}{}", path_, key_.pattern_in_words, node.shown(),
                                        suggestion.empty() ? "" : "; did you mean \"" + suggestion + "\"?"));
      return std::nullopt;
    }
    return take(read);
  }

  std::optional<OwnValue> interval(const TomlNode& node) {
    const auto range = read_interval(reading_, node, path_, key_.value);
    if (!range) return std::nullopt;
    effective() = *range;
    return OwnValue{{}, *range, {}};
  }

  std::optional<OwnValue> words(const TomlNode& node) {
    OwnValue value;
    if (!node.is_array()) {
      reading_.mistakes.add(node.place, fmt::format("{} must be an array of texts, got {}", path_, node.shown()));
      return std::nullopt;
    }
    for (std::size_t k = 0; k < node.items.size(); ++k) {
      const TomlNode& item = node.items[k];
      if (!item.is_text()) {
        reading_.mistakes.add(item.place,
                              fmt::format("{}[{}] must be a text in quotes, got {}", path_, k, item.shown()));
      }
      value.words.push_back(item.text);
    }
    effective() = value.words;
    return value;
  }

  Reading& reading_;
  const ManifestKey& key_;
  std::string path_;
};

}  // namespace

const OwnValue* OwnTable::find(const std::string& name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? nullptr : &found->second;
}

double OwnTable::number(const std::string& name, double otherwise) const {
  const OwnValue* const value = find(name);
  return value != nullptr ? value->value.number : otherwise;
}

std::string OwnTable::text(const std::string& name) const {
  const OwnValue* const value = find(name);
  return value != nullptr ? value->value.text : "";
}

OwnTable read_own_table(Reading& reading, const TomlNode* node, const std::string& table,
                        const std::vector<std::string>& further) {
  OwnTable own;
  const SourcePlace place = node != nullptr ? node->place : top_of(reading);
  std::vector<std::string> known = further;
  for (const ManifestKey* key : keys_of(table)) known.push_back(key->value.name);
  for (const ManifestKey* key : keys_of(table)) {
    if (key->form == ManifestKey::Form::limits) continue;
    const std::string& name = key->value.name;
    const TomlEntry* const entry = node != nullptr ? node->find(name) : nullptr;
    KeyReader reader(reading, *key);
    const auto value = entry != nullptr ? reader.read(entry->value)
                                        : reader.absent(place, node != nullptr && misspelt(*node, name, known));
    if (value) {
      own.values_[name] = *value;
    } else if (entry != nullptr || key->value.required) {
      reader.note_mistaken();
    }
  }
  if (node != nullptr) refuse_unknown_keys(reading, *node, '[' + table + ']', known);
  return own;
}

const TomlNode* find_table(Reading& reading, const std::string& name) {
  const TomlEntry* const entry = reading.root.find(name);
  if (entry == nullptr) return nullptr;
  if (entry->value.is_table()) return &entry->value;
  reading.mistakes.add(entry->place, fmt::format("{} must be a table [{}], got {}", name, name, entry->value.shown()));
  return nullptr;
}

SourcePlace top_of(const Reading& reading) {
  return {reading.root.place.source, 1, 1};
}

nlohmann::ordered_json& effective_at(Reading& reading, const std::string& table) {
  nlohmann::ordered_json* at = &reading.effective;
  std::size_t begin = 0;
  for (std::size_t dot = table.find('.');; dot = table.find('.', begin)) {
    at = &(*at)[table.substr(begin, dot == std::string::npos ? dot : dot - begin)];
    if (dot == std::string::npos) return *at;
    begin = dot + 1;
  }
}

}  // namespace riffle
