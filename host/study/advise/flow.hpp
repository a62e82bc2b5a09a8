// A flow along a channel on a regular grid of points, and what can be read off it: differences, fronts, and how much
// vertical acceleration matters.
#pragma once

#include <vector>

namespace riffle {

struct FlowLine {
  double low = 0, high = 0;  // m
  std::vector<double> x, bed;
  [[nodiscard]] double step() const { return (high - low) / static_cast<double>(x.size()); }
};

struct FlowState {
  double time = 0;
  std::vector<double> depth, velocity;  // at the points of the line; 0 where it is dry
};

// n points, one in the middle of each of n equal cells.
FlowLine flow_line(double low, double high, int n);

// Values of particles, in any order, at the points of a line: linear between neighbours; beyond the outermost particle
// its value for one more distance between particles, or to the end of the line when it is no further off than three, then 0.
std::vector<double> along_line(const FlowLine& line, const std::vector<double>& x, const std::vector<double>& value);

// Sum of |a - b| over the sum of |b|, within [low, high].
double relative_difference(const FlowLine& line, const std::vector<double>& a, const std::vector<double>& b, double low,
                           double high);

// A bore or jump: over few points the depth rises and the water on both sides closes in.
struct Front {
  std::size_t begin = 0, end = 0;  // points
  double shallow = 0, deep = 0;    // depths on both sides, m
  [[nodiscard]] double strength() const { return (deep - shallow) / shallow; }
};
std::vector<Front> fronts_of(const FlowLine& line, const FlowState& state);

// Bores that rise by more than this share of the depth in front break, and waves do not grow behind them (Favre 1935:
// undular below 0.28, broken above 0.75).
inline constexpr double breaking_strength = 0.75;

// 2/3 of the vertical acceleration of the surface and that of the bed over gravity: non-hydrostatic over hydrostatic pressure at the
// bed, at every point; 0 within `fronts` and where it is dry. Lengths below a depth are averaged, for no pressure knows them.
std::vector<double> nonhydrostatic_ratio(const FlowLine& line, const FlowState& state, const std::vector<Front>& fronts,
                                         double gravity);

}  // namespace riffle
