// The bed and the width of a scene, from its plugins of these kinds: a flat bed at 0 and a width of 1 m where it names none.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/manifest/case.hpp"
#include "host/plugins/instance.hpp"
#include "riffle/abi.h"

namespace riffle {

class Terrain {
 public:
  // `bed`, `width`: nullptr when the scene names none. They must outlive the terrain. Throws std::runtime_error, one
  // sentence, where a profile is not finite or a width not above 0 within the domain.
  Terrain(const Case& scene, const PluginInstance* bed, const PluginInstance* width);
  Terrain(const Terrain&) = delete;
  Terrain& operator=(const Terrain&) = delete;

  // What plugins are connected to; valid as long as the terrain.
  [[nodiscard]] const riffle_services& services() const { return services_; }
  // What plugins said of a scene that is doubtful, each once.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  [[nodiscard]] bool has_bed() const { return bed_ != nullptr; }
  [[nodiscard]] bool has_width() const { return width_ != nullptr; }
  // level [m] and gradient [1] at n points; y and slopes may be null. Throws std::runtime_error when the plugin fails.
  void bed(std::int64_t n, const double* x, const double* y, double* level, double* slope_x, double* slope_y) const;
  void width(std::int64_t n, const double* x, double* width, double* slope) const;

 private:
  void check(const Case& scene) const;

  const PluginInstance *bed_, *width_;
  riffle_services services_{};
  mutable std::vector<std::string> warnings_;
};

// initial.depth of a case that gives the level instead: what lies between it and the bed, 0 where the bed is higher.
Function depth_below(const Function& level, const Terrain& terrain);

}  // namespace riffle
