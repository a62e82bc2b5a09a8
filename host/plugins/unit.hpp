// Units as the plugin boundary writes them: SI base units as powers, "kg.m-3", "m2.s-1", "s.m-1/3", "1". The exponent
// may be the dimension d of the scene: "m-d" (a kernel), "m.md" (the water of a shallow-water particle).
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace riffle {

// Exponents are kept in twelfths, so that halves, thirds and quarters (Manning: s.m-1/3) are exact.
struct Unit {
  enum Base { metre, kilogram, second, kelvin, ampere, mole, candela, base_count };
  std::array<int, base_count> twelfths{};
  int metre_twelfths_per_dimension = 0;

  bool operator==(const Unit&) const = default;
  Unit operator*(const Unit& other) const;
  [[nodiscard]] Unit inverse() const;

  // Exponent of a base unit in `dim` dimensions.
  [[nodiscard]] double exponent(Base base, int dim) const;
};

// Nothing when the text is no unit.
std::optional<Unit> parse_unit(std::string_view text);

}  // namespace riffle
