#include "host/study/advise/dispersion.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace riffle {
namespace {

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double of_front(const Front& front, double gravity, double time, bool steady) {
  const double h1 = front.shallow, rise = front.deep - front.shallow, d = front.strength();
  const double c1 = std::sqrt(gravity * h1), rounded = std::cbrt(0.5 * h1 * h1 * c1 * time);
  if (d > breaking_strength) return rise * (steady ? 1.5 * front.deep : std::min(1.8 * rounded, 3.6 * front.deep));
  return h1 * c1 * time * d * d / (1 + d) + 1.3 * rise * rounded;
}

// Jumps of the level at t = 0, however the water moves.
double largest_drop(const FlowLine& line, const FlowState& state, double& above) {
  double largest = 0;
  const double window = std::max(line.step(), *std::max_element(state.depth.begin(), state.depth.end()));
  const auto reach = static_cast<std::size_t>(std::ceil(window / line.step()));
  for (std::size_t k = 0; k + reach < line.x.size(); ++k) {
    const double a = state.depth[k] + line.bed[k], b = state.depth[k + reach] + line.bed[k + reach];
    const bool wet = state.depth[k] > 0 || state.depth[k + reach] > 0;
    if (wet && std::abs(a - b) > largest) {
      largest = std::abs(a - b);
      above = std::max(state.depth[k], state.depth[k + reach]);
    }
  }
  return largest;
}

// Without fronts: a share of the depth.
double of_smooth_flow(const FlowLine& line, const FlowState& state, const std::vector<double>& ratio, double gravity,
                      bool steady) {
  const double volume = sum_of(state.depth);
  if (!(volume > 0)) return 0;
  if (steady) {
    double change = 0;
    for (std::size_t k = 0; k < ratio.size(); ++k) {
      if (!(state.depth[k] > 0)) continue;
      const double froude = state.velocity[k] * state.velocity[k] / (gravity * state.depth[k]);
      change += 0.5 * ratio[k] * state.depth[k] / (std::abs(1 - froude) + 0.3);
    }
    return change / volume;
  }
  std::vector<double> level(state.depth);
  for (std::size_t k = 0; k < level.size(); ++k) level[k] += line.bed[k];
  std::vector<double> sorted(level);
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
  const double still = sorted[sorted.size() / 2], depth = volume / static_cast<double>(level.size());
  double elevation = 0, climb = 0, pressure = 0;
  for (std::size_t k = 0; k < level.size(); ++k) {
    elevation += std::abs(level[k] - still);
    if (k > 0 && ratio[k] > 0) climb += std::abs(level[k] - level[k - 1]);
    pressure += ratio[k];
  }
  if (!(elevation > 0)) return 0;
  const double way = std::sqrt(gravity * depth) * state.time;
  const double lag = way * pressure * depth / (4 * elevation);
  return std::min(2 * elevation, climb * lag / line.step()) / volume;
}

}  // namespace

DispersionEstimate estimate_dispersion(const Scout& scout, double gravity, bool steady) {
  DispersionEstimate estimate;
  const FlowLine& line = scout.line;
  std::vector<double> seen;
  double smooth = 0;
  for (std::size_t s = 0; s < scout.states.size(); ++s) {
    const FlowState& state = scout.states[s];
    const std::vector<Front> fronts = fronts_of(line, state);
    const std::vector<double> ratio = nonhydrostatic_ratio(line, state, fronts, gravity);
    if (s > 0 || scout.states.size() == 1) {
      for (std::size_t k = 0; k < ratio.size(); ++k) {
        if (state.depth[k] > 0) seen.push_back(ratio[k]);
      }
    }
    // The first state tells of waves that become a front only because nothing disperses them, unless it is a sketch with jumps.
    FlowState late = state;
    late.time = scout.last().time;
    const bool sketch = *std::max_element(ratio.begin(), ratio.end()) > 1;
    if (s + 1 == scout.states.size() || (s == 0 && !steady && !sketch)) {
      smooth = std::max(smooth, of_smooth_flow(line, late, ratio, gravity, steady));
    }
  }
  estimate.smooth = smooth;
  if (!seen.empty()) {
    const std::size_t place = seen.size() * 995 / 1000;
    std::nth_element(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(place), seen.end());
    estimate.largest_ratio = seen[place];
  }
  const FlowState& last = scout.last();
  double bores = 0, highest = 0;
  for (const Front& front : fronts_of(line, last)) {
    bores += of_front(front, gravity, last.time, steady);
    estimate.strongest_front = std::max(estimate.strongest_front, front.strength());
    highest = std::max(highest, front.deep - front.shallow);
    estimate.breaks = estimate.breaks || front.strength() > breaking_strength;
  }
  double above = 0;
  const double drop = largest_drop(line, scout.states.front(), above);
  if (!steady && drop > highest) bores += 0.3 * above * (drop - highest);
  const double volume = sum_of(last.depth) * line.step();
  estimate.fronts = volume > 0 ? bores / volume : 0;
  return estimate;
}

}  // namespace riffle
