// A symmetric positive definite matrix in envelope form: of each row, what lies between its first entry and the diagonal.
// Factorised in place as L D L^T, which never fills anything outside the envelope; rows that are diagonal cost nothing.
// George & Liu (1981) chapter 4. For the narrow bands of one-dimensional neighbour lists this is the cheapest direct solver,
// and no triplets are formed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace riffle {

class Envelope {
 public:
  // `first[i]` <= i is the column in which row i begins. All entries become 0; memory is kept from call to call.
  void shape(const std::vector<std::int64_t>& first) {
    first_ = first;
    start_.resize(first.size() + 1);
    start_[0] = 0;
    for (std::size_t i = 0; i < first.size(); ++i)
      start_[i + 1] = start_[i] + static_cast<std::int64_t>(i) - first[i] + 1;
    values_.assign(static_cast<std::size_t>(start_.back()), 0.0);
  }
  [[nodiscard]] std::int64_t rows() const { return static_cast<std::int64_t>(first_.size()); }
  // Row i, column j <= i, within the envelope.
  double& at(std::int64_t i, std::int64_t j) { return row(i)[j]; }
  // Its entries by column, from its first to i.
  double* row(std::int64_t i) { return values_.data() + start_[static_cast<std::size_t>(i)] - begin(i); }

  // False when a pivot is not positive: the matrix is not positive definite, or not finite.
  bool factorise() {
    inverse_.resize(first_.size());
    for (std::int64_t i = 0; i < rows(); ++i) {
      double *l = row(i), pivot = l[i];
      for (std::int64_t j = begin(i); j < i; ++j) {
        const double* other = row(j);
        double sum = l[j];
        for (std::int64_t k = std::max(begin(i), begin(j)); k < j; ++k) sum -= l[k] * other[k];
        l[j] = sum;  // L_ij D_j until the row is done
      }
      for (std::int64_t j = begin(i); j < i; ++j) {
        const double scaled = l[j] * inverse_[static_cast<std::size_t>(j)];
        pivot -= scaled * l[j];
        l[j] = scaled;
      }
      if (!(pivot > 0)) return false;
      l[i] = pivot;
      inverse_[static_cast<std::size_t>(i)] = 1 / pivot;
    }
    return true;
  }

  void solve(double* x) {  // x: the right-hand side, then the solution
    for (std::int64_t i = 0; i < rows(); ++i) {
      const double* l = row(i);
      for (std::int64_t j = begin(i); j < i; ++j) x[i] -= l[j] * x[j];
    }
    for (std::int64_t i = 0; i < rows(); ++i) x[i] *= inverse_[static_cast<std::size_t>(i)];
    for (std::int64_t i = rows() - 1; i >= 0; --i) {
      const double* l = row(i);
      for (std::int64_t j = begin(i); j < i; ++j) x[j] -= l[j] * x[i];
    }
  }

 private:
  [[nodiscard]] std::int64_t begin(std::int64_t i) const { return first_[static_cast<std::size_t>(i)]; }

  std::vector<std::int64_t> first_, start_;
  std::vector<double> values_, inverse_;
};

}  // namespace riffle
