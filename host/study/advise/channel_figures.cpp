#include "host/study/advise/channel_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace riffle {
namespace {

const ParameterValue* parameter_of(const Case& scene, const std::string& kind, const std::string& unit) {
  for (const PluginChoice& choice : scene.plugins) {
    if (choice.kind != kind) continue;
    for (std::size_t p = 0; p < choice.values.size(); ++p) {
      if (choice.description->parameters[p].unit == unit && choice.values[p].function == nullptr)
        return &choice.values[p];
    }
  }
  return nullptr;
}

double steady_from(const Scout& scout, double tolerance) {
  const FlowLine& line = scout.line;
  double from = scout.last().time;
  for (std::size_t s = scout.states.size() - 1; s-- > 0;) {
    const FlowState& state = scout.states[s];
    if (relative_difference(line, state.depth, scout.last().depth, line.low, line.high) > tolerance / 4) break;
    from = state.time;
  }
  return from;
}

}  // namespace

ChannelScales scales_of(const Scout& scout, const Case& scene, double tolerance) {
  ChannelScales scales;
  const FlowLine& line = scout.line;
  const FlowState& first = scout.states.front();
  std::vector<char> moved(line.x.size(), 0);
  double sum = 0, wet = 0, steepest = 0;
  for (const FlowState& state : scout.states) {
    const std::vector<Front> fronts = fronts_of(line, state);
    for (std::size_t k = 0; k < line.x.size(); ++k) {
      const double h = state.depth[k], u = std::abs(state.velocity[k]);
      if (!(h > 0)) continue;
      sum += h;
      wet += 1;
      scales.deepest = std::max(scales.deepest, h);
      scales.speed = std::max(scales.speed, u);
      const double froude = u / std::sqrt(scene.gravity * h);
      if (h > 1e-3 * scales.deepest) scales.froude = std::max(scales.froude, froude);
      if (froude > 1e-3 || std::abs(h - first.depth[k]) > 1e-3 * scales.deepest) moved[k] = 1;
      const auto in = [&](const Front& front) { return k >= front.begin && k <= front.end; };
      if (k > 0 && state.depth[k - 1] > 0 && std::none_of(fronts.begin(), fronts.end(), in)) {
        const double rise = h + line.bed[k] - state.depth[k - 1] - line.bed[k - 1];
        steepest = std::max(steepest, std::abs(rise) / line.step());
      }
    }
  }
  scales.depth = wet > 0 ? sum / wet : 0;
  scales.slope_length = steepest > 0 ? scales.depth / steepest : std::numeric_limits<double>::infinity();
  scales.moved = static_cast<double>(std::count(moved.begin(), moved.end(), 1)) / static_cast<double>(moved.size());
  scales.steady_from = steady_from(scout, tolerance);
  scales.reynolds = scene.viscosity > 0 ? scales.speed * scales.depth / scene.viscosity : 0;
  return scales;
}

double roughness_of(const Case& scene, double depth) {
  double n = std::numeric_limits<double>::quiet_NaN();
  if (const ParameterValue* manning = parameter_of(scene, "drag", "s.m-1/3")) {
    n = manning->number;
  } else if (const ParameterValue* chezy = parameter_of(scene, "drag", "m1/2.s-1")) {
    n = chezy->number > 0 ? std::pow(depth, 1.0 / 6) / chezy->number : n;
  }
  return std::pow(21.1 * n, 6);
}

std::vector<SceneFigure> figures_of(const ChannelScales& scales, const DispersionEstimate& dispersion,
                                    const Case& scene) {
  std::vector<SceneFigure> figures{
      {"mean_depth", "mean depth", "m", scales.depth},
      {"froude_number", "largest Froude number", "1", scales.froude},
      {"depth_over_length", "depth over the shortest length on which the level changes, fronts aside", "1",
       scales.depth / scales.slope_length},
      {"nonhydrostatic_ratio", "pressure of vertical acceleration over hydrostatic, fronts aside", "1",
       dispersion.largest_ratio},
      {"front_strength", "rise of the strongest bore over the depth in front of it", "1", dispersion.strongest_front},
      {"reynolds_number", "Reynolds number of the depth", "1", scales.reynolds},
      {"moving_share", "share of the channel that moves at any time", "1", scales.moved},
      {"steady_from", "time from which nothing changes any more", "s", scales.steady_from}};
  const double roughness = roughness_of(scene, scales.depth);
  if (std::isfinite(roughness))
    figures.push_back({"roughness_over_depth", "roughness over depth", "1", roughness / scales.depth});
  return figures;
}

}  // namespace riffle
