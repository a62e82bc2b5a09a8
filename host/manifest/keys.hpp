// The manifest's own keys. The reader, the JSON Schema and docs/manifest.md are all made from this one table, so that
// they cannot drift apart. Keys of [plugins.*] and [reference] beyond these are the parameters of the plugin named there;
// keys of [initial] beyond these are the initial fields of the equation set.
#pragma once

#include <string>
#include <vector>

#include "host/plugins/description.hpp"

namespace riffle {

struct ManifestKey {
  enum class Form {
    single,    // one value as described
    interval,  // [low, high], each as described
    words,     // an array of texts
    limits     // a table: field name = quantity in the unit of that field
  };
  std::string table;  // "time", "initial.particles"; "plugins" stands for each [plugins.<slot>]
  ParameterDescription value;
  Form form = Form::single;
  bool optional = false;  // may be absent, and then there is no value
  std::string pattern;    // regular expression that a text must match, or empty
  std::string pattern_in_words;
  [[nodiscard]] std::string path() const { return table + '.' + value.name; }
};

const std::vector<ManifestKey>& manifest_keys();

struct ManifestTable {
  std::string name;
  bool required;
  std::string doc;
};
// Top-level tables in the order in which a manifest has them.
const std::vector<ManifestTable>& manifest_tables();

std::vector<const ManifestKey*> keys_of(const std::string& table);
const ManifestKey& manifest_key(const std::string& path);  // must exist

// The table of docs/manifest.md: one row per key with its values, default and meaning.
std::string keys_in_markdown();

}  // namespace riffle
