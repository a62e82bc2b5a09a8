// Dam breaks along a channel: where the front is, and how deep the water behind it. Plain functions over plain arrays.
#pragma once

#include <functional>
#include <optional>
#include <span>

namespace riffle {

// Two depths side by side, with a steep monotone passage between them: what a dam leaves when it goes.
struct DepthStep {
  double place = 0;            // m: where the depth is the mean of the two
  double left = 0, right = 0;  // m
};

// None where the depth is not such a step: the passage may take up a tenth of [low, high]. `depth` must be finite.
std::optional<DepthStep> depth_step(const std::function<double(double)>& depth, double low, double high);

// Distances from the step towards the shallower side, m; absent where there is no such thing.
struct Fronts {
  std::optional<double> toe;    // the depth is 1 % of the step above that in front
  std::optional<double> mid;    // halfway from the depth in front to the plateau
  std::optional<double> crest;  // the first crest behind them, above the plateau by 1 % of the step and more
  std::optional<double> crest_depth, plateau;  // m
};

// `x` in any order. The plateau is the mean depth of the quietest water: of all stretches as long as a tenth of the
// disturbed water (and of five particles) whose mean is 5 % of the step away from both initial depths, the one whose
// depth varies least; none where its standard deviation is above 2 % of the step, and none on a dry bed.
Fronts fronts(const DepthStep& step, std::span<const double> x, std::span<const double> depth);

}  // namespace riffle
