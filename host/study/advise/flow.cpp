#include "host/study/advise/flow.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace riffle {

FlowLine flow_line(double low, double high, int n) {
  FlowLine line{low, high, std::vector<double>(static_cast<std::size_t>(n)), {}};
  for (std::size_t k = 0; k < line.x.size(); ++k) line.x[k] = low + (high - low) * (static_cast<double>(k) + 0.5) / n;
  line.bed.assign(line.x.size(), 0);
  return line;
}

std::vector<double> along_line(const FlowLine& line, const std::vector<double>& x, const std::vector<double>& value) {
  std::vector<double> result(line.x.size(), 0);
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  if (order.size() < 2) return result;
  const double first = x[order.front()], last = x[order.back()];
  const double first_gap = x[order[1]] - first, last_gap = last - x[order[order.size() - 2]];
  std::size_t next = 0;
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    const double at = line.x[k];
    while (next < order.size() && x[order[next]] < at) ++next;
    if (next == 0) {
      const bool wall = first - line.low < 3 * first_gap;
      if (wall || first - at < first_gap) result[k] = value[order.front()];
    } else if (next == order.size()) {
      const bool wall = line.high - last < 3 * last_gap;
      if (wall || at - last < last_gap) result[k] = value[order.back()];
    } else {
      const std::size_t a = order[next - 1], b = order[next];
      const double share = x[b] > x[a] ? (at - x[a]) / (x[b] - x[a]) : 0;
      result[k] = value[a] + share * (value[b] - value[a]);
    }
  }
  return result;
}

double relative_difference(const FlowLine& line, const std::vector<double>& a, const std::vector<double>& b, double low,
                           double high) {
  double apart = 0, sum = 0;
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    if (line.x[k] < low || line.x[k] > high) continue;
    apart += std::abs(a[k] - b[k]);
    sum += std::abs(b[k]);
  }
  return sum > 0 ? apart / sum : apart > 0 ? 1 : 0;
}

std::vector<Front> fronts_of(const FlowLine& line, const FlowState& state) {
  constexpr double steep = 0.01;  // change of the level from point to point over the depth
  constexpr std::size_t widest = 14, beside = 2;
  std::vector<Front> fronts;
  const std::vector<double>&h = state.depth, &u = state.velocity;
  const auto closes_in = [&](std::size_t k) {  // between k and k + 1
    const double rise = std::abs(h[k + 1] - h[k]), bed = std::abs(line.bed[k + 1] - line.bed[k]);
    const double depth = std::max(h[k], h[k + 1]);
    return depth > 0 && rise > steep * depth && bed < 0.5 * rise && u[k] > u[k + 1];
  };
  for (std::size_t k = 0; k + 1 < h.size();) {
    if (!closes_in(k)) {
      ++k;
      continue;
    }
    std::size_t last = k;
    for (std::size_t m = k; m + 1 < h.size() && m <= last + 2; ++m) {
      if (closes_in(m) && (h[m + 1] > h[m]) == (h[k + 1] > h[k])) last = m;
    }
    const std::size_t begin = k >= beside ? k - beside : 0, end = std::min(last + 1 + beside, h.size() - 1);
    const Front front{begin, end, std::min(h[begin], h[end]), std::max(h[begin], h[end])};
    if (last - k < widest && front.shallow > 0 && front.strength() > 0.02) fronts.push_back(front);
    k = last + 1;
  }
  return fronts;
}

std::vector<double> nonhydrostatic_ratio(const FlowLine& line, const FlowState& state, const std::vector<Front>& fronts,
                                         double gravity) {
  const std::size_t n = line.x.size();
  const double dx = line.step();
  const auto smooth = [&](const auto& value, std::size_t k) {  // over a depth
    const auto half = static_cast<std::size_t>(std::max(1.0, 0.5 * state.depth[k] / dx));
    const std::size_t begin = k > half ? k - half : 0, end = std::min(k + half, n - 1);
    double sum = 0;
    for (std::size_t m = begin; m <= end; ++m) sum += value(m);
    return sum / static_cast<double>(end - begin + 1);
  };
  std::vector<double> level(n), bed(n), velocity(n), ratio(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    level[k] = smooth([&](std::size_t m) { return state.depth[m] + line.bed[m]; }, k);
    bed[k] = smooth([&](std::size_t m) { return line.bed[m]; }, k);
    velocity[k] = smooth([&](std::size_t m) { return state.velocity[m]; }, k);
  }
  for (std::size_t k = 1; k + 1 < n; ++k) {
    if (!(std::min({state.depth[k - 1], state.depth[k], state.depth[k + 1]}) > 0)) continue;
    const double h = state.depth[k], u = velocity[k], u_x = (velocity[k + 1] - velocity[k - 1]) / (2 * dx);
    const double slope = (level[k + 1] - level[k - 1]) / (2 * dx), b_x = (bed[k + 1] - bed[k - 1]) / (2 * dx);
    const double curvature = (level[k + 1] - 2 * level[k] + level[k - 1]) / (dx * dx);
    const double b_xx = (bed[k + 1] - 2 * bed[k] + bed[k - 1]) / (dx * dx);
    const double depth = 2 * h * u_x * u_x + h * gravity * curvature;  // d2h/dt2 of hydrostatic flow
    const double ground = u * u * b_xx - gravity * slope * b_x;
    ratio[k] = std::abs(2.0 / 3.0 * depth + ground) / gravity;
  }
  for (const Front& front : fronts) {
    const std::size_t begin = front.begin > 4 ? front.begin - 4 : 0, end = std::min(front.end + 4, n - 1);
    for (std::size_t k = begin; k <= end; ++k) ratio[k] = 0;
  }
  return ratio;
}

}  // namespace riffle
