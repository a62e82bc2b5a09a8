// The linear system of vertical acceleration in shallow water, along a line:
//
//   (V + t1/3 D^T P V D) a = V a_h - 1/3 D^T P V S,     D_ij = dh_i / dx_j,  P = 1 where the terms act, else 0
//
// Green & Naghdi (1976) as a discrete Lagrangian. The matrix is symmetric positive definite; D 1 = 0 keeps momentum.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "riffle/abi.h"
#include "riffle/envelope.hpp"

namespace riffle {

// Marks all within so many of its own depths of a marked particle; x ascending.
inline std::vector<char> widened(const std::vector<char>& marked, const double* x, const double* depth, double depths) {
  std::vector<char> wide = marked;
  const auto n = static_cast<std::int64_t>(marked.size());
  const auto is_marked = [&](std::int64_t j) { return marked[static_cast<std::size_t>(j)] != 0; };
  for (std::int64_t i = 0; i < n; ++i) {
    if (!is_marked(i)) continue;
    const double reach = depths * depth[i];
    for (std::int64_t j = i - 1; j >= 0 && x[i] - x[j] <= reach && !is_marked(j); --j)
      wide[static_cast<std::size_t>(j)] = 1;
    for (std::int64_t j = i + 1; j < n && x[j] - x[i] <= reach && !is_marked(j); ++j)
      wide[static_cast<std::size_t>(j)] = 1;
  }
  return wide;
}

class DispersionSystem {  // memory is kept from call to call
 public:
  // Rows of D: `own` on the diagonal, -entries[k] for the pairs of the list; images count as their origin. Neighbours at
  // the very end of the support, whose entry is 0, are left out: they would widen the band for nothing.
  void read(const riffle_pairs& pairs, const double* own, const double* entries, std::int64_t n) {
    begin_.resize(static_cast<std::size_t>(n) + 1);
    column_.clear();
    value_.clear();
    for (std::int64_t i = 0; i < n; ++i) {
      begin_[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(column_.size());
      column_.push_back(i);
      value_.push_back(own[i]);
      for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i] + pairs.count[i]; ++k) {
        if (entries[k] == 0) continue;
        const std::int32_t j = pairs.neighbour[k];
        column_.push_back(j < pairs.n_owned ? j : pairs.origin[j - pairs.n_owned]);
        value_.push_back(-entries[k]);
      }
    }
    begin_[static_cast<std::size_t>(n)] = static_cast<std::int64_t>(column_.size());
  }

  [[nodiscard]] double row_times(std::int64_t i, const double* a) const {  // (D a)_i
    double sum = 0;
    for (std::int64_t k = first_of(i); k < first_of(i + 1); ++k) sum += value_at(k) * a[column_at(k)];
    return sum;
  }

  // The acceleration, or nullptr when the matrix is not positive definite.
  const double* solve(double t1, const std::vector<char>& acts, const double* volume, const double* hydrostatic,
                      const double* source) {
    const auto n = static_cast<std::int64_t>(acts.size());
    shape(acts, t1 != 0);
    solution_.resize(acts.size());
    double* rhs = solution_.data();
    for (std::int64_t i = 0; i < n; ++i) {
      matrix_.at(i, i) = volume[i];
      rhs[i] = volume[i] * hydrostatic[i];
    }
    for (std::int64_t i = 0; i < n; ++i) {
      if (acts[static_cast<std::size_t>(i)] == 0) continue;
      const double third = volume[i] / 3;
      const std::int64_t begin = first_of(i), end = first_of(i + 1);
      for (std::int64_t p = begin; p < end; ++p) {
        const std::int64_t j = column_at(p);
        const double share = third * value_at(p);
        rhs[j] -= share * source[i];
        if (t1 == 0) continue;
        double* row = matrix_.row(j);
        for (std::int64_t q = begin; q < end; ++q) {
          if (column_at(q) <= j) row[column_at(q)] += t1 * share * value_at(q);
        }
      }
    }
    if (!matrix_.factorise()) return nullptr;
    matrix_.solve(rhs);
    return rhs;
  }

 private:
  void shape(const std::vector<char>& acts, bool coupled) {
    const auto n = static_cast<std::int64_t>(acts.size());
    start_.resize(acts.size());
    for (std::int64_t i = 0; i < n; ++i) start_[static_cast<std::size_t>(i)] = i;
    for (std::int64_t i = 0; i < n && coupled; ++i) {
      if (acts[static_cast<std::size_t>(i)] == 0) continue;
      std::int64_t least = i;
      for (std::int64_t k = first_of(i); k < first_of(i + 1); ++k) least = std::min(least, column_at(k));
      for (std::int64_t k = first_of(i); k < first_of(i + 1); ++k) {
        auto& from = start_[static_cast<std::size_t>(column_at(k))];
        from = std::min(from, least);
      }
    }
    matrix_.shape(start_);
  }
  [[nodiscard]] std::int64_t first_of(std::int64_t i) const { return begin_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::int64_t column_at(std::int64_t k) const { return column_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] double value_at(std::int64_t k) const { return value_[static_cast<std::size_t>(k)]; }

  std::vector<std::int64_t> begin_, column_, start_;
  std::vector<double> value_, solution_;
  Envelope matrix_;
};

}  // namespace riffle
