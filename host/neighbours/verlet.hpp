// Says how long a neighbour list with a skin stays complete while particles move and supports change.
//
// A list built with skin s holds all pairs that were then closer than (1 + s) kappa l. Particle i may have moved by d_i
// and any other by up to d_max, so a pair now at distance r was at most r + d_i + d_max apart. All pairs that must be
// in the list are in it if, for every particle i whose support counts,
//
//   (1 + s) kappa l_i(then) - kappa l_i(now) - d_i - d_max >= 0.
//
// Whose support counts: with `gather` the targets', with `scatter` the sources', with `either` both. For `either` no
// more is needed: the larger of the two supports now is that of one of the two particles, and for this one the
// inequality says that the pair was within its support, skin included, when the list was built.
// Images are not looked at: they move no more than their origins and have their smoothing lengths. A wall that moves
// while it mirrors breaks this rule; such lists must be rebuilt at every step.
#pragma once

#include <cstdint>
#include <vector>

#include "host/neighbours/neighbours.hpp"

namespace riffle {

class VerletCheck {
 public:
  // Call where the list is built, with the same arguments. The state is copied.
  void remember(const ParticleView& particles, double kappa, double skin, const NeighbourRequest& request);

  // What is left of the skin, m: the left side of the inequality, smallest over the particles. The list is complete as
  // long as this is not negative; +infinity when no particle's support counts, -infinity when nothing is remembered,
  // when the number of owned particles is another, or when a position is not finite. Particles must still be in the
  // order and have the roles that they had then.
  [[nodiscard]] double margin(const ParticleView& now) const;
  [[nodiscard]] bool valid(const ParticleView& now) const { return margin(now) >= 0; }

  void forget() { remembered_ = false; }  // after particles were sorted, added, removed or retagged

 private:
  bool remembered_ = false;
  std::int64_t owned_ = 0;
  double kappa_ = 0, skin_ = 0;
  NeighbourRequest request_;
  std::vector<double> x_[3], l_;  // [owned], when the list was built; l_ empty if uniform
  double uniform_l_ = 0;
};

}  // namespace riffle
