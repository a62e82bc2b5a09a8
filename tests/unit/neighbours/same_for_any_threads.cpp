#include <gtest/gtest.h>
#include <omp.h>

#include "tests/unit/neighbours/particles.hpp"

namespace riffle::test {

namespace {

struct WithThreads {
  explicit WithThreads(int threads) { omp_set_num_threads(threads); }
  ~WithThreads() { omp_set_num_threads(before); }
  int before = omp_get_max_threads();
};

TEST(Threads, DoNotChangeTheList) {
  for (int dim = 1; dim <= 3; ++dim) {
    for (const Lengths lengths : {Lengths::uniform, Lengths::gentle}) {
      // enough particles for several waves on three threads
      const Particles particles = random_particles(dim, 26000, dim == 1 ? 8 : 20, lengths, 21);
      const NeighbourRequest request{Reach::either, 0b11, ~0u};
      NeighbourList one;
      {
        const WithThreads threads(1);
        build(particles.view(), 2, 0.1, request, one);
      }
      for (const int n : {2, 3}) {
        const WithThreads threads(n);
        NeighbourList many;
        build(particles.view(), 2, 0.1, request, many);
        EXPECT_EQ(one.begin, many.begin);
        EXPECT_EQ(one.count, many.count);
        EXPECT_EQ(one.longest, many.longest);
        EXPECT_EQ(one.pairs, many.pairs);
        ASSERT_EQ(one.neighbour.size(), many.neighbour.size());
        EXPECT_TRUE(
            std::equal(one.neighbour.data(), one.neighbour.data() + one.neighbour.size(), many.neighbour.data()))
            << dim << "D with " << n << " threads";
      }
    }
  }
}

TEST(Threads, DoNotChangeTheCellOrder) {
  const Particles particles = random_particles(2, 26000, 20, Lengths::uniform, 22);
  std::vector<std::int64_t> one;
  {
    const WithThreads threads(1);
    one = cell_order(particles.view(), 0.02);
  }
  for (const int n : {2, 3}) {
    const WithThreads threads(n);
    EXPECT_EQ(cell_order(particles.view(), 0.02), one);
  }
}

TEST(Threads, DoNotChangeWhichParticleIsBlamed) {
  Particles particles = random_particles(2, 26000, 20, Lengths::gentle, 23);
  for (const std::size_t i : {7001u, 9000u, 20000u}) particles.l[i] = 1;
  std::vector<std::string> sentences;
  for (const int n : {1, 2, 3}) {
    const WithThreads threads(n);
    NeighbourList list;
    try {
      build(particles.view(), 2, 0, {}, list);
    } catch (const std::runtime_error& error) {
      sentences.emplace_back(error.what());
    }
  }
  ASSERT_EQ(sentences.size(), 3u);
  EXPECT_NE(sentences[0].find("particle 7001 "), std::string::npos) << sentences[0];
  EXPECT_EQ(sentences[0], sentences[1]);
  EXPECT_EQ(sentences[0], sentences[2]);
}

}  // namespace

}  // namespace riffle::test
