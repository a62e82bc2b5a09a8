#include "host/manifest/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/manifest/nearest.hpp"
#include "host/manifest/units.hpp"

namespace riffle {

bool AllowedRange::contains(double value) const {
  if (std::isnan(value)) return false;
  if (has_min && (above_min ? value <= min : value < min)) return false;
  return !(has_max && (below_max ? value >= max : value > max));
}

AllowedRange range_of(const ParameterDescription& parameter) {
  AllowedRange range;
  if (!(parameter.min < parameter.max)) return range;
  range.has_min = std::isfinite(parameter.min);
  range.has_max = std::isfinite(parameter.max);
  range.above_min = parameter.above_min;
  range.below_max = parameter.below_max;
  range.min = parameter.min;
  range.max = parameter.max;
  return range;
}

std::string bounds_in_words(const ParameterDescription& parameter) {
  const AllowedRange range = range_of(parameter);
  std::string words;
  if (range.has_min && range.has_max && !range.above_min && !range.below_max) {
    words = fmt::format("from {} to {}", range.min, range.max);
  } else {
    if (range.has_min) words = fmt::format("{} {}", range.above_min ? "above" : "of at least", range.min);
    if (range.has_min && range.has_max) words += " and ";
    if (range.has_max) words += fmt::format("{} {}", range.below_max ? "below" : "at most", range.max);
  }
  if (!words.empty() && parameter.unit != "1" && !parameter.unit.empty()) words += ' ' + parameter.unit;
  return words;
}

std::string quantity_in_words(const std::string& unit, int dim) {
  try {
    return std::string(name_of(read_unit(unit.empty() ? "1" : unit, std::max(dim, 1)).dimension));
  } catch (const UnitError&) {
    return "a quantity";
  }
}

std::string rule_in_words(const ParameterDescription& parameter, int dim) {
  const std::string bounds = bounds_in_words(parameter);
  const bool has_unit = !parameter.unit.empty() && parameter.unit != "1";
  switch (parameter.type) {
    case ParameterType::boolean: return "true or false";
    case ParameterType::choice: return any_of(parameter.choices);
    case ParameterType::text: return parameter.path ? "a file name in quotes" : "a text in quotes";
    case ParameterType::integer: return bounds.empty() ? "an integer" : "an integer " + bounds;
    case ParameterType::real: {
      const std::string quantity = quantity_in_words(parameter.unit, dim);
      if (!bounds.empty()) return quantity + ' ' + bounds;
      return has_unit ? quantity + " [" + parameter.unit + "]" : quantity;
    }
    case ParameterType::function: break;
  }
  return "a quantity" + (has_unit ? " [" + parameter.unit + "]" : std::string()) +
         ", a formula in x, y, z and t, { x = [...], values = [...] } or { csv = \"...\", x = \"...\", value = \"...\" "
         "}";
}

}  // namespace riffle
