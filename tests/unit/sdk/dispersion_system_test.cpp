// The system of vertical acceleration, whatever its width: solved to round-off, as an elimination of the full matrix does.
#include "riffle/dispersion_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace riffle::test {
namespace dispersion_system {

struct
    Rows {  // n particles that see `half` others on either side; those beyond the ends are images of their mirror image
  explicit Rows(std::int64_t n, std::int64_t half) : n_(n), own(static_cast<std::size_t>(n)) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform(0.2, 1);
    const auto image = [&](std::int64_t of) {
      origin.push_back(static_cast<std::int32_t>(of));
      return static_cast<std::int32_t>(n + static_cast<std::int64_t>(origin.size()) - 1);
    };
    begin.push_back(0);
    for (std::int64_t i = 0; i < n; ++i) {
      for (std::int64_t j = i - half; j <= i + half; ++j) {
        if (j == i) continue;
        const double value = (j < i ? 1 : -1) * uniform(random);
        neighbour.push_back(j < 0 ? image(-1 - j) : j < n ? static_cast<std::int32_t>(j) : image(2 * n - 1 - j));
        entry.push_back(value);
        own[static_cast<std::size_t>(i)] += value;
      }
      begin.push_back(static_cast<std::int64_t>(entry.size()));
      count.push_back(begin.back() - begin[begin.size() - 2]);
    }
    pairs = {sizeof(riffle_pairs),
             0,
             n,
             n + static_cast<std::int64_t>(origin.size()),
             begin.data(),
             count.data(),
             neighbour.data(),
             origin.data()};
  }
  [[nodiscard]] std::vector<double> dense() const {
    std::vector<double> d(static_cast<std::size_t>(n_ * n_), 0.0);
    for (std::int64_t i = 0; i < n_; ++i) {
      d[static_cast<std::size_t>(i * n_ + i)] += own[static_cast<std::size_t>(i)];
      for (std::int64_t k = begin[static_cast<std::size_t>(i)]; k < begin[static_cast<std::size_t>(i) + 1]; ++k) {
        std::int64_t j = neighbour[static_cast<std::size_t>(k)];
        if (j >= n_) j = origin[static_cast<std::size_t>(j - n_)];
        d[static_cast<std::size_t>(i * n_ + j)] -= entry[static_cast<std::size_t>(k)];
      }
    }
    return d;
  }
  std::int64_t n_;
  std::vector<std::int64_t> begin, count;
  std::vector<std::int32_t> neighbour, origin;
  std::vector<double> own, entry;
  riffle_pairs pairs{};
};

class Width : public testing::TestWithParam<std::int64_t> {};
INSTANTIATE_TEST_SUITE_P(Halves, Width, testing::Values(1, 2, 3, 4, 6));

TEST_P(Width, DoesNotMatterToTheSolution) {
  constexpr std::int64_t n = 50;
  const Rows rows(n, GetParam());
  const std::vector<double> d = rows.dense();
  std::vector<double> volume(n), given(n), source(n);
  for (std::size_t i = 0; i < n; ++i) {
    volume[i] = 1 + 0.01 * static_cast<double>(i);
    given[i] = std::sin(static_cast<double>(i));
    source[i] = std::cos(3 * static_cast<double>(i));
  }
  std::vector<char> acts(n, 1);
  for (std::size_t i = 10; i < 13; ++i) acts[i] = 0;  // too few to part what they lie between
  for (std::size_t i = 25; i < 45; ++i) acts[i] = 0;
  DispersionSystem system;
  for (const double t1 : {1.0, 0.0, 1.0}) {  // and once more: what was there before does not matter
    system.read(rows.pairs, rows.own.data(), rows.entry.data(), n, std::vector<char>(n, 0));
    const double* a = system.solve(t1, acts, volume.data(), given.data(), source.data());
    ASSERT_NE(a, nullptr);
    std::vector<double> inner(n, 0.0), product(n);  // P V (t1 D a + S) / 3
    for (std::size_t i = 0; i < n; ++i) {
      double rise = source[i];
      for (std::size_t j = 0; j < n; ++j) rise += t1 * d[i * n + j] * a[j];
      inner[i] = acts[i] != 0 ? volume[i] * rise / 3 : 0;
    }
    for (std::size_t j = 0; j < n; ++j) {
      double sum = volume[j] * (a[j] - given[j]);
      for (std::size_t i = 0; i < n; ++i) sum += d[i * n + j] * inner[i];
      EXPECT_NEAR(sum, 0, 1e-12) << j;  // of sums of some 40 terms up to 10
    }
    EXPECT_EQ(a[35], given[35]) << "no term reaches it";
    system.multiply(a, product.data());
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j) sum += d[i * n + j] * a[j];
      EXPECT_NEAR(product[i], sum, 1e-13);
    }
  }
}

TEST_P(Width, DoesNotMatterToWaterOverABed) {  // which is heavier, and is pushed, where the terms act
  constexpr std::int64_t n = 30;
  const Rows rows(n, GetParam());
  const std::vector<double> d = rows.dense(), volume(n, 1.5), given(n, 0.7), source(n, -0.4);
  std::vector<double> inertia(n), push(n);
  for (std::size_t i = 0; i < n; ++i) {
    inertia[i] = 0.1 + 0.1 * std::sin(static_cast<double>(i));
    push[i] = std::cos(static_cast<double>(i));
  }
  std::vector<char> acts(n, 1);
  for (std::size_t i = 0; i < 12; ++i) acts[i] = 0;
  DispersionSystem system;
  system.read(rows.pairs, rows.own.data(), rows.entry.data(), n, std::vector<char>(n, 0));
  const double* a = system.solve(1, acts, volume.data(), given.data(), source.data(), inertia.data(), push.data());
  ASSERT_NE(a, nullptr);
  for (std::size_t j = 0; j < n; ++j) {
    double sum = volume[j] * (a[j] - given[j]);
    if (acts[j] != 0) sum += volume[j] * (inertia[j] * a[j] + push[j]);
    for (std::size_t i = 0; i < n; ++i) {
      double rise = source[i];
      for (std::size_t k = 0; k < n; ++k) rise += d[i * n + k] * a[k];
      sum += acts[i] != 0 ? d[i * n + j] * volume[i] * rise / 3 : 0;
    }
    EXPECT_NEAR(sum, 0, 1e-12) << j;
  }
}

TEST(DispersionSystem, LeavesOutWhatIsFarFromAnythingThatIsNotQuiet) {
  constexpr std::int64_t n = 400;
  const Rows rows(n, 2);
  std::vector<char> quiet(n, 1);
  quiet[150] = 0;
  DispersionSystem system;
  system.read(rows.pairs, rows.own.data(), rows.entry.data(), n, quiet);
  EXPECT_EQ(system.stretches(), (std::vector<std::pair<std::int64_t, std::int64_t>>{{86, 215}}));
  const std::vector<double> one(n, 1.0);
  std::vector<double> product(n, 7.0), all(n);
  system.multiply(one.data(), product.data());
  system.read(rows.pairs, rows.own.data(), rows.entry.data(), n, std::vector<char>(n, 0));
  system.multiply(one.data(), all.data());
  for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(product[i], i < 86 || i >= 215 ? 0 : all[i]) << i;
}

TEST(DispersionSystem, SaysWhenAMatrixIsNotPositiveDefinite) {
  const Rows rows(20, 2);
  const std::vector<double> volume(20, 1.0), zero(20, 0.0), bad(20, std::nan(""));
  const std::vector<char> acts(20, 1);
  DispersionSystem system;
  system.read(rows.pairs, rows.own.data(), rows.entry.data(), 20, std::vector<char>(20, 0));
  EXPECT_EQ(system.solve(-100, acts, volume.data(), zero.data(), zero.data()), nullptr);
  EXPECT_EQ(system.solve(1, acts, bad.data(), zero.data(), zero.data()), nullptr);
  EXPECT_NE(system.solve(1, acts, volume.data(), zero.data(), zero.data()), nullptr);
}

}  // namespace dispersion_system
}  // namespace riffle::test
