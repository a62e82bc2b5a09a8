// What a value must be, in words; one place for all messages, the schema and the documentation.
#pragma once

#include <string>

#include "host/plugins/description.hpp"

namespace riffle {

// Where min < max the two bound the value; otherwise the range is not declared and nothing is out of it.
struct AllowedRange {
  bool has_min = false, has_max = false, above_min = false, below_max = false;
  double min = 0, max = 0;
  [[nodiscard]] bool contains(double value) const;  // false for NaN
};
AllowedRange range_of(const ParameterDescription& parameter);

// "above 0 m", "from 0 to 10", "of at least 1 and below 3 s"; "" without bounds.
std::string bounds_in_words(const ParameterDescription& parameter);

// To follow "must be": "a length above 0 m", "an integer from 1 to 3", "\"implicit\" or \"explicit\"", ...
std::string rule_in_words(const ParameterDescription& parameter, int dim);

// The dimension of a declared unit, "a length", "a density"; "a number" when the unit is "1".
std::string quantity_in_words(const std::string& unit, int dim);

}  // namespace riffle
