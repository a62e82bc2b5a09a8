// Functions of position and time as a manifest writes them.
//
//   "10 m", 10                                    a constant
//   "0.4 - 0.05*x^2"                              a formula in x, y, z, t, with pi and g, SI
//   { x = [0, 5], values = [10, "x", "5 m"] }     piecewise: value k holds from break k-1 (included) to break k
//   { csv = "bed.csv", x = "x", value = "level" } a table, linear between rows, constant beyond its ends, or undefined
//                                                 (NaN) there with outside = "error"
//
// Piecewise values and tables may run over x, y, z or t. A text that begins with a number and goes on with letters is a
// quantity, every other text a formula; no text is both.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host/manifest/function.hpp"
#include "host/manifest/reading.hpp"

namespace riffle {

struct ReadFunction {
  Function function;
  nlohmann::ordered_json effective;  // the same in SI
  std::optional<double> constant;    // its value, when it is one
  std::array<bool, 4> uses{};        // x, y, z, t
};

// `key` names the value in messages; `unit` is the SI unit of the result. Nothing after a mistake.
std::optional<ReadFunction> read_function(Reading& reading, const TomlNode& node, const std::string& key,
                                          const std::string& unit);

ReadFunction constant_function(double value);

}  // namespace riffle
