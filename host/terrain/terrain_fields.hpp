// The fields that the host makes of bed and width, as passes of a plugin of its own: used where a pass reads them and
// nobody else writes them.
#pragma once

#include <memory>

#include "host/schedule/graph.hpp"
#include "host/terrain/terrain.hpp"

namespace riffle {

class SmoothedBed;

class TerrainFields {
 public:
  static constexpr auto kind = "host";
  // `kernel`: the scene's, which smoothes the bed; may be nullptr.
  TerrainFields(const Terrain& terrain, const Case& scene, const PluginInstance* kernel);
  ~TerrainFields();
  TerrainFields(const TerrainFields&) = delete;
  TerrainFields& operator=(const TerrainFields&) = delete;

  // Only the fields that the scene's terrain gives: none without a bed, none without a width.
  [[nodiscard]] ActivePlugin as_plugin() const;
  // The smoothed bed needs to know how fine: call when the particles have been placed.
  void prepare(double smallest_spacing, double largest_spacing);

  [[nodiscard]] const Terrain& terrain() const { return terrain_; }
  [[nodiscard]] const SmoothedBed& smoothed() const { return *smoothed_; }

 private:
  const Terrain& terrain_;
  const Case& scene_;
  const PluginInstance* kernel_;
  std::unique_ptr<SmoothedBed> smoothed_;
};

}  // namespace riffle
