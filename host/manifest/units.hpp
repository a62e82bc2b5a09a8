// Quantities with units, as a manifest writes them ("15.9 mm", "1000 kg/m3", "20 l/s", "45 deg", "5 %") and as plugins
// declare theirs ("kg.m-3", "m2.s-1", "s.m-1/3", "m-d" with d the dimension of the scene).
//
// A unit is a chain of symbols joined by ".", "*", a space or "/"; a "/" divides by the one symbol that follows it. Each
// symbol may have an SI prefix and an exponent: m2, m^2, m-1/3, m^(-1/3), m².
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace riffle {

// Exponents of kg, m, s, K, A, mol, cd, in twelfths, so that thirds and quarters (Manning: s.m-1/3) are exact.
struct SiDimension {
  std::array<int, 7> twelfths{};
  bool operator==(const SiDimension&) const = default;
};

// 1 unit = numerator / denominator * 10^decimal in SI base units. The power of ten is kept apart so that "15.9 mm" is
// the same double as 0.0159.
struct ScaledUnit {
  double numerator = 1, denominator = 1;
  int decimal = 0;
  SiDimension dimension;
};

// The message is a clause such as: unknown unit "mmm"; did you mean "mm"?
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// `dim` is what the exponent d stands for; without it, d is refused (users write numbers). Throws UnitError.
ScaledUnit read_unit(std::string_view text, std::optional<int> dim = std::nullopt);

// A text that begins with a number and goes on, if at all, as a unit does. Texts that go on with an operator are formulas.
struct QuantityText {
  std::string number, unit;
};
std::optional<QuantityText> split_quantity(std::string_view text);

// In SI; nothing when the number is beyond the range of double.
std::optional<double> in_si(const QuantityText& quantity, const ScaledUnit& unit);

// "a length", "a kinematic viscosity", ...; "a quantity" when the dimension has no name of its own.
std::string_view name_of(const SiDimension& dimension);

}  // namespace riffle
