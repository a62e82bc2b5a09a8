// A symmetric positive definite matrix of half-bandwidth B, a constant of the compiler: of row r the B entries before the
// diagonal, and it. Factorised in place as L D L^T, row by row, together with the forward substitution: for the four or so
// diagonals of a line of particles several times faster than an envelope of unknown width.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace riffle {

template <int B>
class Band {
 public:
  static constexpr std::int64_t width = B + 1;

  // Rows -B .. n + B - 1, so that nobody needs to look where the matrix ends; memory is kept from call to call.
  void resize(std::int64_t n) {
    const auto all = static_cast<std::size_t>(n + 2 * B);
    if (inverse_.size() == all) return;
    values_.assign(all * width, 0.0);
    inverse_.assign(all, 0.0);
    x_.assign(all, 0.0);
  }
  // Entry (r, c) is row(r)[c - r + B], r - B <= c <= r.
  double* row(std::int64_t r) { return values_.data() + (r + B) * width; }
  double* right_hand_side() { return x_.data() + B; }  // by row; afterwards the solution

  void clear(std::int64_t first, std::int64_t last) {
    double* const from = row(first);
    for (std::int64_t k = 0; k < (last - first) * width; ++k) from[k] = 0;
  }

  // The rows [first, last), which nothing couples to those around them: their entries outside are 0. False when a pivot
  // is not positive: the matrix is not positive definite, or not finite.
  bool solve(std::int64_t first, std::int64_t last) {
    double *x = right_hand_side(), *inverse = inverse_.data() + B;
    for (std::int64_t r = first; r < last; ++r) {
      double *own = row(r), s[B], pivot = own[B], y = x[r];
      for (int q = 0; q < B; ++q) {  // column r - B + q
        const double* other = row(r - B + q) + B - q;
        double sum = own[q];
        for (int k = 0; k < q; ++k) sum -= s[k] * other[k];
        s[q] = sum;
      }
      for (int q = 0; q < B; ++q) {
        const double scaled = s[q] * inverse[r - B + q];
        own[q] = scaled;
        pivot -= scaled * s[q];
        y -= scaled * x[r - B + q];
      }
      if (!(pivot > 0)) return false;
      inverse[r] = 1 / pivot;
      x[r] = y;
    }
    for (std::int64_t r = last - 1; r >= first; --r) {
      double sum = x[r] * inverse[r];
      if (r + B < last) {
        for (std::int64_t m = B; m > 0; --m) sum -= row(r + m)[B - m] * x[r + m];
      } else {
        for (std::int64_t m = last - 1 - r; m > 0; --m) sum -= row(r + m)[B - m] * x[r + m];
      }
      x[r] = sum;
    }
    return true;
  }

 private:
  std::vector<double> values_, inverse_, x_;
};

}  // namespace riffle
