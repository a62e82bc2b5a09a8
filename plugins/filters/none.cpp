// No filter: densities and positions stay as the equations leave them. It is what leaving the filter out of the manifest
// does, under a name that a study can vary.
#include <riffle/sdk.hpp>

struct NoFilter {
  static constexpr auto id = "none", kind = "filter", version = "1.0.0";
  static constexpr auto summary = "No filter, at no cost";
  static constexpr auto source = "the equations themselves";
  static constexpr auto leaves_out = "all smoothing of density: pressures of weakly compressible water ring";
  explicit NoFilter(const riffle::Values&) {}
};

RIFFLE_PLUGIN(NoFilter)
