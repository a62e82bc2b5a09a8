#include "host/manifest/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/manifest/functions.hpp"
#include "host/manifest/nearest.hpp"
#include "host/manifest/rules.hpp"
#include "host/manifest/units.hpp"

namespace riffle {
namespace {

constexpr double largest_exact_integer = 9007199254740992.0;  // 2^53

void refuse(Reading& reading, const TomlNode& node, const std::string& key, const ParameterDescription& description,
            const std::string& remark = "") {
  reading.mistakes.add(node.place, fmt::format("{} must be {}, got {}{}", key, rule_in_words(description, reading.dim),
                                               node.shown(), remark));
}

SiDimension dimension_of(const std::string& unit, int dim) {
  return read_unit(unit.empty() ? "1" : unit, std::max(dim, 1)).dimension;
}

// The value of a text such as "15.9 mm".
std::optional<double> real_from_text(Reading& reading, const TomlNode& node, const std::string& key,
                                     const ParameterDescription& description) {
  const auto quantity = split_quantity(node.text);
  if (!quantity) {
    refuse(reading, node, key, description);
    return std::nullopt;
  }
  const SiDimension wanted = dimension_of(description.unit, reading.dim);
  if (quantity->unit.empty() && wanted != SiDimension{}) {
    refuse(reading, node, key, description,
           fmt::format(": missing unit; write \"{0} {1}\", or {0} without quotes for SI", quantity->number,
                       description.unit));
    return std::nullopt;
  }
  try {
    const ScaledUnit unit = quantity->unit.empty() ? ScaledUnit{} : read_unit(quantity->unit);
    if (unit.dimension != wanted) {
      const std::string_view name = name_of(unit.dimension);
      refuse(reading, node, key, description,
             name == "a quantity" ? fmt::format(": wrong unit \"{}\"", quantity->unit)
                                  : fmt::format(", which is {}", name));
      return std::nullopt;
    }
    const auto value = in_si(*quantity, unit);
    if (!value) refuse(reading, node, key, description, ", which is beyond the range of numbers");
    return value;
  } catch (const UnitError& error) {
    refuse(reading, node, key, description, fmt::format(": {}", error.what()));
    return std::nullopt;
  }
}

std::optional<ReadValue> read_integer(Reading& reading, const TomlNode& node, const std::string& key,
                                      const ParameterDescription& description) {
  if (!node.is_number() || node.number != std::floor(node.number) || std::abs(node.number) > largest_exact_integer ||
      !range_of(description).contains(node.number)) {
    refuse(reading, node, key, description);
    return std::nullopt;
  }
  ReadValue read;
  read.value.number = node.number;
  read.effective = static_cast<std::int64_t>(node.number);
  return read;
}

std::optional<ReadValue> read_text(Reading& reading, const TomlNode& node, const std::string& key,
                                   const ParameterDescription& description) {
  // On a command line nobody quotes: --set case.title=2024 means a text all the same.
  if (!node.is_text() && !node.place.from_override()) {
    refuse(reading, node, key, description);
    return std::nullopt;
  }
  ReadValue read;
  read.value.text = node.text;
  read.effective = node.text;
  if (!description.path || node.text.empty()) return read;
  const std::filesystem::path path = std::filesystem::absolute(reading.folder / node.text).lexically_normal();
  if (!std::filesystem::exists(path)) {
    reading.mistakes.add(node.place,
                         fmt::format("{}: no such file \"{}\"", key, (reading.folder / node.text).string()));
    return std::nullopt;
  }
  read.value.text = path.string();
  return read;
}

// Some choices are sets, "B1+B2": they may be written as an array, ["B2", "B1"]; the empty set is "none".
std::optional<std::string> chosen_set(const TomlNode& node) {
  if (!node.is_array()) return std::nullopt;
  std::vector<std::string> words;
  for (const TomlNode& item : node.items) {
    if (!item.is_text()) return std::nullopt;
    words.push_back(item.text);
  }
  std::sort(words.begin(), words.end());
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, "+"));
}

std::optional<ReadValue> read_choice(Reading& reading, const TomlNode& node, const std::string& key,
                                     const ParameterDescription& description) {
  const auto& choices = description.choices;
  const std::optional<std::string> set = chosen_set(node);
  const bool readable = node.is_text() || set || node.place.from_override();
  const std::string word = set.value_or(node.text);
  const auto found = std::find(choices.begin(), choices.end(), word);
  if (!readable || found == choices.end()) {
    refuse(reading, node, key, description, node.is_text() || set ? did_you_mean(word, choices) : "");
    return std::nullopt;
  }
  ReadValue read;
  read.value.text = word;
  read.value.number = static_cast<double>(found - choices.begin());
  read.effective = word;
  return read;
}

ReadValue number_value(double number) {
  ReadValue read;
  read.value.number = number;
  read.effective = number;
  return read;
}

ReadValue function_value(const ReadFunction& function) {
  ReadValue read;
  read.value.number = function.constant.value_or(0.0);
  read.value.text = function.function.text();
  read.value.function = std::make_shared<const Function>(function.function);
  read.effective = function.effective;
  return read;
}

}  // namespace

std::optional<double> read_real(Reading& reading, const TomlNode& node, const std::string& key,
                                const ParameterDescription& description) {
  std::optional<double> value;
  if (node.is_number()) {
    value = node.number;
  } else if (node.is_text()) {
    value = real_from_text(reading, node, key, description);
    if (!value) return std::nullopt;
  }
  if (!value || !range_of(description).contains(*value) || !std::isfinite(*value)) {
    refuse(reading, node, key, description,
           node.is_number() && !std::isfinite(node.number) ? ", which is not finite" : "");
    return std::nullopt;
  }
  return value;
}

std::optional<ReadValue> read_value(Reading& reading, const TomlNode& node, const std::string& key,
                                    const ParameterDescription& description) {
  std::optional<ReadValue> read;
  switch (description.type) {
    case ParameterType::real:
      if (const auto number = read_real(reading, node, key, description)) read = number_value(*number);
      break;
    case ParameterType::integer: read = read_integer(reading, node, key, description); break;
    case ParameterType::text: read = read_text(reading, node, key, description); break;
    case ParameterType::choice: read = read_choice(reading, node, key, description); break;
    case ParameterType::function:
      if (const auto function = read_function(reading, node, key, description.unit)) read = function_value(*function);
      break;
    case ParameterType::boolean:
      if (node.type == TomlNode::Type::boolean) {
        read = number_value(node.boolean ? 1 : 0);
        read->effective = node.boolean;
      } else {
        refuse(reading, node, key, description);
      }
      break;
  }
  if (!read) return std::nullopt;
  read->value.name = description.name;
  read->value.given = true;
  return read;
}

std::optional<ReadValue> default_value(Reading& reading, const SourcePlace& table, const std::string& key,
                                       const ParameterDescription& description) {
  double number = description.fallback;
  if (!description.inherit.empty()) {
    const auto found = reading.quantities.find(description.inherit);
    if (found == reading.quantities.end()) {
      if (reading.mistaken.count(description.inherit) > 0) return std::nullopt;
      reading.mistakes.add(table, fmt::format("{} is missing; it must be {} (its default {} is not known here)", key,
                                              rule_in_words(description, reading.dim), description.inherit));
      return std::nullopt;
    }
    number = found->second;
    if (!range_of(description).contains(number)) {
      reading.mistakes.add(table, fmt::format("{} must be {}, got {} from {}", key,
                                              rule_in_words(description, reading.dim), number, description.inherit));
      return std::nullopt;
    }
  }
  ReadValue read;
  switch (description.type) {
    case ParameterType::real: read = number_value(number); break;
    case ParameterType::integer:
      read = number_value(number);
      read.effective = static_cast<std::int64_t>(number);
      break;
    case ParameterType::boolean:
      read = number_value(number);
      read.effective = number != 0;
      break;
    case ParameterType::text:
      read.value.text = description.fallback_text;
      read.effective = description.fallback_text;
      break;
    case ParameterType::choice: {
      const auto& choices = description.choices;
      const auto found = std::find(choices.begin(), choices.end(), description.fallback_text);
      const auto index = !description.inherit.empty() ? static_cast<std::ptrdiff_t>(number)
                         : found == choices.end()     ? 0
                                                      : found - choices.begin();
      read.value.number = static_cast<double>(index);
      if (!choices.empty()) read.value.text = choices[static_cast<std::size_t>(index)];
      read.effective = read.value.text;
      break;
    }
    case ParameterType::function: read = function_value(constant_function(number)); break;
  }
  read.value.name = description.name;
  return read;
}

std::optional<std::array<double, 2>> read_interval(Reading& reading, const TomlNode& node, const std::string& key,
                                                   const ParameterDescription& description) {
  if (!node.is_array() || node.items.size() != 2) {
    reading.mistakes.add(node.place, fmt::format("{} must be [low, high], each {}, got {}", key,
                                                 rule_in_words(description, reading.dim), node.shown()));
    return std::nullopt;
  }
  const auto low = read_real(reading, node.items[0], key + "[0]", description);
  const auto high = read_real(reading, node.items[1], key + "[1]", description);
  if (!low || !high) return std::nullopt;
  if (!(*low < *high)) {
    reading.mistakes.add(node.place, fmt::format("{} must be [low, high] with low < high, got [{}, {}]", key,
                                                 node.items[0].shown(), node.items[1].shown()));
    return std::nullopt;
  }
  return std::array<double, 2>{*low, *high};
}

void refuse_unknown_keys(Reading& reading, const TomlNode& table, const std::string& shown,
                         const std::vector<std::string>& known) {
  for (const TomlEntry& entry : table.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    std::string hint = did_you_mean(entry.key, known);
    if (hint.empty()) hint = "; it takes " + all_of(known);
    reading.mistakes.add(entry.place, fmt::format("unknown key \"{}\" in {}{}", entry.key, shown, hint));
  }
}

bool misspelt(const TomlNode& table, const std::string& name, const std::vector<std::string>& known) {
  return std::any_of(table.entries.begin(), table.entries.end(), [&](const TomlEntry& entry) {
    return std::find(known.begin(), known.end(), entry.key) == known.end() && nearest(entry.key, known) == name;
  });
}

}  // namespace riffle
