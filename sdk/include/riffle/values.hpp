// Parameters: how they are declared, and how a plugin reads them.
#pragma once

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "riffle/abi.h"

namespace riffle {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// A real number with unit, default and range; `inherit` names a manifest quantity that replaces the default.
constexpr riffle_parameter real(const char* name, const char* unit, double fallback, double min, double max,
                                const char* doc, std::uint32_t flags = 0, const char* inherit = nullptr) {
  return {
      sizeof(riffle_parameter), RIFFLE_REAL, flags, 0, name, unit, doc, nullptr, inherit, fallback, min, max, nullptr};
}
// A real number that the manifest must give.
constexpr riffle_parameter required_real(const char* name, const char* unit, double min, double max, const char* doc,
                                         std::uint32_t flags = 0) {
  return {sizeof(riffle_parameter),
          RIFFLE_REAL,
          flags | RIFFLE_REQUIRED,
          0,
          name,
          unit,
          doc,
          nullptr,
          nullptr,
          min,
          min,
          max,
          nullptr};
}
// The same number as a quantity of the manifest, unless given here: gravity, density, ...
constexpr riffle_parameter inherited(const char* name, const char* unit, const char* from, double min, double max,
                                     const char* doc, std::uint32_t flags = 0) {
  return real(name, unit, min, min, max, doc, flags, from);
}
constexpr riffle_parameter integer(const char* name, double fallback, double min, double max, const char* doc) {
  return {
      sizeof(riffle_parameter), RIFFLE_INTEGER, 0, 0, name, "1", doc, nullptr, nullptr, fallback, min, max, nullptr};
}
constexpr riffle_parameter boolean(const char* name, bool fallback, const char* doc) {
  return {sizeof(riffle_parameter),
          RIFFLE_BOOLEAN,
          0,
          0,
          name,
          "1",
          doc,
          nullptr,
          nullptr,
          fallback ? 1.0 : 0.0,
          0,
          1,
          nullptr};
}
// One word of "first|second|third".
constexpr riffle_parameter choice(const char* name, const char* choices, const char* fallback, const char* doc) {
  return {sizeof(riffle_parameter), RIFFLE_CHOICE, 0, 0, name, "1", doc, choices, nullptr, 0, 0, 0, fallback};
}
constexpr riffle_parameter text(const char* name, const char* fallback, const char* doc, std::uint32_t flags = 0) {
  return {sizeof(riffle_parameter), RIFFLE_TEXT, flags, 0, name, "1", doc, nullptr, nullptr, 0, 0, 0, fallback};
}
// A function of position and time: a constant, piecewise values, a formula or a CSV table in the manifest.
constexpr riffle_parameter function(const char* name, const char* unit, double fallback, const char* doc,
                                    std::uint32_t flags = 0) {
  return {sizeof(riffle_parameter),
          RIFFLE_FUNCTION,
          flags,
          0,
          name,
          unit,
          doc,
          nullptr,
          nullptr,
          fallback,
          -infinity,
          infinity,
          nullptr};
}

// The values of one instance, looked up by name.
class Values {
 public:
  Values(int dim, const riffle_parameter* parameters, std::size_t count, const riffle_value* const* values)
      : dim_(dim), parameters_(parameters), count_(count), values_(values) {}
  [[nodiscard]] int dim() const { return dim_; }
  [[nodiscard]] double number(const char* name) const { return find(name).number; }
  [[nodiscard]] bool flag(const char* name) const { return find(name).number != 0; }
  [[nodiscard]] std::string word(const char* name) const { return find(name).text != nullptr ? find(name).text : ""; }
  [[nodiscard]] const riffle_function* function(const char* name) const { return find(name).function; }
  [[nodiscard]] bool given(const char* name) const { return find(name).given != 0; }

 private:
  [[nodiscard]] const riffle_value& find(const std::string& name) const {
    for (std::size_t k = 0; k < count_; ++k) {
      if (name == parameters_[k].name) return *values_[k];
    }
    throw std::logic_error("the plugin asks for its parameter \"" + name + "\", which it does not declare");
  }
  int dim_;
  const riffle_parameter* parameters_;
  std::size_t count_;
  const riffle_value* const* values_;
};

}  // namespace riffle
