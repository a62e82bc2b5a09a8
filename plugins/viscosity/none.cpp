// No viscosity: viscous_pressure has no writer, so it is neither stored nor computed, and an equation set that reads it
// as optional skips the term. It is what leaving the viscosity out of the manifest does, under a name that a study can
// vary. Where it fails: without dissipation shocks ring and particles cross.
#include <riffle/sdk.hpp>

struct NoViscosity {
  static constexpr auto id = "none", kind = "viscosity", version = "1.0.0";
  static constexpr auto summary = "No viscosity, at no cost";
  static constexpr auto source = "the inviscid equations themselves";
  static constexpr auto leaves_out = "all dissipation: shocks ring and particles cross";
  explicit NoViscosity(const riffle::Values&) {}
};

RIFFLE_PLUGIN(NoViscosity)
