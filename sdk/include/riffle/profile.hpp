// Profiles b(x) for plugins of kind bed and width: of a slope that is known, and of one that follows from the values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace riffle {

// slope[k] = db/dx at x[k], by central differences (error of about 1e-10 relative); at a kink or a jump it is the smaller
// of the slopes on either side. `evaluate(n, x, value)` gives b.
template <class Evaluate>
void slope_by_differences(std::int64_t n, const double* x, double* slope, Evaluate evaluate) {
  const auto size = static_cast<std::size_t>(n);
  std::vector<double> at(3 * size), value(3 * size);
  std::vector<double> step(size);
  for (std::size_t k = 0; k < size; ++k) {
    step[k] = 1e-5 * std::max(1.0, std::abs(x[k]));
    at[k] = x[k] - step[k];
    at[size + k] = x[k];
    at[2 * size + k] = x[k] + step[k];
  }
  evaluate(3 * n, at.data(), value.data());
  for (std::size_t k = 0; k < size; ++k) {
    const double left = (value[size + k] - value[k]) / (at[size + k] - at[k]);
    const double right = (value[2 * size + k] - value[size + k]) / (at[2 * size + k] - at[size + k]);
    const bool smooth = std::abs(left - right) <= 1e-3 * (std::abs(left) + std::abs(right)) + 1e-4;
    slope[k] = smooth ? 0.5 * (left + right) : std::abs(left) < std::abs(right) ? left : right;
  }
}

// A profile that varies along x only and knows its slope: f(x) gives {value, slope}. Slopes may be null.
struct ProfilePoint {
  double value, slope;
};
template <class F>
void profile_along_x(std::int64_t n, const double* x, double* value, double* slope_x, double* slope_y, F f) {
  for (std::int64_t k = 0; k < n; ++k) {
    const ProfilePoint point = f(x[k]);
    value[k] = point.value;
    if (slope_x != nullptr) slope_x[k] = point.slope;
    if (slope_y != nullptr) slope_y[k] = 0;
  }
}

}  // namespace riffle
