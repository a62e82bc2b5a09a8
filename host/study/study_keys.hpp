// The keys of a study file, with their rules; read_study.cpp and the documentation's test go by this table.
#pragma once

#include <string>
#include <vector>

#include "host/plugins/description.hpp"

namespace riffle {

struct StudyKey {
  std::string table;  // "study", "map", "map.x"
  ParameterDescription value;
  bool list = false;  // one value or an array of them
};

const std::vector<StudyKey>& study_keys();
std::vector<const StudyKey*> study_keys_of(const std::string& table);

// The tables of docs/comparing.md: one row per key.
std::string study_keys_in_markdown();

}  // namespace riffle
