// The hot loop of the host: packs records, gathers neighbours' records into the arrays of a block, sums contributions.
//
// Four records are read at a time and turned by 4x4 transposes of portable vector extensions, because gather
// instructions are slower than plain loads and shuffles on current machines. Everything a block needs stays in the
// first-level cache; no closure sees an index.
#pragma once

#include <cstdint>

namespace riffle {

struct GatherArguments {
  int dim = 1;
  bool approach = false;
  int quads = 1;                            // record size / 4
  const double* records = nullptr;          // [all + 1] records
  const std::int32_t* neighbour = nullptr;  // the list's entries
  const std::int64_t* begin = nullptr;      // offsets per particle
  std::int64_t first = 0, last = 0;         // targets of the block
  double* arena = nullptr;                  // arrays of `stride` doubles
};

// Lengths of a block's arrays that are compiled in; the constant keeps addresses in the instructions.
inline constexpr int strides[] = {136, 264, 1064};

// Fills separation, distance, distance squared, approach and the slots for all pairs of the block.
// Returns the number of pairs, padding included.
std::int64_t gather(const GatherArguments& arguments, int stride);

// sum over the true pairs of each segment, in one fixed order: four lanes, then across.
double sum_segment(const double* values, std::int64_t count);

}  // namespace riffle
