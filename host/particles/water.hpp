// The water of a case at t = 0, as the placement of particles sees it.
#pragma once

#include <cstdint>
#include <vector>

#include "host/manifest/case.hpp"

namespace riffle {

class Water {
 public:
  explicit Water(const Case& scene);

  // out[k] = the depth (1 where the equation set has none) where it is above 0 and inside, else 0. y and z may be null.
  // Throws PlacementError where a function is not finite.
  void depth(std::int64_t n, const double* x, const double* y, const double* z, double* out) const;
  [[nodiscard]] double depth(double x, double y = 0, double z = 0) const;

  // Why there is none, to follow "no particle results: ".
  [[nodiscard]] std::string why_dry() const;

 private:
  const Function* depth_ = nullptr;
  const Function* inside_ = nullptr;
};

// A part of the axis where there is water and its depth does not jump.
struct Stretch {
  double begin, end;
  std::vector<double> inner;  // sample points between the two
};

// The stretches of [low, high] from low to high, found with about `samples` points.
std::vector<Stretch> stretches_of(const Water& water, double low, double high, std::int64_t samples);

}  // namespace riffle
