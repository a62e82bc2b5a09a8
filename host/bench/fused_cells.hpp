// "The usual way": one scalar loop over the cells around each particle with all physics fused into it, as most SPH
// codes have it. It is the numerator of the gain that the benchmark prints.
//
// It is written as a careful author would write it, not to lose: particles sorted by cell, whole rows of cells as one
// range, p / rho^2 and m / rho formed once per particle, no division that can be shared. What it has not: a list,
// records, vectors.
#pragma once

#include <vector>

#include "host/bench/state.hpp"

namespace riffle::bench {

class FusedCells {
 public:
  explicit FusedCells(const BenchState& state);
  void operator()(BenchRates& rates);  // one evaluation of all rates, one thread

 private:
  const BenchState& state_;
  std::vector<double> volume_;  // m / rho; computed in each evaluation
};

}  // namespace riffle::bench
