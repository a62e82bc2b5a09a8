#include "host/neighbours/filter.hpp"

#include <gtest/gtest.h>

#include "tests/unit/neighbours/particles.hpp"

namespace riffle::test {

namespace {

template <int dim, bool their_limit>
void expect_equal_to_plain() {
  Random random(51);
  std::vector<double> x[3], reach2;
  std::vector<std::int32_t> particle;
  for (int k = 0; k < 80; ++k) {
    for (auto& component : x) component.push_back(random(-1, 1));
    reach2.push_back(random(0, 1));
    particle.push_back(1000 - k);
  }
  const Candidates from{{x[0].data(), x[1].data(), x[2].data()}, reach2.data(), particle.data()};
  const double at[3] = {0.1, -0.2, 0.05};
  for (std::int64_t first = 0; first < 20; ++first) {
    for (std::int64_t last = first; last <= 70; ++last) {
      std::vector<std::int32_t> fast(100, -1), plain(100, -1);
      const auto n = append_within<dim, their_limit>(from, first, last, at, 0.6, fast.data()) - fast.data();
      const auto m = append_within_plain<dim, their_limit>(from, first, last, at, 0.6, plain.data()) - plain.data();
      fast.resize(static_cast<std::size_t>(n));
      plain.resize(static_cast<std::size_t>(m));
      ASSERT_EQ(fast, plain) << "candidates " << first << " to " << last;
    }
  }
}

TEST(Filter, KeepsWhatThePlainLoopKeepsInTheSameOrder) {
  expect_equal_to_plain<1, false>();
  expect_equal_to_plain<2, false>();
  expect_equal_to_plain<3, false>();
  expect_equal_to_plain<2, true>();
  expect_equal_to_plain<3, true>();
}

}  // namespace

}  // namespace riffle::test
