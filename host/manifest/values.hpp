// Single values of a manifest, checked against their description: type, unit, range.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/manifest/reading.hpp"

namespace riffle {

struct ReadValue {
  ParameterValue value;
  nlohmann::ordered_json effective;
};

// `key` names the value in messages ("plugins.viscosity.alpha"). Nothing after a mistake.
std::optional<ReadValue> read_value(Reading& reading, const TomlNode& node, const std::string& key,
                                    const ParameterDescription& description);

// What holds when the manifest is silent. A default that is inherited from a quantity that this case does not have, or
// that is out of the parameter's range, is a mistake, placed at `table`.
std::optional<ReadValue> default_value(Reading& reading, const SourcePlace& table, const std::string& key,
                                       const ParameterDescription& description);

// A real number in SI from a bare number or a quantity.
std::optional<double> read_real(Reading& reading, const TomlNode& node, const std::string& key,
                                const ParameterDescription& description);

// [low, high] with low < high, each as a real.
std::optional<std::array<double, 2>> read_interval(Reading& reading, const TomlNode& node, const std::string& key,
                                                   const ParameterDescription& description);

// One mistake for each key of the table that is not among the known ones.
void refuse_unknown_keys(Reading& reading, const TomlNode& table, const std::string& shown,
                         const std::vector<std::string>& known);

// Whether the table has an unknown key that was most likely meant to be `name`; then that key is the mistake, and nobody
// need hear that `name` is missing as well.
bool misspelt(const TomlNode& table, const std::string& name, const std::vector<std::string>& known);

}  // namespace riffle
