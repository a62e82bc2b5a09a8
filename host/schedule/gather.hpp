// The hot loop of the host: packs records, gathers neighbours' records into the arrays of a block, sums contributions.
//
// Four records are read at a time and turned by 4x4 transposes of portable vector extensions, because gather
// instructions are slower than plain loads and shuffles on current machines. Everything a block needs stays in the
// first-level cache; no closure sees an index.
#pragma once

#include <cstdint>
#include <cstring>

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

// A vector of four doubles; GCC and Clang turn it into whatever the machine has.
using v4 = double __attribute__((vector_size(32)));

inline v4 load4(const double* p) {
  v4 v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
inline void store4(double* p, v4 v) {
  std::memcpy(p, &v, sizeof v);
}
inline v4 all4(double x) {
  return v4{x, x, x, x};
}

// Sum over the true pairs of a segment, in one fixed order: four lanes, then across.
inline double sum_segment(const double* values, std::int64_t count) {
  using m4 = std::int64_t __attribute__((vector_size(32)));
  static constexpr m4 tail[4] = {m4{0, 0, 0, 0}, m4{-1, 0, 0, 0}, m4{-1, -1, 0, 0}, m4{-1, -1, -1, 0}};
  v4 sum = all4(0.0);
  const std::int64_t whole = count & ~std::int64_t{3};
  for (std::int64_t k = 0; k < whole; k += 4) sum += load4(values + k);
  if (count != whole) sum += reinterpret_cast<v4>(reinterpret_cast<m4>(load4(values + whole)) & tail[count & 3]);
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

// Columns become records: record i holds columns[0][i], columns[1][i], ..., then zeros, for first <= i < last.
void pack_records(const double* const* columns, int used, int quads, std::int64_t first, std::int64_t last,
                  double* records);

}  // namespace riffle
