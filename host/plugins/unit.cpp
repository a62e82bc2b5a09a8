#include "host/plugins/unit.hpp"

#include <charconv>

namespace riffle {
namespace {

struct Symbol {
  std::string_view text;
  Unit::Base base;
};
// Longer symbols first: "mol" starts with "m".
constexpr std::array<Symbol, Unit::base_count> symbols{{{"mol", Unit::mole},
                                                        {"kg", Unit::kilogram},
                                                        {"cd", Unit::candela},
                                                        {"m", Unit::metre},
                                                        {"s", Unit::second},
                                                        {"K", Unit::kelvin},
                                                        {"A", Unit::ampere}}};

// Takes a positive whole number off the front of `text`.
std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || number <= 0 || number > 100) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

// One factor, such as "m-3", "s1/2" or "m-d", multiplied onto `unit`; false when it is malformed.
bool add_factor(std::string_view factor, Unit& unit) {
  for (const Symbol& symbol : symbols) {
    if (!factor.starts_with(symbol.text)) continue;
    factor.remove_prefix(symbol.text.size());
    int& total = unit.twelfths[symbol.base];
    if (factor.empty()) {
      total += 12;
      return true;
    }
    const int sign = factor.front() == '-' ? -1 : 1;
    if (sign < 0) factor.remove_prefix(1);
    if (factor == "d") {
      if (symbol.base != Unit::metre) return false;
      unit.metre_twelfths_per_dimension += sign * 12;
      return true;
    }
    const auto numerator = take_number(factor);
    if (!numerator) return false;
    int denominator = 1;
    if (factor.starts_with('/')) {
      factor.remove_prefix(1);
      const auto number = take_number(factor);
      if (!number || 12 % *number != 0) return false;
      denominator = *number;
    }
    total += sign * *numerator * (12 / denominator);
    return factor.empty();
  }
  return false;
}

}  // namespace

Unit Unit::operator*(const Unit& other) const {
  Unit product = *this;
  for (std::size_t k = 0; k < twelfths.size(); ++k) product.twelfths[k] += other.twelfths[k];
  product.metre_twelfths_per_dimension += other.metre_twelfths_per_dimension;
  return product;
}

Unit Unit::inverse() const {
  Unit result;
  for (std::size_t k = 0; k < twelfths.size(); ++k) result.twelfths[k] = -twelfths[k];
  result.metre_twelfths_per_dimension = -metre_twelfths_per_dimension;
  return result;
}

double Unit::exponent(Base base, int dim) const {
  const int per_dimension = base == metre ? metre_twelfths_per_dimension * dim : 0;
  return (twelfths[base] + per_dimension) / 12.0;
}

std::optional<Unit> parse_unit(std::string_view text) {
  Unit unit;
  if (text == "1") return unit;
  while (true) {
    const std::size_t dot = text.find('.');
    if (!add_factor(text.substr(0, dot), unit)) return std::nullopt;
    if (dot == std::string_view::npos) return unit;
    text.remove_prefix(dot + 1);
  }
}

}  // namespace riffle
