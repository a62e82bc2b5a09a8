// A run against its reference solution: exact values at the particles, errors, and the series of the picture.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/output/errors.hpp"
#include "host/time/simulation.hpp"

namespace riffle {

struct ExactField {
  std::string name, unit;  // components of vectors are "velocity" in 1D, "velocity_x", ... otherwise
  std::string field;       // name in the store
  int component = 0;
  std::vector<double> exact, scale;  // per particle of the water; exact is NaN where not defined
  std::vector<std::uint8_t> counts;
};

class Comparison {
 public:
  // Throws PluginError when the reference refuses its parameters.
  Comparison(const Case& scene, const Registry& registry, const riffle_services& services);

  // At the particles of the water, at the simulation's time.
  [[nodiscard]] std::vector<ExactField> at_particles(const Simulation& simulation) const;
  // Along x, for the line of the picture: name -> values at the given places.
  [[nodiscard]] std::map<std::string, std::vector<double>> along(const std::vector<double>& x, double time) const;
  [[nodiscard]] std::map<std::string, FieldErrors> errors(const Simulation& simulation,
                                                          const std::vector<ExactField>& exact) const;

 private:
  struct Values;
  [[nodiscard]] Values evaluate(std::int64_t n, const double* const x[3], double time) const;

  const Case& case_;
  std::unique_ptr<PluginInstance> reference_;
};

// The length, area or volume that each particle of the water stands for now: conserved amount over depth or density.
std::vector<double> particle_measure(const Simulation& simulation);

}  // namespace riffle
