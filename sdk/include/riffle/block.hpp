// What `run` works on, and the loops over it.
#pragma once

#include <cstdint>

#include "riffle/abi.h"

namespace riffle {

// Arrays of one block. in(k)[p] is the value of reads[k] for pair (or particle) p; c selects a component of a vector.
class Block {
 public:
  explicit Block(const riffle_block& block) : block_(block) {}
  [[nodiscard]] std::int64_t size() const { return block_.n; }
  [[nodiscard]] int dim() const { return block_.dim; }
  [[nodiscard]] double time() const { return block_.time; }
  [[nodiscard]] double dt() const { return block_.dt; }
  [[nodiscard]] std::int64_t first() const { return block_.first; }
  [[nodiscard]] bool has(int k) const { return block_.in[k] != nullptr; }  // an optional read that somebody provides
  [[nodiscard]] const double* in(int k, int c = 0) const { return block_.in[k][c]; }
  [[nodiscard]] double* out(int k, int c = 0) const { return block_.out[k][c]; }

 private:
  const riffle_block& block_;
};

}  // namespace riffle

// The loop over pairs or particles. The pragma is what makes it vectorise: without it compilers give up on the many
// alias checks, silently, and the closure is four times slower. Keep the body free of calls and of branches around
// whole formulas: select values instead (double a = b < 0 ? b : 0;).
#define RIFFLE_EACH(k, block) _Pragma("omp simd") for (std::int64_t k = 0; k < (block).size(); ++k)

// The same loop for the least of something, as a vote looks for it:
//   double least = riffle::infinity;
//   RIFFLE_EACH_LEAST(k, block, least) { const double dt = ...; least = dt < least ? dt : least; }
// Clang cannot vectorise that without -ffast-math, and warns when it is told to.
#if defined(__clang__)
#define RIFFLE_EACH_LEAST(k, block, least) for (std::int64_t k = 0; k < (block).size(); ++k)
#else
#define RIFFLE_DETAIL_PRAGMA(text) _Pragma(#text)
#define RIFFLE_EACH_LEAST(k, block, least)              \
  RIFFLE_DETAIL_PRAGMA(omp simd reduction(min : least)) \
  for (std::int64_t k = 0; k < (block).size(); ++k)
#endif
