// One of the manifest's own tables, read as the table of keys (keys.hpp) describes it.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/manifest/reading.hpp"

namespace riffle {

struct OwnValue {
  ParameterValue value;           // single
  std::array<double, 2> range{};  // interval
  std::vector<std::string> words;
};

class OwnTable {
 public:
  [[nodiscard]] bool has(const std::string& name) const { return values_.count(name) > 0; }
  [[nodiscard]] const OwnValue* find(const std::string& name) const;
  // What the table holds, or `otherwise` when there is none or it was a mistake.
  [[nodiscard]] double number(const std::string& name, double otherwise) const;
  [[nodiscard]] std::string text(const std::string& name) const;

 private:
  friend OwnTable read_own_table(Reading&, const TomlNode*, const std::string&, const std::vector<std::string>&);
  std::map<std::string, OwnValue> values_;
};

// Reads the keys of `table` from `node` (nullptr: absent, all defaults), notes mistakes, writes reading.effective and
// reading.quantities. Unknown keys are mistakes unless they are among `further`. Keys of the form `limits` are left to
// the caller.
OwnTable read_own_table(Reading& reading, const TomlNode* node, const std::string& table,
                        const std::vector<std::string>& further = {});

// The top-level table of that name; nullptr when it is absent, or no table (a mistake).
const TomlNode* find_table(Reading& reading, const std::string& name);

// Where things stand that the manifest does not have at all.
SourcePlace top_of(const Reading& reading);

// The part of reading.effective that belongs to "initial.particles" and the like.
nlohmann::ordered_json& effective_at(Reading& reading, const std::string& table);

}  // namespace riffle
