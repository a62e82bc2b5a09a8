// Pair outputs that are kept for the whole list, and the global passes that read them.
#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

constexpr riffle_field half_term = scalar_field("half_term", "1", "of a closure", RIFFLE_PER_PAIR);
constexpr riffle_field entry = scalar_field("entry", "1", "of a matrix", RIFFLE_PER_PAIR);
constexpr riffle_field row_sum = scalar_field("row_sum", "1", "sum of a row");
constexpr riffle_field spread = scalar_field("spread", "1", "sum of what others send", RIFFLE_ACCUMULATES);

struct Half {  // a closure whose output the matrix needs
  static constexpr auto pass_name = "half";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr riffle_read reads[] = {at_j(weight)};
  static constexpr riffle_write writes[] = {set(half_term)};
  template <class P>
  static void run(const P&, const Block& b) {
    RIFFLE_EACH(k, b) b.out(0)[k] = 0.5 * b.in(0)[k];
  }
};
template <std::uint32_t WriteFlags>
struct Entries {
  static constexpr auto pass_name = "entries";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr riffle_read reads[] = {pair(half_term), at_i(fields::kernel), at_i(weight)};
  static constexpr riffle_write writes[] = {set(entry, WriteFlags)};
  template <class P>
  static void run(const P&, const Block& b) {
    RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] * b.in(1)[k] * b.in(2)[k];
  }
};
// row_sum_i = sum_j entry_ij; spread_j += entry_ij, images sending to their origin.
struct Solve {
  static constexpr auto pass_name = "solve";
  static constexpr auto pass_type = RIFFLE_PASS_GLOBAL;
  static constexpr riffle_read reads[] = {pair(entry)};
  static constexpr riffle_write writes[] = {set(row_sum), sum(spread)};
  template <class P>
  static void run(const P&, const Block& b, const riffle_pairs& pairs) {
    ran().note(pass_name);
    for (std::int64_t i = 0; i < b.size(); ++i) {
      b.out(0)[i] = 0;
      for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i] + pairs.count[i]; ++k) {
        const std::int32_t j = pairs.neighbour[k];
        b.out(0)[i] += b.in(0)[k];
        b.out(1)[j < pairs.n_owned ? j : pairs.origin[j - pairs.n_owned]] += b.in(0)[k];
      }
    }
  }
};
using Keeping = ToyOf<'k', Half, Entries<RIFFLE_KEEP>, Solve>;
using Forgetful = ToyOf<'f', Half, Entries<0>, Solve>;

class KeptPairs : public testing::TestWithParam<int> {
 protected:
  KeptPairs() : world_(Toys(GetParam()).add<ToyKernel>().add<Keeping>(), options()) {}
  static WorldOptions options() {
    WorldOptions options;
    options.dim = GetParam();
    options.given = {"weight"};
    options.wanted = {"row_sum", "spread"};
    options.images = [](ParticleStore& store, std::vector<Image>& images) {  // mirrors at x = 0, shifts by 1
      for (std::int64_t i = 0; i < store.owned(); ++i) {
        if (store.data("position")[i] < 0.4) images.push_back({i, true, 0, {}});
        if (store.data("position")[i] < 0.4) images.push_back({i, false, 0, {1, 0, 0}});
      }
    };
    return options;
  }
  void expect_right() {
    world_.compute({"row_sum", "spread"});
    const double* w = world_.store.data("weight");
    const double* l = world_.store.data("smoothing_length");
    const auto term = [&](const FoundPair& pair) {
      return 0.5 * w[pair.i] * w[pair.j] * world_.kernel_value(0, pair.r, l[pair.i]);
    };
    expect_same_sums(world_.values("row_sum"), brute_force_sum(world_, gathered, term));
    std::vector<double> expected(300, 0.0);
    each_pair(world_, gathered, [&](const FoundPair& pair) {
      std::int64_t j = pair.j;
      if (j >= 300) j = world_.neighbourhood.images()[static_cast<std::size_t>(j - 300)].origin;
      expected[static_cast<std::size_t>(j)] += term(pair);
    });
    expect_same_sums(world_.values("spread"), expected);
  }
  World world_;
};
INSTANTIATE_TEST_SUITE_P(Dimensions, KeptPairs, testing::Values(1, 2, 3));

TEST_P(KeptPairs, ReachAGlobalPassInTheOrderOfTheListWithTheClosuresTheyNeed) {
  expect_right();
}

TEST_P(KeptPairs, AreMadeAnewWithTheGlobalPassWhenParticlesMoveAndItsSumsStartFromZero) {
  expect_right();
  ran().take();
  expect_right();
  EXPECT_TRUE(ran().take().empty()) << "nothing had changed";
  world_.move(0.05, 3);
  expect_right();
  EXPECT_EQ(ran().take(), (std::set<std::string>{"solve"}));
}

TEST(KeptPairsMistakes, AGlobalPassCannotReadWhatNobodyKeeps) {
  WorldOptions options;
  options.given = {"weight"};
  options.wanted = {"row_sum", "spread"};
  try {
    World world(Toys(2).add<ToyKernel>().add<Forgetful>(), options);
    FAIL() << "nobody complained";
  } catch (const ScheduleError& error) {
    ASSERT_EQ(error.lines().size(), 1u);
    EXPECT_EQ(error.lines()[0], "toy-f: solve reads \"entry\" of all pairs, but no pass keeps it (RIFFLE_KEEP)");
  }
}

}  // namespace
}  // namespace riffle::test
