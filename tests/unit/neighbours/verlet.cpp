#include "host/neighbours/verlet.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>

#include "tests/unit/neighbours/particles.hpp"

namespace riffle::test {

namespace {

using VerletSetting = std::tuple<int, Lengths, Reach>;
class Verlet : public testing::TestWithParam<VerletSetting> {};

// An image has the role and the smoothing length of its origin and moves no further than the owned particles do.
void make_images_alike(Particles& particles) {
  for (std::size_t i = static_cast<std::size_t>(particles.owned), origin = 0; i < particles.x[0].size();
       ++i, ++origin) {
    particles.role[i] = particles.role[origin];
    if (!particles.l.empty()) particles.l[i] = particles.l[origin];
  }
}

TEST_P(Verlet, NeverCallsAListValidThatMissesAPair) {
  const auto [dim, lengths, reach] = GetParam();
  const NeighbourRequest request{reach, 0b000011, 0b000001};
  const double kappa = 2, skin = 0.2;
  Random random(61);
  int valid = 0, invalid = 0;
  for (std::uint64_t round = 0; round < 40; ++round) {
    Particles particles = random_particles(dim, 250, dim == 1 ? 8 : 25, lengths, 62 + round);
    make_images_alike(particles);
    NeighbourList list;
    build(particles.view(), kappa, skin, request, list);
    VerletCheck check;
    check.remember(particles.view(), kappa, skin, request);
    const double step = random(0, 1.2) * skin * kappa * particles.uniform_l / std::sqrt(dim);
    for (std::size_t i = 0; i < particles.x[0].size(); ++i) {
      const double furthest = i < static_cast<std::size_t>(particles.owned) ? step : 0.5 * step;
      for (int d = 0; d < dim; ++d) particles.x[d][i] += random(-furthest, furthest);
      if (!particles.l.empty()) particles.l[i] *= random(0.98, 1.02);
    }
    make_images_alike(particles);
    if (!check.valid(particles.view())) {
      ++invalid;
      continue;
    }
    ++valid;
    for (std::int64_t i = 0; i < particles.owned; ++i) {
      const std::vector<std::int32_t> listed = listed_neighbours(list, i);
      for (const std::int32_t j : plain_neighbours(particles.view(), kappa, request, i)) {
        ASSERT_TRUE(std::binary_search(listed.begin(), listed.end(), j)) << i << " misses " << j;
      }
    }
  }
  EXPECT_GT(valid, 3);
  EXPECT_GT(invalid, 3);
}

INSTANTIATE_TEST_SUITE_P(Settings, Verlet,
                         testing::Combine(testing::Values(1, 2, 3), testing::Values(Lengths::uniform, Lengths::gentle),
                                          testing::Values(Reach::gather, Reach::scatter, Reach::either)));

Particles two_particles() {  // of role 0 and 1, support 1, skin 0.2
  Particles particles;
  particles.dim = 2;
  particles.owned = 2;
  particles.x[0] = {0, 1};
  particles.x[1] = {0, 0};
  particles.role = {0, 1};
  particles.l = {0.5, 0.5};
  return particles;
}

TEST(VerletCheck, AllowsHalfTheSkinPerParticle) {
  VerletCheck check;
  const Particles then = two_particles();
  check.remember(then.view(), 2, 0.2, {});
  EXPECT_DOUBLE_EQ(check.margin(then.view()), 0.2);
  Particles now = then;
  now.x[1][0] = 0.099;
  EXPECT_TRUE(check.valid(now.view()));
  now.x[1][0] = 0.101;
  EXPECT_FALSE(check.valid(now.view()));
}

TEST(VerletCheck, CountsTheGrowthOfThoseSupportsThatDecide) {
  const Particles then = two_particles();
  Particles grown = then;
  grown.l[1] = 0.7;  // of the source, by more than the skin
  VerletCheck check;
  check.remember(then.view(), 2, 0.2, {Reach::gather, 0b01, 0b10});
  EXPECT_TRUE(check.valid(grown.view()));
  check.remember(then.view(), 2, 0.2, {Reach::scatter, 0b01, 0b10});
  EXPECT_FALSE(check.valid(grown.view()));
  check.remember(then.view(), 2, 0.2, {Reach::either, 0b01, 0b10});
  EXPECT_FALSE(check.valid(grown.view()));
}

TEST(VerletCheck, DoesNotCareForParticlesThatAreNeitherTargetNorSource) {
  VerletCheck check;
  const Particles then = two_particles();
  check.remember(then.view(), 2, 0.2, {Reach::gather, 0b01, 0b01});
  Particles now = then;
  now.x[0][1] = 5;
  EXPECT_TRUE(check.valid(now.view()));
}

TEST(VerletCheck, IsNotValidForOtherParticlesNorForPositionsThatAreNotNumbers) {
  VerletCheck check;
  const Particles then = two_particles();
  EXPECT_FALSE(check.valid(then.view()));
  check.remember(then.view(), 2, 0.2, {});
  EXPECT_TRUE(check.valid(then.view()));
  Particles now = then;
  now.x[1][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(check.valid(now.view()));
  now = then;
  now.owned = 1;
  EXPECT_FALSE(check.valid(now.view()));
  check.forget();
  EXPECT_FALSE(check.valid(then.view()));
}

}  // namespace

}  // namespace riffle::test
