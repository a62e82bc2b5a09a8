// What a glance along the line of particles can tell, in one dimension. Plain functions over plain arrays.
#pragma once

#include <cstdint>
#include <vector>

namespace riffle {

// Particles on a line: water, and what stands beyond or among it (buffers, walls, images).
struct LineView {
  std::vector<double> x, reach;  // of the water, ascending in x; reach: kappa l
  std::vector<double> others;    // positions, any order
};

struct LineLook {
  std::int64_t one_sided = 0;  // water that sees nobody on one side, though somebody is there further out
  double one_sided_at = 0;     // m: where the first of them is
  double stretched = 0;        // share of the water whose gap to one side is more than stretched_gap of its reach
  double paired = 0;           // share of the water between gaps that differ by more than paired_gaps and alternate
};

constexpr double stretched_gap = 0.75, paired_gaps = 1.2;

// `x` must be ascending.
LineLook look_along(const LineView& line);

// How many particles now stand on another side of a neighbour than before: of the ids that both orders hold, those that
// follow a larger rank. 0 when nobody has overtaken anybody, also where the channel is closed to a ring and particles
// leave at one end to come in at the other. Ids are not negative.
std::int64_t overtakings(const std::vector<std::int64_t>& before, const std::vector<std::int64_t>& now);

}  // namespace riffle
