// A TOML manifest as a tree that remembers where every key and value stands, with the overrides of --set merged in.
// The only part of the host that knows the TOML library.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/manifest/mistakes.hpp"

namespace riffle {

struct TomlEntry;

struct TomlNode {
  enum class Type { table, array, text, integer, real, boolean, date };

  Type type = Type::table;
  SourcePlace place;
  bool plain_text = false;  // a text on one line without escapes: character k stands in column place.column + 1 + k
  std::string text;         // of a text: its contents; of other single values from --set: as typed
  double number = 0;        // of an integer or real
  std::int64_t integer = 0;
  bool boolean = false;
  bool in_braces = false;          // of a table: written as { ... }, so that it is one value
  std::vector<TomlNode> items;     // of an array
  std::vector<TomlEntry> entries;  // of a table, in the order of the file, those new from --set last

  [[nodiscard]] bool is_table() const { return type == Type::table; }
  [[nodiscard]] bool is_array() const { return type == Type::array; }
  [[nodiscard]] bool is_text() const { return type == Type::text; }
  [[nodiscard]] bool is_number() const { return type == Type::integer || type == Type::real; }

  [[nodiscard]] const TomlEntry* find(const std::string& key) const;  // nullptr when absent
  [[nodiscard]] TomlEntry* find(const std::string& key);
  [[nodiscard]] std::vector<std::string> keys() const;

  // As one would write it: 5, "five", true, "an array", "a table".
  [[nodiscard]] std::string shown() const;
  // As TOML that reads back to the same value, for --set: 5, "five", [0, 1], { x = [1], values = [2, 3] }.
  [[nodiscard]] std::string as_toml() const;
  // Where character k of a text stands.
  [[nodiscard]] SourcePlace character(std::size_t k) const;
};

struct TomlEntry {
  std::string key;
  SourcePlace place;  // of the key
  TomlNode value;
};

// Throws a ManifestError when the text is no TOML; `source` stands for the file in places.
TomlNode read_toml(const std::string& text, const std::string& source);

// Reads the file. A file that cannot be read and text that is not TOML are thrown at once: nothing else can be said
// about them.
TomlNode read_document(const std::filesystem::path& file);

struct KeyOverride {
  std::vector<std::string> path;  // "plugins.viscosity.alpha" in three parts
  TomlNode value;
};

// "dotted.key=value"; the value is read as TOML and, when it is none, taken as a bare text. A malformed one becomes a
// mistake and yields an empty path. `index` is its turn among the overrides.
KeyOverride read_override(const std::string& given, int index, Mistakes& mistakes);

// Sets the value, making tables on the way. A key that leads through something else than a table is a mistake.
void apply_override(const KeyOverride& change, TomlNode& root, Mistakes& mistakes);

}  // namespace riffle
