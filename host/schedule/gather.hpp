// The hot loop of the host: packs records, gathers neighbours' records into the arrays of a block, sums contributions.
//
// Four records are read at a time and turned by 4x4 transposes of portable vector extensions, because gather
// instructions are slower than plain loads and shuffles on current machines. Everything a block needs stays in the
// first-level cache; no closure sees an index.
#pragma once

#include <cstdint>
#include <cstring>

namespace riffle {

// Own values that the gather repeats for each pair of a particle; further ones are filled in afterwards.
inline constexpr int gathered_own = 3;

struct GatherArguments {
  const double* records = nullptr;          // [all + 1] records of 4 * quads doubles
  const std::int32_t* neighbour = nullptr;  // the list's entries
  const std::int64_t* begin = nullptr;      // offsets per particle
  const double* own[gathered_own] = {};     // [owned]
  int own_count = 0;
  std::int64_t first = 0, last = 0;  // targets of the block
  double* arena = nullptr;  // arrays of `stride` doubles: separation, distance, its square, approach, slots, own
};

// Lengths of a block's arrays that are compiled in; the constant keeps addresses in the instructions.
inline constexpr int strides[] = {136, 264, 1064};

// Fills the arrays for all pairs of the block. Returns the number of pairs, padding included.
using GatherFunction = std::int64_t (*)(const GatherArguments&);

// `approach`: records hold velocity behind position, and its projection is wanted. Throws std::logic_error when a
// record would be longer than 24 doubles.
GatherFunction choose_gather(int dim, bool approach, int quads, int own_count, int stride);

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

// Rows a, b, c, d become columns.
inline void transpose4(v4& a, v4& b, v4& c, v4& d) {
  const v4 ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const v4 cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

// The first `count` lanes (0 to 4), zeros in the others, whatever is there.
inline v4 first_lanes(v4 v, std::int64_t count) {
  using m4 = std::int64_t __attribute__((vector_size(32)));
  static constexpr m4 mask[5] = {m4{0, 0, 0, 0}, m4{-1, 0, 0, 0}, m4{-1, -1, 0, 0}, m4{-1, -1, -1, 0},
                                 m4{-1, -1, -1, -1}};
  return reinterpret_cast<v4>(reinterpret_cast<m4>(v) & mask[count]);
}

// Columns become records: record i holds columns[0][i], columns[1][i], ..., then zeros, for first <= i < last.
void pack_records(const double* const* columns, int used, int quads, std::int64_t first, std::int64_t last,
                  double* records);

}  // namespace riffle
