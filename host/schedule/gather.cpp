#include "host/schedule/gather.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace riffle {

namespace {

using v4 = double __attribute__((vector_size(32)));
using m4 = std::int64_t __attribute__((vector_size(32)));

inline v4 load(const double* p) {
  v4 v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
inline void store(double* p, v4 v) {
  std::memcpy(p, &v, sizeof v);
}
inline v4 all(double x) {
  return v4{x, x, x, x};
}

// Rows a, b, c, d become columns.
inline void transpose(v4& a, v4& b, v4& c, v4& d) {
  const v4 ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const v4 cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

template <int Dim, bool Approach, int Quads, int Stride>
std::int64_t gather_block(const GatherArguments& g) {
  constexpr int record = 4 * Quads;
  constexpr int head = Approach ? 2 * Dim : Dim;
  double* w = g.arena;
  for (std::int64_t i = g.first; i < g.last; ++i) {
    const double* own = g.records + i * record;
    v4 xi[Dim], ui[Dim];
    for (int c = 0; c < Dim; ++c) {
      xi[c] = all(own[c]);
      ui[c] = Approach ? all(own[Dim + c]) : all(0.0);
    }
    const std::int32_t* end = g.neighbour + g.begin[i + 1];
    for (const std::int32_t* j = g.neighbour + g.begin[i]; j != end; j += 4, w += 4) {
      const double* a = g.records + static_cast<std::int64_t>(j[0]) * record;
      const double* b = g.records + static_cast<std::int64_t>(j[1]) * record;
      const double* c = g.records + static_cast<std::int64_t>(j[2]) * record;
      const double* d = g.records + static_cast<std::int64_t>(j[3]) * record;
      v4 s[record];
#pragma GCC unroll 8
      for (int q = 0; q < Quads; ++q) {
        s[4 * q] = load(a + 4 * q);
        s[4 * q + 1] = load(b + 4 * q);
        s[4 * q + 2] = load(c + 4 * q);
        s[4 * q + 3] = load(d + 4 * q);
        transpose(s[4 * q], s[4 * q + 1], s[4 * q + 2], s[4 * q + 3]);
      }
      v4 r2 = all(0.0), vr = all(0.0);
#pragma GCC unroll 4
      for (int k = 0; k < Dim; ++k) {
        const v4 dx = xi[k] - s[k];
        store(w + k * Stride, dx);
        r2 += dx * dx;
        if constexpr (Approach) vr += (ui[k] - s[Dim + k]) * dx;
      }
      store(w + (Dim + 1) * Stride, r2);
      if constexpr (Approach) store(w + (Dim + 2) * Stride, vr);
#pragma GCC unroll 32
      for (int k = head; k < record; ++k) store(w + (Dim + 3 + k - head) * Stride, s[k]);
    }
  }
  const std::int64_t n = w - g.arena;
  const double* r2 = g.arena + (Dim + 1) * Stride;
  double* r = g.arena + Dim * Stride;
#pragma omp simd
  for (std::int64_t k = 0; k < n; ++k) r[k] = std::sqrt(r2[k]);
  return n;
}

template <int Dim, bool Approach, int Stride>
std::int64_t by_quads(const GatherArguments& g) {
  switch (g.quads) {
    case 1: return gather_block < Dim, Approach, Approach && Dim == 3 ? 2 : 1, Stride > (g);
    case 2: return gather_block<Dim, Approach, 2, Stride>(g);
    case 3: return gather_block<Dim, Approach, 3, Stride>(g);
    case 4: return gather_block<Dim, Approach, 4, Stride>(g);
    case 5: return gather_block<Dim, Approach, 5, Stride>(g);
    case 6: return gather_block<Dim, Approach, 6, Stride>(g);
    default: throw std::logic_error("a group of pair passes reads more than 24 numbers of each neighbour");
  }
}

template <int Stride>
std::int64_t by_dim(const GatherArguments& g) {
  switch (2 * g.dim + (g.approach ? 1 : 0)) {
    case 2: return by_quads<1, false, Stride>(g);
    case 3: return by_quads<1, true, Stride>(g);
    case 4: return by_quads<2, false, Stride>(g);
    case 5: return by_quads<2, true, Stride>(g);
    case 6: return by_quads<3, false, Stride>(g);
    default: return by_quads<3, true, Stride>(g);
  }
}

}  // namespace

std::int64_t gather(const GatherArguments& arguments, int stride) {
  switch (stride) {
    case strides[0]: return by_dim<strides[0]>(arguments);
    case strides[1]: return by_dim<strides[1]>(arguments);
    default: return by_dim<strides[2]>(arguments);
  }
}

double sum_segment(const double* values, std::int64_t count) {
  static constexpr std::array<m4, 4> tail{m4{0, 0, 0, 0}, m4{-1, 0, 0, 0}, m4{-1, -1, 0, 0}, m4{-1, -1, -1, 0}};
  v4 sum = all(0.0);
  const std::int64_t whole = count & ~std::int64_t{3};
  for (std::int64_t k = 0; k < whole; k += 4) sum += load(values + k);
  const auto rest = static_cast<std::size_t>(count & 3);
  if (rest != 0) sum += reinterpret_cast<v4>(reinterpret_cast<m4>(load(values + whole)) & tail[rest]);
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace riffle
