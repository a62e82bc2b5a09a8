// What cannot be searched is refused in one sentence that names the particle and its position.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/unit/neighbours/particles.hpp"

namespace riffle::test {

namespace {

std::string complaint(const Particles& particles) {
  NeighbourList list;
  try {
    build(particles.view(), 2, 0, {Reach::either, ~0u, ~0u}, list);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Search, NamesTheFirstParticleWithoutAFinitePosition) {
  for (int dim = 1; dim <= 3; ++dim) {
    Particles particles = random_particles(dim, 300, 8, Lengths::uniform, 31);
    particles.x[dim - 1][17] = nan;
    particles.x[0][40] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(complaint(particles).rfind("particle 17 at (", 0), 0u) << complaint(particles);
    EXPECT_NE(complaint(particles).find("nan): the position is not a finite number"), std::string::npos);
    EXPECT_THROW(cell_order(particles.view(), 0.1), std::runtime_error);
  }
}

TEST(Search, NamesImagesAsSuch) {
  Particles particles = random_particles(2, 300, 8, Lengths::uniform, 32);
  particles.x[0][310] = nan;
  EXPECT_EQ(complaint(particles).rfind("image particle 310 at (nan, ", 0), 0u) << complaint(particles);
}

TEST(Search, NamesTheParticleWithAnImpossibleSmoothingLength) {
  for (int dim = 1; dim <= 3; ++dim) {
    for (const double l : {nan, -0.1, std::numeric_limits<double>::infinity()}) {
      Particles particles = random_particles(dim, 300, 8, Lengths::gentle, 33);
      particles.l[25] = l;
      EXPECT_EQ(complaint(particles).rfind("particle 25 at (", 0), 0u) << complaint(particles);
      EXPECT_NE(complaint(particles).find("smoothing length"), std::string::npos);
    }
  }
}

TEST(Search, AcceptsASegmentOfOneThousandAndRefusesTheNext) {
  for (int dim = 1; dim <= 3; ++dim) {
    Particles particles;
    particles.dim = dim;
    particles.uniform_l = 1;
    Random random(34);
    for (int i = 0; i < 1001; ++i) {
      for (int d = 0; d < dim; ++d) particles.x[d].push_back(random(0, 0.5));
    }
    particles.owned = 1001;
    EXPECT_EQ(complaint(particles), "") << dim << "D";
    for (int d = 0; d < dim; ++d) particles.x[d].push_back(0.25);
    particles.owned = 1002;
    EXPECT_EQ(complaint(particles).rfind("particle 0 at (", 0), 0u) << complaint(particles);
    EXPECT_NE(complaint(particles).find("has more than 1000 neighbours"), std::string::npos);
  }
}

TEST(Search, RefusesAReachThatCoversACrowdWithoutTouchingForeignMemory) {
  // many more candidates than a segment may hold, in one row of cells, for each way of reaching
  for (int dim = 1; dim <= 3; ++dim) {
    for (const Reach reach : {Reach::gather, Reach::scatter, Reach::either}) {
      Particles particles = random_particles(dim, 20000, 8, Lengths::gentle, 35);
      std::fill(particles.l.begin(), particles.l.end(), 10);
      NeighbourList list;
      EXPECT_THROW(build(particles.view(), 2, 0, {reach, ~0u, ~0u}, list), std::runtime_error);
    }
  }
}

}  // namespace

}  // namespace riffle::test
