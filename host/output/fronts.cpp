#include "host/output/fronts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace riffle {
namespace {

constexpr double noticeable = 0.01, plateau_margin = 0.05, plateau_spread = 0.02;  // of the step
constexpr double plateau_share = 0.1;                                              // of the disturbed water
constexpr std::size_t plateau_particles = 5;
constexpr double crest_search = 10;  // depths behind the middle of the front: waves are a few depths long

struct BreakProfile {  // along s, the distance from the step towards the shallower side, ascending
  std::vector<double> s, h;
  double deep, shallow;
  [[nodiscard]] std::size_t size() const { return s.size(); }
  [[nodiscard]] double step() const { return deep - shallow; }
  // Where h passes `level` between particles k and k + 1.
  [[nodiscard]] double passes(std::size_t k, double level) const {
    return s[k] + (s[k + 1] - s[k]) * (level - h[k]) / (h[k + 1] - h[k]);
  }
};

BreakProfile along(const DepthStep& step, std::span<const double> x, std::span<const double> depth) {
  const double direction = step.left > step.right ? 1 : -1;
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return direction * x[a] < direction * x[b]; });
  BreakProfile water{{}, {}, std::max(step.left, step.right), std::min(step.left, step.right)};
  for (const std::size_t k : order) {
    water.s.push_back(direction * (x[k] - step.place));
    water.h.push_back(depth[k]);
  }
  return water;
}

std::optional<double> plateau_of(const BreakProfile& water) {
  if (!(water.shallow > 0)) return std::nullopt;
  const std::size_t n = water.size();
  std::vector<double> length(n + 1), first(n + 1), second(n + 1);  // sums up to a particle: of lengths, h and h^2
  double disturbed = 0;
  const double middle = 0.5 * (water.deep + water.shallow), margin = (0.5 - plateau_margin) * water.step();
  for (std::size_t k = 0; k < n; ++k) {
    const double part = 0.5 * (water.s[std::min(k + 1, n - 1)] - water.s[k > 0 ? k - 1 : 0]), h = water.h[k] - middle;
    length[k + 1] = length[k] + part;
    first[k + 1] = first[k] + part * h;
    second[k + 1] = second[k] + part * h * h;
    if (std::abs(h) < (0.5 - noticeable) * water.step()) disturbed += part;
  }
  double least = plateau_spread * plateau_spread * water.step() * water.step();
  std::optional<double> found;
  for (std::size_t a = 0, b = 0; a < n; ++a) {
    while (b < n && (length[b] - length[a] < plateau_share * disturbed || b < a + plateau_particles)) ++b;
    const double part = length[b] - length[a];
    if (part < plateau_share * disturbed || b < a + plateau_particles) break;
    const double mean = (first[b] - first[a]) / part, variance = (second[b] - second[a]) / part - mean * mean;
    if (std::abs(mean) > margin || variance >= least) continue;
    least = variance;
    found = middle + mean;
  }
  return found;
}

// The particle nearest to the shallow end whose depth is above `level`.
std::optional<std::size_t> foremost_above(const BreakProfile& water, double level) {
  for (std::size_t k = water.size(); k-- > 0;) {
    if (water.h[k] > level) return k;
  }
  return std::nullopt;
}

void find_crest(const BreakProfile& water, std::size_t mid, double plateau, Fronts& found) {
  const double notice = noticeable * water.step();
  std::size_t highest = mid, k = mid;
  while (k > 0 && water.s[mid] - water.s[k] < crest_search * water.deep && water.h[k] > water.h[highest] - notice) {
    --k;
    if (water.h[k] > water.h[highest]) highest = k;
  }
  const bool falls = water.h[k] <= water.h[highest] - notice;
  if (!falls || water.h[highest] < plateau + notice || highest == 0) return;
  const double x0 = water.s[highest - 1], x1 = water.s[highest], x2 = water.s[highest + 1];  // a parabola through three
  const double before = (water.h[highest] - water.h[highest - 1]) / (x1 - x0);
  const double after = (water.h[highest + 1] - water.h[highest]) / (x2 - x1), bend = (after - before) / (x2 - x0);
  const double top = bend < 0 ? std::clamp(0.5 * (x0 + x1) - 0.5 * before / bend, x0, x2) : x1;
  found.crest = top;
  found.crest_depth = water.h[highest - 1] + (top - x0) * (before + bend * (top - x1));
}

}  // namespace

std::optional<DepthStep> depth_step(const std::function<double(double)>& depth, double low, double high) {
  constexpr int samples = 4000;
  DepthStep step{0, depth(low), depth(high)};
  const double rise = step.right - step.left, size = std::abs(rise);
  if (!(size > 1e-3 * std::max(step.left, step.right))) return std::nullopt;
  double begin = high, end = low, before = step.left;
  for (int k = 1; k < samples; ++k) {
    const double x = low + (high - low) * k / samples, h = depth(x);
    if ((h - before) * rise < -1e-9 * size * size) return std::nullopt;  // not monotone
    if (std::abs(h - step.left) > noticeable * size) begin = std::min(begin, x);
    if (std::abs(h - step.right) > noticeable * size) end = std::max(end, x);
    before = h;
  }
  if (end - begin > 0.1 * (high - low)) return std::nullopt;
  double a = low, b = high;
  for (int k = 0; k < 200 && a < b; ++k) {
    const double middle = 0.5 * (a + b);
    if (middle == a || middle == b) break;
    ((depth(middle) - 0.5 * (step.left + step.right)) * rise < 0 ? a : b) = middle;
  }
  step.place = b;
  return step;
}

Fronts fronts(const DepthStep& step, std::span<const double> x, std::span<const double> depth) {
  Fronts found;
  const BreakProfile water = along(step, x, depth);
  if (water.size() < 3) return found;
  const double toe = water.shallow + noticeable * water.step();
  found.plateau = plateau_of(water);
  if (!found.plateau) {
    const auto k = foremost_above(water, toe);
    if (k) found.toe = *k + 1 < water.size() ? water.passes(*k, toe) : water.s[*k];
    return found;
  }
  const double half = 0.5 * (water.shallow + *found.plateau);
  const auto mid = foremost_above(water, half);
  if (!mid || *mid + 1 == water.size()) return found;  // at the end of the channel
  found.mid = water.passes(*mid, half);
  std::size_t k = *mid;
  while (k + 1 < water.size() && water.h[k + 1] > toe) ++k;  // no further: ends of the channel make waves of their own
  if (k + 1 < water.size()) found.toe = water.passes(k, toe);
  find_crest(water, *mid, *found.plateau, found);
  return found;
}

}  // namespace riffle
