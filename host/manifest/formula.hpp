// Formulas in x, y, z and t (SI), parsed by muParser: its operators, functions and a ? b : c, with the constants pi and
// g (the gravity of the manifest).
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "host/manifest/function.hpp"

namespace riffle {

class FormulaError : public std::runtime_error {
 public:
  FormulaError(const std::string& message, std::optional<std::size_t> byte) : std::runtime_error(message), byte(byte) {}
  std::optional<std::size_t> byte;  // offset in the text where it goes wrong, when known
};

struct Formula {
  std::shared_ptr<const Function::Implementation> implementation;
  std::array<bool, 4> uses{};  // x, y, z, t
};

// Throws FormulaError.
Formula parse_formula(const std::string& text, double gravity);

}  // namespace riffle
