// The linear system of vertical acceleration in shallow water, along a line:
//
//   (V + t1/3 D^T P V D + P V B) a = V a_h - 1/3 D^T P V S - P V F,     D_ij = dh_i / dx_j
//
// with P = 1 where the terms act, else 0, and inertia B and push F of a bed (riffle/bed_motion.hpp), if there is one.
// Green & Naghdi (1976) as a discrete Lagrangian. The matrix is symmetric positive definite; D 1 = 0 keeps momentum.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "riffle/abi.h"
#include "riffle/band.hpp"
#include "riffle/envelope.hpp"

namespace riffle {

// Marks all of [first, last) within so many of its own depths of a marked particle there; x ascending.
inline void widen(char* marked, const double* x, const double* depth, double depths, std::int64_t first,
                  std::int64_t last, std::vector<char>& wide) {
  wide.assign(marked + first, marked + last);
  char* to = wide.data() - first;
  for (std::int64_t i = first; i < last; ++i) {
    if (marked[i] == 0) continue;
    const double reach = depths * depth[i];
    for (std::int64_t j = i - 1; j >= first && x[i] - x[j] <= reach && marked[j] == 0; --j) to[j] = 1;
    for (std::int64_t j = i + 1; j < last && x[j] - x[i] <= reach && marked[j] == 0; ++j) to[j] = 1;
  }
  std::copy(wide.begin(), wide.end(), marked + first);
}

class DispersionSystem {  // memory is kept from call to call
 public:
  // Rows of D: `own` on the diagonal, -entries[k] for the pairs of the list; images count as their origin. Rows far from
  // anything that is not quiet are left out: no term may act there, and their product with anything counts as 0.
  void read(const riffle_pairs& pairs, const double* own, const double* entries, std::int64_t n,
            const std::vector<char>& quiet) {
    n_ = n;
    find_stretches(quiet);
    std::int64_t widest = read_within(half_, pairs, own, entries);
    if (widest > half_) {
      half_ = widest;
      find_stretches(quiet);
      widest = read_within(half_, pairs, own, entries);
    }
    half_ = std::max<std::int64_t>(widest, 1);
    if (half_ != stored_) read_within(half_, pairs, own, entries);
  }
  [[nodiscard]] const std::vector<std::pair<std::int64_t, std::int64_t>>& stretches() const { return stretches_; }

  // out = D a
  void multiply(const double* a, double* out) const {
    std::int64_t done = 0;
    for (const auto& [first, last] : stretches_) {
      std::fill(out + done, out + first, 0.0);
      done = last;
      switch (half_) {
        case 1: multiply_within<1>(a, out, first, last); break;
        case 2: multiply_within<2>(a, out, first, last); break;
        case 3: multiply_within<3>(a, out, first, last); break;
        default:
          for (std::int64_t i = first; i < last; ++i) out[i] = row_times(i, a);
      }
    }
    std::fill(out + done, out + n_, 0.0);
  }
  [[nodiscard]] double row_times(std::int64_t i, const double* a) const {  // (D a)_i
    const std::int64_t first = std::max<std::int64_t>(-half_, -i), last = std::min(half_, n_ - 1 - i);
    const double* d = row(i);
    double sum = 0;
    for (std::int64_t k = first; k <= last; ++k) sum += d[k] * a[i + k];
    return sum;
  }

  // The accelerations, of which those that no term reaches are the hydrostatic ones; or nullptr when the matrix is not
  // positive definite.
  const double* solve(double t1, const std::vector<char>& acts, const double* volume, const double* hydrostatic,
                      const double* source, const double* inertia = nullptr, const double* push = nullptr) {
    const Problem problem{t1, &acts, volume, hydrostatic, source, inertia, push};
    switch (half_) {
      case 1: return banded<1>(problem, band1_);
      case 2: return banded<2>(problem, band2_);
      case 3: return banded<3>(problem, band3_);
      case 4: return banded<4>(problem, band4_);
      default: return enveloped(problem);
    }
  }

 private:
  // What lies within 64 rows, and within two widths of the matrix, of a row that is not quiet.
  void find_stretches(const std::vector<char>& quiet) {
    stretches_.clear();
    const std::int64_t margin = std::max<std::int64_t>(64, 4 * half_);
    for (std::int64_t i = 0; i < n_; ++i) {
      if (quiet[static_cast<std::size_t>(i)] != 0) continue;
      const std::int64_t first = std::max<std::int64_t>(0, i - margin), last = std::min(n_, i + margin + 1);
      if (!stretches_.empty() && first <= stretches_.back().second)
        stretches_.back().second = last;
      else
        stretches_.emplace_back(first, last);
    }
  }
  // Stores rows of `half` entries on either side; returns how many they should have had.
  std::int64_t read_within(std::int64_t half, const riffle_pairs& pairs, const double* own, const double* entries) {
    const std::int64_t width = 2 * half + 1;
    std::int64_t widest = 0;
    stored_ = half;
    rows_.resize(static_cast<std::size_t>(n_ * width));
    for (const auto& [first, last] : stretches_) {
      for (std::int64_t i = first; i < last; ++i) {
        double* d = rows_.data() + i * width + half;
        for (std::int64_t k = -half; k <= half; ++k) d[k] = 0;
        d[0] = own[i];
        for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i] + pairs.count[i]; ++k) {
          if (entries[k] == 0) continue;  // at the very end of the support: it would widen the band for nothing
          const std::int32_t j = pairs.neighbour[k];
          const std::int64_t away = (j < pairs.n_owned ? j : pairs.origin[j - pairs.n_owned]) - i;
          widest = std::max(widest, std::abs(away));
          if (std::abs(away) <= half) d[away] -= entries[k];
        }
      }
    }
    return widest;
  }
  template <int Half>
  void multiply_within(const double* a, double* out, std::int64_t first, std::int64_t last) const {
    for (std::int64_t i = first; i < last; ++i) {
      if (i < Half || i + Half >= n_) {
        out[i] = row_times(i, a);
        continue;
      }
      const double *d = rows_.data() + i * (2 * Half + 1), *at = a + i - Half;
      double sum = 0;
      for (int k = 0; k <= 2 * Half; ++k) sum += d[k] * at[k];
      out[i] = sum;
    }
  }

  struct Problem {
    double t1;
    const std::vector<char>* acts;
    const double *volume, *hydrostatic, *source, *inertia, *push;
    [[nodiscard]] bool active(std::int64_t i) const { return (*acts)[static_cast<std::size_t>(i)] != 0; }
  };
  [[nodiscard]] const double* row(std::int64_t i) const { return rows_.data() + i * (2 * half_ + 1) + half_; }

  // Stretches of rows that the terms reach, each by itself.
  template <int Half>
  const double* banded(const Problem& p, Band<2 * Half>& band) {
    constexpr int wide = 2 * Half;
    band.resize(n_);
    double* x = band.right_hand_side();
    std::fill_n(x - wide, wide, 0.0);
    std::copy_n(p.hydrostatic, n_, x);
    for (std::int64_t i = 0; i < n_; ++i) {
      if (!p.active(i)) continue;
      const std::int64_t first = std::max<std::int64_t>(0, i - Half);
      std::int64_t end = i;  // of the active rows that hang together
      for (std::int64_t k = i; k < n_ && k <= end + wide; ++k) end = p.active(k) ? k : end;
      const std::int64_t last = std::min(n_, end + Half + 1);
      band.clear(first - Half, std::min(last + Half, n_ + wide));
      for (std::int64_t k = first; k < last; ++k) {
        band.row(k)[wide] = p.volume[k];
        x[k] *= p.volume[k];
      }
      for (std::int64_t k = i; k <= end; ++k) {
        if (p.active(k)) add<Half>(p, k, band, x);
      }
      if (!band.solve(first, last)) return nullptr;
      i = end;
    }
    return x;
  }
  template <int Half>
  void add(const Problem& p, std::int64_t i, Band<2 * Half>& band, double* x) {
    constexpr int wide = 2 * Half;
    const double third = p.volume[i] / 3, *d = rows_.data() + i * (wide + 1);
    if (p.inertia != nullptr) {
      band.row(i)[wide] += p.volume[i] * p.inertia[i];
      x[i] -= p.volume[i] * p.push[i];
    }
    for (int a = 0; a <= wide; ++a) {
      const double share = third * d[a];
      double* to = band.row(i - Half + a) + wide - a;
      x[i - Half + a] -= share * p.source[i];
      for (int b = 0; b <= a; ++b) to[b] += p.t1 * share * d[b];
    }
  }

  const double* enveloped(const Problem& p) {  // any width: particles that crowd, images of the other end
    const std::int64_t row_of = 2 * half_ + 1;
    start_.resize(static_cast<std::size_t>(n_));
    for (std::int64_t i = 0; i < n_; ++i) start_[static_cast<std::size_t>(i)] = i;
    const auto each_entry = [&](std::int64_t i, const auto& work) {
      const double* d = rows_.data() + i * row_of + half_;
      for (std::int64_t k = std::max<std::int64_t>(-half_, -i); k <= std::min(half_, n_ - 1 - i); ++k) {
        if (d[k] != 0) work(i + k, d[k]);
      }
    };
    for (std::int64_t i = 0; i < n_ && p.t1 != 0; ++i) {
      if (!p.active(i)) continue;
      std::int64_t least = i;
      each_entry(i, [&](std::int64_t j, double) { least = std::min(least, j); });
      each_entry(i, [&](std::int64_t j, double) {
        auto& from = start_[static_cast<std::size_t>(j)];
        from = std::min(from, least);
      });
    }
    matrix_.shape(start_);
    solution_.resize(static_cast<std::size_t>(n_));
    double* rhs = solution_.data();
    for (std::int64_t i = 0; i < n_; ++i) {
      matrix_.at(i, i) = p.volume[i];
      rhs[i] = p.volume[i] * p.hydrostatic[i];
    }
    for (std::int64_t i = 0; i < n_; ++i) {
      if (!p.active(i)) continue;
      const double third = p.volume[i] / 3;
      if (p.inertia != nullptr) {
        matrix_.at(i, i) += p.volume[i] * p.inertia[i];
        rhs[i] -= p.volume[i] * p.push[i];
      }
      each_entry(i, [&](std::int64_t j, double d) {
        rhs[j] -= third * d * p.source[i];
        if (p.t1 == 0) return;
        double* to = matrix_.row(j);
        each_entry(i, [&](std::int64_t k, double e) {
          if (k <= j) to[k] += p.t1 * third * d * e;
        });
      });
    }
    if (!matrix_.factorise()) return nullptr;
    matrix_.solve(rhs);
    return rhs;
  }

  std::int64_t n_ = 0, half_ = 2;  // the entries of a row lie so far from the diagonal at most
  std::int64_t stored_ = 0;
  std::vector<std::pair<std::int64_t, std::int64_t>> stretches_;  // of rows that were read
  std::vector<double> rows_, solution_;
  std::vector<std::int64_t> start_;
  Envelope matrix_;
  Band<2> band1_;
  Band<4> band2_;
  Band<6> band3_;
  Band<8> band4_;
};

}  // namespace riffle
