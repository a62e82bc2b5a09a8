// The free surface of water in the vertical plane, and how far it is from the measured one of [surface].
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "host/output/run_record.hpp"
#include "host/time/simulation.hpp"

namespace riffle {

// Levels of the surface at the abscissae x: the highest place where the divergence of the position, which is 2 within water
// and 1 at an even edge of it, is 1: div r = - sum_j V_j F r^2 over the particles of all roles (Kazemi 2017, eq. 5.11).
// NaN where there is none. Brings the volumes of the particles up to date.
std::vector<double> surface_levels(Simulation& simulation, const std::vector<double>& x);

class SurfaceComparison {
 public:
  explicit SurfaceComparison(const Case& scene) : scene_(scene) {}
  // The next measured time after t; infinity when there is none.
  [[nodiscard]] double next(double t) const;
  // Compares when there are measurements at the time of the simulation.
  void look(Simulation& simulation);
  // Of the times so far; empty when none had a point within the domain.
  [[nodiscard]] std::vector<SurfaceError> errors() const;
  // t, x, measured and computed level of every point, as CSV.
  void write(const std::filesystem::path& file) const;

  [[nodiscard]] nlohmann::json state() const;
  void restore(const nlohmann::json& state);

 private:
  struct Point {
    double t, x, measured, computed;
  };
  const Case& scene_;
  std::vector<Point> found_;
};

}  // namespace riffle
