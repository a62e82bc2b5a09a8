// Matrices in envelope form: solved to round-off, diagonal rows untouched, indefinite ones noticed.
#include "riffle/envelope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace riffle::test {
namespace envelope {

TEST(Envelope, SolvesABandWithLongRowsToRoundOff) {
  constexpr std::int64_t n = 60;
  std::vector<std::int64_t> first(n);
  for (std::int64_t i = 0; i < n; ++i)
    first[static_cast<std::size_t>(i)] = i == n - 1 ? 0 : i % 7 == 0 ? i : std::max<std::int64_t>(0, i - 3);
  Envelope matrix;
  matrix.shape(first);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> dense(n * n, 0.0), x(n), b(n, 0.0);
  for (std::int64_t i = 0; i < n; ++i) {
    x[static_cast<std::size_t>(i)] = uniform(random);
    for (std::int64_t j = first[static_cast<std::size_t>(i)]; j <= i; ++j) {
      const double value = j == i ? 70 : uniform(random);  // dominated by the diagonal: positive definite
      matrix.at(i, j) = value;
      dense[static_cast<std::size_t>(i * n + j)] = dense[static_cast<std::size_t>(j * n + i)] = value;
    }
  }
  for (std::int64_t i = 0; i < n; ++i) {
    for (std::int64_t j = 0; j < n; ++j)
      b[static_cast<std::size_t>(i)] += dense[static_cast<std::size_t>(i * n + j)] * x[static_cast<std::size_t>(j)];
  }
  ASSERT_TRUE(matrix.factorise());
  matrix.solve(b.data());
  for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(b[i], x[i], 1e-14);
}

TEST(Envelope, SaysWhenAMatrixIsNotPositiveDefinite) {
  Envelope matrix;
  matrix.shape({0, 0});
  matrix.at(0, 0) = matrix.at(1, 1) = 1;
  matrix.at(1, 0) = 2;
  EXPECT_FALSE(matrix.factorise());
  matrix.shape({0, 1});
  matrix.at(0, 0) = std::nan("");
  matrix.at(1, 1) = 1;
  EXPECT_FALSE(matrix.factorise());
}

}  // namespace envelope
}  // namespace riffle::test
