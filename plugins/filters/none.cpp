// No filter: density and positions stay as the equations leave them.
#include <riffle/sdk.hpp>

struct None {
  static constexpr auto id = "none", kind = "filter", version = "1.0.0";
  static constexpr auto summary = "No filter";
  static constexpr auto source = "";
  explicit None(const riffle::Values&) {}
};

RIFFLE_PLUGIN(None)
