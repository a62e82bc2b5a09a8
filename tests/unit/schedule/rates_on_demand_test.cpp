// Rates on demand: only passes that are stale and needed run, and what they give does not depend on which others were.
#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

namespace f = riffle::fields;
using Names = std::set<std::string>;

// A weakly compressible set in small: continuity, state equation, momentum.
struct Continuity {
  static constexpr auto pass_name = "continuity";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr riffle_read reads[] = {pair(f::approach), at_i(f::kernel_gradient)};
  static constexpr riffle_write writes[] = {sum(f::density_rate)};
  template <class P>
  static void run(const P&, const Block& b) {
    RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] * b.in(1)[k];
  }
};
using State = Scale<f::pressure, f::density, 3>;
template <char Name, std::uint32_t Where>
struct Push {  // acceleration += p F x_ij
  static constexpr char pass_name[] = {'p', 'u', 's', 'h', '-', Name, 0};
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr riffle_read reads[] = {
      {sizeof(riffle_read), Where, 0, 0, &f::pressure}, at_i(f::kernel_gradient), pair(f::separation)};
  static constexpr riffle_write writes[] = {sum(f::acceleration)};
  template <class P>
  static void run(const P&, const Block& b) {
    for (int c = 0; c < b.dim(); ++c) {
      RIFFLE_EACH(k, b) b.out(0, c)[k] = b.in(0)[k] * b.in(1)[k] * b.in(2, c)[k];
    }
  }
};
using Momentum = Push<'j', RIFFLE_AT_J>;
struct Compressible : ToyOf<'c', Noted<Continuity>, Noted<State>, Noted<Momentum>> {
  using ToyOf::ToyOf;
  static constexpr riffle_evolved evolved[] = {evolved_field(f::position, f::velocity),
                                               evolved_field(f::velocity, f::acceleration),
                                               evolved_field(f::density, f::density_rate)};
};

TEST(RatesOnDemand, FirstTheDensityRateThenWithTheNewDensityOnlyStateAndMomentum) {
  World world(Toys(2).add<ToyKernel>().add<Compressible>(), {.given = {"velocity", "density"}});
  ran().take();
  world.compute({"density_rate"});
  EXPECT_EQ(ran().take(), (Names{"continuity"}));
  world.changed("density");
  world.compute({"acceleration"});
  EXPECT_EQ(ran().take(), (Names{"pressure", "push-j"}));
  world.compute({"acceleration", "density_rate"});
  EXPECT_EQ(ran().take(), Names{}) << "all was fresh";
  world.changed("velocity");
  world.compute({"acceleration", "density_rate"});
  EXPECT_EQ(ran().take(), (Names{"continuity"}));
  world.changed("position");
  world.compute({"acceleration"});
  EXPECT_EQ(ran().take(), (Names{"push-j"}));
  world.compute({"density_rate"});
  EXPECT_EQ(ran().take(), (Names{"continuity"}));
}

TEST(RatesOnDemand, OneCallForSeveralRatesRunsEachPassOnce) {
  World world(Toys(2).add<ToyKernel>().add<Compressible>(), {.given = {"velocity", "density"}});
  ran().take();
  world.compute({"density_rate", "acceleration"});
  EXPECT_EQ(ran().take(), (Names{"continuity", "pressure", "push-j"}));
  EXPECT_EQ(world.evaluator->evaluations(), 300 * 2) << "continuity and state, then momentum: two sweeps over pairs";
}

// Three that add to one field; the last waits for a pass that may be stale or not.
using Three = ToyOf<'t', State, Push<'i', RIFFLE_AT_I>, Momentum, Push<'m', RIFFLE_MEAN>>;
struct Gravity {
  static constexpr auto pass_name = "gravity";
  static constexpr riffle_read reads[] = {at_i(f::velocity)};
  static constexpr riffle_write writes[] = {sum(f::acceleration)};
  template <class P>
  static void run(const P&, const Block& b) {
    for (int c = 0; c < b.dim(); ++c) {
      for (std::int64_t k = 0; k < b.size(); ++k) b.out(0, c)[k] += 0.1 * b.in(0, c)[k];
    }
  }
};
using Fourth = ToyOf<'g', Gravity>;

TEST(RatesOnDemand, TheOrderOfContributionsDoesNotDependOnWhatElseWasStale) {
  World world(Toys(2).add<Fourth>().add<ToyKernel>().add<Three>(),
              {.given = {"velocity", "density"}, .wanted = {"acceleration"}});
  world.compute({"acceleration"});
  const auto all_stale = world.values("acceleration", 1);
  world.changed("velocity");  // gravity alone is stale, and with it the sum; the state is fresh
  world.compute({"acceleration"});
  EXPECT_EQ(world.values("acceleration", 1), all_stale);
  world.changed("density");
  world.compute({"acceleration"});
  EXPECT_EQ(world.values("acceleration", 1), all_stale);
}

TEST(RatesOnDemand, ASumThatIsFormedAgainStartsFromZero) {
  World world(Toys(1).add<Fourth>().add<ToyKernel>().add<Three>(),
              {.dim = 1, .given = {"velocity", "density"}, .wanted = {"acceleration"}});
  for (int k = 0; k < 3; ++k) {
    world.changed("density");
    world.compute({"acceleration"});
    const double* p = world.store.data("pressure");
    const double* l = world.store.data("smoothing_length");
    auto expected = brute_force_sum(world, gathered, [&](const FoundPair& pair) {
      const double both = p[pair.i] + p[pair.j] + 0.5 * (p[pair.i] + p[pair.j]);
      return both * world.kernel_value(1, pair.r, l[pair.i]) * pair.dx[0];
    });
    for (std::size_t i = 0; i < expected.size(); ++i)
      expected[i] += 0.1 * world.value("velocity", static_cast<std::int64_t>(i));
    expect_same_sums(world.values("acceleration"), expected);
  }
}

// The first writer of one sum may be a later one of another: a pass with two sums zeroes only what it begins.
constexpr riffle_field second_sum = scalar_field("second_sum", "1", "begun by the particle pass", RIFFLE_ACCUMULATES);
constexpr riffle_field first_sum = scalar_field("first_sum", "1", "begun by the pair pass", RIFFLE_ACCUMULATES);
struct Both {
  static constexpr auto pass_name = "both";
  static constexpr riffle_read reads[] = {at_i(f::density)};
  static constexpr riffle_write writes[] = {sum(first_sum), sum(second_sum)};
  template <class P>
  static void run(const P&, const Block& b) {
    for (std::int64_t k = 0; k < b.size(); ++k) {
      b.out(0)[k] += b.in(0)[k];
      b.out(1)[k] += b.in(0)[k];
    }
  }
};
using Sums = ToyOf<'s', Reduce<first_sum, RIFFLE_AT_I, f::kernel>, Both, Reduce<second_sum, RIFFLE_AT_I, f::kernel>>;

TEST(RatesOnDemand, APassThatAddsToTwoSumsBeginsOnlyTheOneThatNobodyBeganBefore) {
  World world(Toys(2).add<ToyKernel>().add<Sums>(), {.given = {"density"}, .wanted = {"first_sum", "second_sum"}});
  for (int k = 0; k < 2; ++k) {
    world.changed("density");
    world.compute({"first_sum", "second_sum"});
    const double* l = world.store.data("smoothing_length");
    auto expected = brute_force_sum(world, gathered,
                                    [&](const FoundPair& pair) { return world.kernel_value(0, pair.r, l[pair.i]); });
    for (std::size_t i = 0; i < expected.size(); ++i)
      expected[i] += world.value("density", static_cast<std::int64_t>(i));
    expect_same_sums(world.values("first_sum"), expected);
    expect_same_sums(world.values("second_sum"), expected);
  }
}

// A force that reads nothing but the time.
struct Swing {
  static constexpr auto pass_name = "swing";
  static constexpr riffle_write writes[] = {set(f::acceleration)};
  template <class P>
  static void run(const P&, const Block& b) {
    for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = b.time();
  }
};
using Swinging = ToyOf<'w', Noted<Swing>>;

TEST(RatesOnDemand, APassThatReadsNothingThatChangesFollowsTheTime) {
  World world(Toys(1).add<Swinging>(), {.dim = 1, .wanted = {"acceleration"}});
  world.compute({"acceleration"}, 1.0);
  EXPECT_EQ(world.value("acceleration", 17), 1.0);
  world.compute({"acceleration"}, 2.5);
  EXPECT_EQ(world.value("acceleration", 17), 2.5);
  ran().take();
  world.compute({"acceleration"}, 2.5);
  EXPECT_EQ(ran().take(), Names{}) << "at one time it is asked once";
}

}  // namespace
}  // namespace riffle::test
