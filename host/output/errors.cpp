#include "host/output/errors.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "host/output/sum.hpp"

namespace riffle {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Unlike std::max this keeps a NaN.
double larger(double a, double b) {
  return std::isnan(a) || a > b ? a : b;
}

// Below this share of the scale the exact field is round-off of zero: sqrt(g h) times a few hundred epsilon.
constexpr double zero_field = 1e-13;

}  // namespace

FieldErrors field_errors(const ErrorInput& in) {
  const std::size_t n = in.computed.size();
  assert(in.exact.size() == n && in.scale.size() == n && in.measure.size() == n && in.counts.size() == n);
  FieldErrors errors;
  CompensatedSum squares, misplaced, missing, integral, scale_integral;
  for (std::size_t i = 0; i < n; ++i) {
    if (in.counts[i] == 0 || !(in.scale[i] > 0) || std::isinf(in.scale[i])) continue;
    const double difference = std::abs(in.computed[i] - in.exact[i]);
    const double relative = difference / in.scale[i];
    squares.add(relative * relative);
    misplaced.add(difference * in.measure[i]);
    missing.add((in.computed[i] - in.exact[i]) * in.measure[i]);
    integral.add(std::abs(in.exact[i]) * in.measure[i]);
    scale_integral.add(in.scale[i] * in.measure[i]);
    errors.linf = larger(errors.linf, relative);
    ++errors.count;
  }
  errors.ignored = static_cast<std::int64_t>(n) - errors.count;
  const bool zero = integral.value() <= zero_field * scale_integral.value();
  errors.normalisation = zero ? "scale" : "exact";
  if (errors.count == 0) {
    errors.l1 = errors.l2 = errors.linf = errors.mean = nan;
    return errors;
  }
  errors.l2 = std::sqrt(squares.value() / static_cast<double>(errors.count));
  errors.l1 = misplaced.value() / (zero ? scale_integral : integral).value();
  errors.mean = std::abs(missing.value()) / (zero ? scale_integral : integral).value();
  return errors;
}

Extrema extrema(std::span<const double> values) {
  if (values.empty() || std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) {
    return {nan, nan, nan};
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high, std::max(std::abs(*low), std::abs(*high))};
}

}  // namespace riffle
