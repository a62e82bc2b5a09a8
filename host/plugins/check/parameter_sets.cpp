#include "host/plugins/check/parameter_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace riffle::check {
namespace {

void choose(const ParameterDescription& p, std::size_t word, ParameterValue& value) {
  value.number = static_cast<double>(word);
  value.text = p.choices[word];
  value.given = true;
}

// The least or largest allowed number; nothing when there is no such bound.
std::vector<double> ends(const ParameterDescription& p, double usual) {
  const double step = p.type == ParameterType::integer ? 1 : 0;
  std::vector<double> numbers;
  if (std::isfinite(p.min))
    numbers.push_back(!p.above_min ? p.min : step > 0 ? p.min + 1 : p.min + 1e-3 * (usual - p.min));
  if (std::isfinite(p.max))
    numbers.push_back(!p.below_max ? p.max : step > 0 ? p.max - 1 : p.max - 1e-3 * (p.max - usual));
  return numbers;
}

double random_number(const ParameterDescription& p, double usual, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double low = std::isfinite(p.min) ? p.min : usual - 10 * std::max(1.0, std::abs(usual));
  const double high = std::isfinite(p.max) ? p.max : usual + 10 * std::max(1.0, std::abs(usual));
  // Ranges may span many powers of ten: half of the numbers are of the size of the default.
  double number = low + (high - low) * uniform(random);
  if (uniform(random) < 0.5) number = std::clamp(usual * std::exp2(6 * uniform(random) - 3), low, high);
  if (p.type == ParameterType::integer) number = std::floor(number);
  if ((p.above_min && number <= p.min) || (p.below_max && number >= p.max)) number = usual;
  return number;
}

bool is_number(const ParameterDescription& p) {
  return p.type == ParameterType::real || p.type == ParameterType::integer;
}

}  // namespace

std::vector<ParameterSet> bounds_of(const PluginDescription& description) {
  const std::vector<ParameterValue> defaults = default_values(description);
  std::vector<ParameterSet> sets;
  for (std::size_t k = 0; k < description.parameters.size(); ++k) {
    const ParameterDescription& p = description.parameters[k];
    if (p.type == ParameterType::choice) {
      for (std::size_t word = 0; word < p.choices.size(); ++word) {
        sets.push_back({fmt::format("{} = \"{}\"", p.name, p.choices[word]), defaults});
        choose(p, word, sets.back().values[k]);
      }
    } else if (is_number(p) || p.type == ParameterType::boolean) {
      const auto numbers = is_number(p) ? ends(p, defaults[k].number) : std::vector<double>{0, 1};
      for (const double number : numbers) {
        sets.push_back({fmt::format("{} = {:.6g}", p.name, number), defaults});
        sets.back().values[k].number = number;
        sets.back().values[k].given = true;
      }
    }
  }
  return sets;
}

ParameterSet random_set(const PluginDescription& description, std::mt19937_64& random) {
  ParameterSet set{"", default_values(description)};
  for (std::size_t k = 0; k < description.parameters.size(); ++k) {
    const ParameterDescription& p = description.parameters[k];
    ParameterValue& value = set.values[k];
    if (p.type == ParameterType::choice) {
      choose(p, std::uniform_int_distribution<std::size_t>(0, p.choices.size() - 1)(random), value);
    } else if (p.type == ParameterType::boolean) {
      value.number = std::uniform_int_distribution<int>(0, 1)(random);
    } else if (is_number(p)) {
      value.number = random_number(p, value.number, random);
    } else {
      continue;  // texts may name files
    }
    value.given = true;
    set.name += fmt::format("{}{} = {}", set.name.empty() ? "" : ", ", p.name,
                            p.type == ParameterType::choice ? value.text : fmt::format("{:.6g}", value.number));
  }
  return set;
}

bool needs_values(const PluginDescription& description) {
  return std::any_of(description.parameters.begin(), description.parameters.end(),
                     [](const ParameterDescription& p) { return p.required; });
}

}  // namespace riffle::check
