#include "host/study/advise/uniform.hpp"

#include <cmath>

namespace riffle {
namespace {

// Water that leaves at one end enters at the other: a boundary plugin whose parameter x says so.
bool goes_round(const Case& scene) {
  bool round = false;
  for (const PluginChoice& choice : scene.plugins) {
    if (choice.kind != "boundary") continue;
    for (const ParameterValue& value : choice.values) {
      if (value.name == "x" && value.number != 0) round = true;
      if ((value.name == "x_min" || value.name == "x_max") && value.number != 0) return false;
      if (value.name == "end" || value.name == "discharge") return false;  // an open end
    }
  }
  return round;
}

bool same_along_x(const Function& function, const Case& scene) {
  constexpr int points = 23;
  if (!function.valid()) return true;
  const auto at = [&](int axis, int k) {
    const auto a = static_cast<std::size_t>(axis);
    return scene.lower[a] + (scene.upper[a] - scene.lower[a]) * (k + 0.5) / points;
  };
  const int up = scene.dimension - 1;
  for (int j = 0; j < points; ++j) {
    const double z = at(up, j), first = function(at(0, 0), 0, z);
    for (int k = 1; k < points; ++k) {
      const double other = function(at(0, k), 0, z);
      if (std::abs(other - first) > 1e-9 * (std::abs(first) + std::abs(other))) return false;
    }
  }
  return true;
}

}  // namespace

bool uniform_along_x(const Case& scene) {
  if (!goes_round(scene) || !same_along_x(scene.placement.inside, scene)) return false;
  for (const auto& [field, functions] : scene.initial) {
    for (const Function& function : functions) {
      if (!same_along_x(function, scene)) return false;
    }
  }
  for (const PluginChoice& choice : scene.plugins) {
    for (const ParameterValue& value : choice.values) {
      if (value.function != nullptr && !same_along_x(*value.function, scene)) return false;
    }
  }
  return true;
}

}  // namespace riffle
