// Particles sorted along a line.
#pragma once

#include <cstdint>
#include <vector>

#include "host/neighbours/neighbours.hpp"

namespace riffle {

struct Line {
  std::vector<double> x;                      // ascending, m
  std::vector<std::int32_t> particle;         // sorted place -> particle, readable 8 past the end
  std::vector<std::int32_t> place;            // [all] particle -> sorted place, -1 if not a source
  std::vector<double> reach;                  // of the sorted particles, m
  std::vector<std::int32_t> left, right;      // how many sources each reaches on either side
  std::vector<double> from_left, from_right;  // what reaches furthest; see search_line.cpp

  // scratch of the sort
  std::vector<double> merge_x;
  std::vector<std::int32_t> merge_particle;
  std::vector<std::int64_t> run;
};

// Sorts x, and particle with it. Stable; linear for the usual input, which is one long ascending run and a few images
// at its ends.
void sort_along_line(Line& line);

}  // namespace riffle
