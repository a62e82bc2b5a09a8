#include "host/schedule/gather.hpp"

#include <stdexcept>

namespace riffle {

namespace {

__attribute__((always_inline)) inline v4 root4(v4 a) {
  return v4{__builtin_sqrt(a[0]), __builtin_sqrt(a[1]), __builtin_sqrt(a[2]), __builtin_sqrt(a[3])};
}

// Separation, distance, its square and approach of four pairs. The root is taken here, and not in a loop of its own,
// because it overlaps with the loads of the next four.
// Always inlined: records of three quads and more lose a sixth of their speed to calls.
template <int Dim, bool Approach, int Stride>
__attribute__((always_inline)) inline void geometry(const v4* xi, const v4* ui, const v4* s, double* w) {
  v4 dx = xi[0] - s[0], r2 = dx * dx, vr = all4(0.0);
  store4(w, dx);
  if constexpr (Approach) vr = (ui[0] - s[Dim]) * dx;
#pragma GCC unroll 4
  for (int k = 1; k < Dim; ++k) {
    dx = xi[k] - s[k];
    store4(w + k * Stride, dx);
    r2 += dx * dx;
    if constexpr (Approach) vr += (ui[k] - s[Dim + k]) * dx;
  }
  store4(w + Dim * Stride, root4(r2));
  store4(w + (Dim + 1) * Stride, r2);
  if constexpr (Approach) store4(w + (Dim + 2) * Stride, vr);
}

template <int Dim, bool Approach, int Quads, int Own, int Stride>
std::int64_t gather_block(const GatherArguments& g) {
  constexpr int record = 4 * Quads;
  constexpr int head = Approach ? 2 * Dim : Dim;
  constexpr int first_own = Dim + 3 + record - head;
  const double* records = g.records;
  const std::int32_t* neighbour = g.neighbour;
  const std::int64_t* begin = g.begin;
  const std::int64_t last = g.last;
  const int own_count = Own >= 0 ? Own : g.own_count;
  double* w = g.arena;
  for (std::int64_t i = g.first; i < last; ++i) {
    const double* mine = records + i * record;
    v4 xi[Dim], ui[Dim], own[gathered_own];
    for (int c = 0; c < Dim; ++c) {
      xi[c] = all4(mine[c]);
      ui[c] = Approach ? all4(mine[Dim + c]) : all4(0.0);
    }
    for (int o = 0; o < own_count; ++o) own[o] = all4(g.own[o][i]);
    const std::int32_t* end = neighbour + begin[i + 1];
    for (const std::int32_t* j = neighbour + begin[i]; j != end; j += 4, w += 4) {
      const double* a = records + static_cast<std::int64_t>(j[0]) * record;
      const double* b = records + static_cast<std::int64_t>(j[1]) * record;
      const double* c = records + static_cast<std::int64_t>(j[2]) * record;
      const double* d = records + static_cast<std::int64_t>(j[3]) * record;
      // Geometry as soon as positions and velocities are there: with all of a record in registers, some would spill.
      v4 s[record];
#pragma GCC unroll 8
      for (int q = 0; q < Quads; ++q) {
        s[4 * q] = load4(a + 4 * q);
        s[4 * q + 1] = load4(b + 4 * q);
        s[4 * q + 2] = load4(c + 4 * q);
        s[4 * q + 3] = load4(d + 4 * q);
        transpose4(s[4 * q], s[4 * q + 1], s[4 * q + 2], s[4 * q + 3]);
        if (4 * q < head && 4 * q + 4 >= head) geometry<Dim, Approach, Stride>(xi, ui, s, w);
#pragma GCC unroll 4
        for (int k = 4 * q > head ? 4 * q : head; k < 4 * q + 4; ++k) store4(w + (Dim + 3 + k - head) * Stride, s[k]);
      }
#pragma GCC unroll 4
      for (int o = 0; o < own_count; ++o) store4(w + (first_own + o) * Stride, own[o]);
    }
  }
  return w - g.arena;
}

template <int Dim, bool Approach, int Quads, int Stride>
GatherFunction by_own(int own) {
  if constexpr (Quads > 3 || Stride > 500)
    return &gather_block<Dim, Approach, Quads, -1, Stride>;
  else {
    switch (own) {
      case 0: return &gather_block<Dim, Approach, Quads, 0, Stride>;
      case 1: return &gather_block<Dim, Approach, Quads, 1, Stride>;
      case 2: return &gather_block<Dim, Approach, Quads, 2, Stride>;
      default: return &gather_block<Dim, Approach, Quads, 3, Stride>;
    }
  }
}

template <int Dim, bool Approach, int Stride>
GatherFunction by_quads(int quads, int own) {
  constexpr int least = Approach && Dim == 3 ? 2 : 1;
  switch (quads) {
    case 1: return by_own<Dim, Approach, least, Stride>(own);
    case 2: return by_own<Dim, Approach, 2, Stride>(own);
    case 3: return by_own<Dim, Approach, 3, Stride>(own);
    case 4: return by_own<Dim, Approach, 4, Stride>(own);
    case 5: return by_own<Dim, Approach, 5, Stride>(own);
    case 6: return by_own<Dim, Approach, 6, Stride>(own);
    default: throw std::logic_error("a group of pair passes reads more than 24 numbers of each neighbour");
  }
}

template <int Stride>
GatherFunction by_dim(int dim, bool approach, int quads, int own) {
  switch (2 * dim + (approach ? 1 : 0)) {
    case 2: return by_quads<1, false, Stride>(quads, own);
    case 3: return by_quads<1, true, Stride>(quads, own);
    case 4: return by_quads<2, false, Stride>(quads, own);
    case 5: return by_quads<2, true, Stride>(quads, own);
    case 6: return by_quads<3, false, Stride>(quads, own);
    default: return by_quads<3, true, Stride>(quads, own);
  }
}

}  // namespace

GatherFunction choose_gather(int dim, bool approach, int quads, int own_count, int stride) {
  switch (stride) {
    case strides[0]: return by_dim<strides[0]>(dim, approach, quads, own_count);
    case strides[1]: return by_dim<strides[1]>(dim, approach, quads, own_count);
    default: return by_dim<strides[2]>(dim, approach, quads, own_count);
  }
}

void pack_records(const double* const* columns, int used, int quads, std::int64_t first, std::int64_t last,
                  double* records) {
  const int record = 4 * quads;
  const std::int64_t whole = first + ((last - first) & ~std::int64_t{3});
  const auto column = [&](int k, std::int64_t i) { return k < used ? load4(columns[k] + i) : all4(0.0); };
  for (std::int64_t i = first; i < whole; i += 4) {  // all of a record at once: it fills cache lines
    for (int q = 0; q < quads; ++q) {
      v4 a = column(4 * q, i), b = column(4 * q + 1, i), c = column(4 * q + 2, i), d = column(4 * q + 3, i);
      transpose4(a, b, c, d);
      double* to = records + i * record + 4 * q;
      store4(to, a);
      store4(to + record, b);
      store4(to + 2 * record, c);
      store4(to + 3 * record, d);
    }
  }
  for (std::int64_t i = whole; i < last; ++i) {
    for (int k = 0; k < record; ++k) records[i * record + k] = k < used ? columns[k][i] : 0.0;
  }
}

}  // namespace riffle
