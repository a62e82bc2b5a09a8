// The loops over the pairs (i + k, j + k) of a stretch of a line: geometry, who is within reach, sums.
#pragma once

#include <cstdint>

namespace riffle {

struct LinePairs {
  std::int64_t n = 0;  // a multiple of 8
  const double *xi = nullptr, *xj = nullptr;
  const double *ui = nullptr, *uj = nullptr;  // nullptr: approach is not wanted
  const double *li = nullptr, *lj = nullptr;  // reach of both
  // How far those at j and beyond reach back: the least of x - reach to the right, of -(x + reach) to the left.
  const double* edge = nullptr;
  double side = 1;  // -1: j lies to the left
  // Written; nullptr: not wanted (each array costs a store per pair).
  double *separation = nullptr, *distance = nullptr, *squared = nullptr, *approach = nullptr;
  double* counts = nullptr;  // written when some pairs are within reach and some not: 1 or 0
};

struct LineCount {
  double within = 0;  // pairs within reach
  bool more = false;  // whether one further along the line can be
};

// Within reach: distance < reach of i.
LineCount pairs_by_own_reach(const LinePairs& pairs);
// distance < reach of j, or, when `either`, of one of the two.
LineCount pairs_by_their_reach(const LinePairs& pairs, bool either);

// sum[k] += f[k] where the pair counts.
void add_pairs(std::int64_t n, bool all, const double* counts, const double* f, double* sum);

}  // namespace riffle
