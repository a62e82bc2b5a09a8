#include <gtest/gtest.h>

#include <numeric>

#include "host/neighbours/cells.hpp"
#include "host/neighbours/line.hpp"
#include "tests/unit/neighbours/particles.hpp"

namespace riffle::test {

namespace {

TEST(CellOrder, IsAPermutationThatKeepsRolesGrouped) {
  for (int dim = 1; dim <= 3; ++dim) {
    const Particles particles = random_particles(dim, 3000, 8, Lengths::uniform, 41);
    const std::vector<std::int64_t> order = cell_order(particles.view(), 0.1);
    ASSERT_EQ(order.size(), 3000u);
    for (std::size_t k = 0; k < order.size(); ++k) {
      EXPECT_EQ(particles.role[static_cast<std::size_t>(order[k])], particles.role[k]);
    }
    std::vector<std::int64_t> sorted(order), identity(3000);
    std::sort(sorted.begin(), sorted.end());
    std::iota(identity.begin(), identity.end(), 0);
    EXPECT_EQ(sorted, identity);
  }
}

TEST(CellOrder, IsByXExactlyOnALine) {
  const Particles particles = random_particles(1, 3000, 8, Lengths::uniform, 42);
  const std::vector<std::int64_t> order = cell_order(particles.view(), 0.1);
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (particles.role[k] != particles.role[k - 1]) continue;
    EXPECT_LE(particles.x[0][static_cast<std::size_t>(order[k - 1])],
              particles.x[0][static_cast<std::size_t>(order[k])]);
  }
}

TEST(CellOrder, RunsThroughCellsRowByRowAndKeepsTheOrderWithinACell) {
  Particles particles;
  particles.dim = 2;
  particles.uniform_l = 1;
  particles.x[0] = {1.5, 0.5, 1.4, 0.4, 0.0, 2.0};
  particles.x[1] = {1.5, 1.5, 0.5, 0.5, 0.0, 2.0};
  particles.owned = 6;
  EXPECT_EQ(cell_order(particles.view(), 1.0), (std::vector<std::int64_t>{3, 4, 2, 1, 0, 5}));
}

TEST(CellOrder, DoesNotChangeWhatIsAlreadyInOrder) {
  Particles particles = random_particles(3, 3000, 8, Lengths::uniform, 43);
  const std::vector<std::int64_t> order = cell_order(particles.view(), 0.1);
  Particles sorted = particles;
  for (int d = 0; d < 3; ++d) {
    for (std::size_t k = 0; k < order.size(); ++k) sorted.x[d][k] = particles.x[d][static_cast<std::size_t>(order[k])];
  }
  std::vector<std::int64_t> identity(3000);
  std::iota(identity.begin(), identity.end(), 0);
  EXPECT_EQ(cell_order(sorted.view(), 0.1), identity);
}

TEST(Cells, StayFineWhenAFewParticlesAreFarAway) {
  Particles particles = random_particles(2, 5000, 20, Lengths::uniform, 44);
  particles.x[0][3] = 1e9;
  particles.x[1][4] = -1e6;
  const Box bounds{{0, -1e6, 0}, {1e9, 1, 0}};
  const Cells cells = fit_cells(particles.view(), bounds, 5000, 0.05, [](std::int64_t i) { return i < 5000; });
  EXPECT_DOUBLE_EQ(cells.inverse_edge, 20);
  EXPECT_LT(cells.count(), 4 * 5000 + 64);
}

TEST(Cells, GetCoarserRatherThanManyMoreThanParticles) {
  const Particles particles = random_particles(3, 1000, 20, Lengths::uniform, 45);
  const Box bounds{{0, 0, 0}, {1, 1, 1}};
  const Cells cells = fit_cells(particles.view(), bounds, 1000, 1e-9, [](std::int64_t i) { return i < 1000; });
  EXPECT_LE(cells.count(), 4 * 1000 + 64);
  EXPECT_GE(cells.count(), 500);
}

void expect_sorted_stably(const std::vector<double>& x) {
  Line line;
  line.x = x;
  line.particle.resize(x.size() + 8);
  std::iota(line.particle.begin(), line.particle.end(), 0);
  std::vector<std::int32_t> expected(x.size());
  std::iota(expected.begin(), expected.end(), 0);
  std::stable_sort(expected.begin(), expected.end(), [&](std::int32_t a, std::int32_t b) {
    return x[static_cast<std::size_t>(a)] < x[static_cast<std::size_t>(b)];
  });
  sort_along_line(line);
  line.particle.resize(x.size());
  EXPECT_EQ(line.particle, expected);
  EXPECT_TRUE(std::is_sorted(line.x.begin(), line.x.end()));
}

TEST(Line, IsSortedStablyWhateverTheOrderOfItsParticles) {
  Random random(46);
  std::vector<double> x;
  for (int i = 0; i < 1000; ++i) x.push_back(0.01 * i);
  expect_sorted_stably(x);
  std::vector<double> with_images(x);
  for (int i = 0; i < 5; ++i) with_images.insert(with_images.end(), {-0.01 * i, 9.99 + 0.01 * i});
  expect_sorted_stably(with_images);
  std::swap(x[300], x[301]);
  expect_sorted_stably(x);
  expect_sorted_stably(std::vector<double>(x.rbegin(), x.rend()));
  for (double& value : x) value = std::floor(random(0, 200));  // many equal
  expect_sorted_stably(x);
  expect_sorted_stably({});
  expect_sorted_stably({1});
}

}  // namespace

}  // namespace riffle::test
