// How far a computed field is from an exact or measured one, and its extremes.
//
//   L2   = sqrt( 1/N sum_i ((phi_i - phi_i^e) / s_i)^2 )          Diwakar & Mohapatra (2023), eq. 17
//   L1   = sum_i |phi_i - phi_i^e| dx_i / sum_i |phi_i^e| dx_i    the share of the field's integral that is misplaced
//   mean = |sum_i (phi_i - phi_i^e) dx_i| / sum_i |phi_i^e| dx_i  the same for the integral itself: of a velocity, the discharge
//   Linf = max_i |phi_i - phi_i^e| / s_i
//
// The scale s is the paper's phi^N: the exact depth for a depth, sqrt(g h^e) for a velocity. Where the exact field is
// zero everywhere (water at rest) L1 and mean are divided by sum_i s_i dx_i instead, and the record says so.
// At a shock L2 is made by one to three particles and converges with N^-1/2 at best; L1 is the one to judge order by.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace riffle {

// All spans have one length, that of the particles. Units: those of the field; measure in m, m2 or m3.
struct ErrorInput {
  std::span<const double> computed, exact, scale;
  std::span<const double> measure;       // dx: the length, area or volume that each particle stands for
  std::span<const std::uint8_t> counts;  // 0 where the reference is not defined or was asked to be left out
};

struct FieldErrors {
  double l1 = 0, l2 = 0, linf = 0, mean = 0;  // dimensionless; NaN when no particle counts or a value is not finite
  std::int64_t count = 0, ignored = 0;  // particles in the norms and left out; their sum is the number of particles
  std::string normalisation;            // of l1 and mean: "exact" or "scale"
};

// A particle whose scale is not a number above 0 is ignored. Sums are compensated and in the order given.
FieldErrors field_errors(const ErrorInput& input);

struct Extrema {
  double min = 0, max = 0, max_abs = 0;  // NaN for an empty field and for one that holds a NaN
};
Extrema extrema(std::span<const double> values);

}  // namespace riffle
