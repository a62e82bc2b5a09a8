// The list against the plain double loop, as sets and exactly: both compute r2 < reach2 in double, and with random
// positions no distance lies within rounding of a reach.
#include <gtest/gtest.h>

#include <tuple>

#include "tests/unit/neighbours/particles.hpp"

namespace riffle::test {

namespace {

void expect_exact(const Particles& particles, double kappa, double skin, const NeighbourRequest& request) {
  const ParticleView view = particles.view();
  NeighbourList list;
  build(view, kappa, skin, request, list);
  ASSERT_EQ(list.begin.size(), static_cast<std::size_t>(view.owned) + 1);
  ASSERT_EQ(list.count.size(), static_cast<std::size_t>(view.owned));
  std::int64_t pairs = 0, longest = 0;
  EXPECT_EQ(list.begin[0], 0);
  for (std::int64_t i = 0; i < view.owned; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const std::int64_t padded = list.begin[k + 1] - list.begin[k];
    ASSERT_EQ(padded, (list.count[k] + 3) / 4 * 4) << "segment of particle " << i;
    ASSERT_EQ(listed_neighbours(list, i), plain_neighbours(view, (1 + skin) * kappa, request, i)) << "particle " << i;
    for (std::int64_t p = list.begin[k] + list.count[k]; p < list.begin[k + 1]; ++p) {
      ASSERT_EQ(list.neighbour[p], view.all) << "padding of particle " << i;
    }
    pairs += list.count[k];
    longest = std::max(longest, padded);
  }
  EXPECT_EQ(list.begin.back(), list.neighbour.size());
  EXPECT_EQ(list.pairs, pairs);
  EXPECT_EQ(list.longest, longest);
}

using Setting = std::tuple<int, Lengths, Reach, double>;
class List : public testing::TestWithParam<Setting> {};

TEST_P(List, HoldsExactlyThePairsWithinReach) {
  const auto [dim, lengths, reach, skin] = GetParam();
  const Particles particles = random_particles(dim, 700, dim == 1 ? 8 : 25, lengths, 11);
  expect_exact(particles, 2, skin, {reach, ~0u, ~0u});
}

TEST_P(List, HoldsOnlyTheRolesAskedFor) {
  const auto [dim, lengths, reach, skin] = GetParam();
  const Particles particles = random_particles(dim, 400, dim == 1 ? 8 : 25, lengths, 12);
  expect_exact(particles, 2, skin, {reach, 0b000001, 0b000011});  // fluid from fluid and walls
  expect_exact(particles, 2, skin, {reach, 0b000010, 0b000001});  // walls from fluid: targets are not sources
  expect_exact(particles, 2, skin, {reach, 0b100000, 0b000001});  // probes
  expect_exact(particles, 2, skin, {reach, 0b000001, 0b001000});  // nobody has the sources' role
}

std::string setting_name(const testing::TestParamInfo<Setting>& info) {
  const char* lengths[] = {"Uniform", "GentlyVarying", "StronglyVarying"};
  const char* reaches[] = {"Gather", "Scatter", "Either"};
  return std::to_string(std::get<0>(info.param)) + "D" + lengths[static_cast<int>(std::get<1>(info.param))] +
         reaches[static_cast<int>(std::get<2>(info.param))] + (std::get<3>(info.param) > 0 ? "WithSkin" : "");
}

INSTANTIATE_TEST_SUITE_P(Settings, List,
                         testing::Combine(testing::Values(1, 2, 3),
                                          testing::Values(Lengths::uniform, Lengths::gentle, Lengths::strong),
                                          testing::Values(Reach::gather, Reach::scatter, Reach::either),
                                          testing::Values(0.0, 0.15)),
                         setting_name);

TEST(List, IsEmptyWithoutParticles) {
  for (int dim = 1; dim <= 3; ++dim) {
    Particles particles;
    particles.dim = dim;
    particles.uniform_l = 1;
    expect_exact(particles, 2, 0, {});
  }
}

TEST(List, HoldsCoincidentParticlesButNeverThemselves) {
  for (int dim = 1; dim <= 3; ++dim) {
    Particles particles;
    particles.dim = dim;
    particles.owned = 3;
    particles.uniform_l = 0.1;
    for (int d = 0; d < dim; ++d) particles.x[d] = {0.5, 0.5, 0.5};
    expect_exact(particles, 2, 0, {});
    NeighbourList list;
    build(particles.view(), 2, 0, {}, list);
    EXPECT_EQ(listed_neighbours(list, 1), (std::vector<std::int32_t>{0, 2})) << dim << "D";
  }
}

TEST(List, IsExactWhenOneParticleHasFlownFarAway) {
  for (int dim = 2; dim <= 3; ++dim) {
    Particles particles = random_particles(dim, 700, 25, Lengths::uniform, 13);
    particles.x[0][5] = 1e7;
    particles.x[1][9] = -1e200;
    expect_exact(particles, 2, 0.1, {});
  }
}

TEST(List, IsExactWhenItsMemoryIsUsedAgainForOtherParticles) {
  NeighbourList list;
  for (const std::int64_t n : {500, 100, 900}) {
    for (int dim = 1; dim <= 3; ++dim) {
      const Particles particles = random_particles(dim, n, 8, Lengths::gentle, 14);
      build(particles.view(), 2, 0, {Reach::either, ~0u, ~0u}, list);
      for (std::int64_t i = 0; i < n; ++i) {
        ASSERT_EQ(listed_neighbours(list, i), plain_neighbours(particles.view(), 2, {Reach::either, ~0u, ~0u}, i));
      }
    }
  }
}

}  // namespace

}  // namespace riffle::test
