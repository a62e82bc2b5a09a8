// A line of results measured against the baseline's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/study/analysis.hpp"
#include "host/study/results.hpp"

namespace riffle {

// Errors and costs of the points of a line that count, coarsest first.
std::vector<ErrorCost> error_cost_of(const ResultLine& line, std::size_t error);
// Of all errors of the line's points over their spacings.
double order_of(const ResultLine& line, std::size_t error);

struct Relative {
  const PointResult* baseline = nullptr;  // a point of the baseline
  std::optional<double> cost, error;  // over the baseline's: cost at its error, error at its cost; nothing out of range
};
// One per point of the baseline that counts.
std::vector<Relative> relative_to(const ResultLine& baseline, const ResultLine& line, std::size_t error);

// The points of one case that no other beats, from the cheapest on.
std::vector<const PointResult*> front_of(const StudyResults& results, const std::string& case_name, std::size_t error);

// The cases of the study in their order: names.
std::vector<std::string> cases_of(const StudyResults& results);

}  // namespace riffle
