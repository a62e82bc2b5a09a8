// The best monolith we can fuse by hand over the same padded list: the denominator of the price that the benchmark
// prints. No plugin is possible in it. Against a slower one every design of plugins would look good, so whoever finds a
// faster way should put it here.
//
// Each evaluation packs one record of 64 bytes per particle, so that a neighbour costs one cache line; records are read
// four neighbours at a time and turned into vectors by 4x4 register transposes; everything then happens in registers.
// Vector extensions of GCC and Clang, with one built-in each for root, largest and smallest. Double precision
// throughout: approximate roots and reciprocals are not used, as they would not be in a plugin.
//
// Measured (Zen 3): joining halves of records instead of transposing whole ones takes as long; without the root and the
// division it would be a tenth faster, so these are nearly hidden. What counts is the number of instructions: hence
// constants folded into the records, all differences taken as j minus i, and one division for two quotients.
#pragma once

#include <memory>

#include "host/bench/state.hpp"

namespace riffle::bench {

class FusedBest {
 public:
  explicit FusedBest(const BenchState& state);
  void operator()(BenchRates& rates);  // one evaluation of all rates, packing included, one thread

 private:
  struct Free {
    void operator()(double* p) const;
  };
  const BenchState& state_;
  std::unique_ptr<double[], Free> record_;  // [particles + dummy][8], 64-byte aligned
};

}  // namespace riffle::bench
