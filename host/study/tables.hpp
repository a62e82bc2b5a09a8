// The results as text: results.csv, one row per combination, and results.md, the tables to read.
#pragma once

#include <string>

#include "host/study/results.hpp"

namespace riffle {

std::string results_in_csv(const StudyResults& results);
std::string results_in_markdown(const StudyResults& results);

}  // namespace riffle
