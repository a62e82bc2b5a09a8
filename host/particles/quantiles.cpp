#include "host/particles/quantiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace riffle {
namespace {

// Three Gauss points: exact for polynomials up to degree 5, and never at the ends, where the depth may jump.
constexpr double outer_point = 0.7745966692414834;  // sqrt(3/5)
constexpr std::array<double, 3> points{-outer_point, 0, outer_point};
constexpr std::array<double, 3> weights{5.0 / 18, 8.0 / 18, 5.0 / 18};

}  // namespace

RunningVolume::RunningVolume(const Water& water, const std::vector<Stretch>& stretches) : water_(water) {
  // Neumaier's compensated sum, so that the positions of equal cells are as exact as if they had been multiplied out.
  double sum = 0, lost = 0;
  for (const Stretch& stretch : stretches) {
    double begin = stretch.begin;
    for (std::size_t k = 0; k <= stretch.inner.size(); ++k) {
      const double end = k < stretch.inner.size() ? stretch.inner[k] : stretch.end;
      if (!(end > begin)) continue;
      const double part = integral(begin, end);
      const double next = sum + part;
      lost += std::abs(sum) >= std::abs(part) ? (sum - next) + part : (part - next) + sum;
      sum = next;
      intervals_.push_back({begin, end});
      sum_.push_back(sum + lost);
      begin = end;
    }
  }
}

double RunningVolume::integral(double begin, double end) const {
  std::array<double, 3> x{}, depth{};
  for (std::size_t k = 0; k < points.size(); ++k) x[k] = begin + (end - begin) * (0.5 + 0.5 * points[k]);
  water_.depth(3, x.data(), nullptr, nullptr, depth.data());
  // The end result for a constant depth is then free of the round-off of the weights.
  if (depth[0] == depth[1] && depth[1] == depth[2]) return (end - begin) * depth[1];
  return (end - begin) * (weights[0] * depth[0] + weights[1] * depth[1] + weights[2] * depth[2]);
}

double RunningVolume::position(double volume) const {
  const auto found = std::lower_bound(sum_.begin(), sum_.end(), volume);
  const auto k = static_cast<std::size_t>(std::min(found, sum_.end() - 1) - sum_.begin());
  const Interval& interval = intervals_[k];
  const double before = k > 0 ? sum_[k - 1] : 0.0;
  const double wanted = volume - before, all = sum_[k] - before;
  double low = interval.begin, high = interval.end;
  if (!(all > 0)) return low;
  // Newton's method kept between the ends; a few steps as the depth changes little within an interval.
  double x = low + (high - low) * std::clamp(wanted / all, 0.0, 1.0);
  for (int step = 0; step < 60; ++step) {
    const double excess = integral(interval.begin, x) - wanted;
    if (std::abs(excess) <= 4e-16 * all) break;
    (excess > 0 ? high : low) = x;
    const double depth = water_.depth(x);
    const double next = depth > 0 ? x - excess / depth : low;
    const double bracketed = next > low && next < high ? next : low + (high - low) / 2;
    if (bracketed == x) break;
    x = bracketed;
  }
  return x;
}

}  // namespace riffle
