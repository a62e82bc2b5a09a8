// No turbulence model: eddy_viscosity has no writer, so it is neither stored nor computed, and an equation set that reads it
// as optional leaves the eddy stress out. It is what leaving the model out of the manifest does, under a name that a study
// can vary.
#include <riffle/sdk.hpp>

struct NoTurbulence {
  static constexpr auto id = "none", kind = "turbulence", version = "1.0.0";
  static constexpr auto summary = "No turbulence model, at no cost";
  static constexpr auto source = "the laminar equations themselves";
  static constexpr auto leaves_out = "all mixing by eddies: channels run much too fast";
  explicit NoTurbulence(const riffle::Values&) {}
};

RIFFLE_PLUGIN(NoTurbulence)
