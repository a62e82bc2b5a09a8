// Passes that run between steps: every n steps, or when a time has come; and those that run once.
#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

namespace f = riffle::fields;
constexpr riffle_field kernel_weight = scalar_field("kernel_weight", "1", "sum of W, itself included");
constexpr riffle_field runs = scalar_field("runs", "1", "how often the pass has run");
constexpr riffle_field doubled = scalar_field("doubled", "1", "twice runs");

struct Smooth {  // a Shepard filter: writes an evolved field, with help of a pass that runs only for it
  static constexpr auto id = "smooth", kind = "filter", version = "1.0.0", summary = "a filter", source = "";
  static constexpr riffle_parameter parameters[] = {integer("every", 3, 0, 100, "steps"),
                                                    real("interval", "s", 0, 0, 100, "time")};
  struct Weight : Noted<Reduce<kernel_weight, RIFFLE_AT_I, f::kernel, RIFFLE_SUM, RIFFLE_GATHER, RIFFLE_WITH_SELF>> {};
  struct Apply {
    static constexpr auto pass_name = "apply";
    static constexpr std::uint32_t pass_flags = RIFFLE_OCCASIONAL;
    static constexpr auto every = "every", interval = "interval";
    static constexpr riffle_read reads[] = {at_i(kernel_weight), at_i(f::density)};
    static constexpr riffle_write writes[] = {set(f::density)};
    static void run(const Smooth&, const Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = b.in(1)[k] / b.in(0)[k];
    }
  };
  struct Count {
    static constexpr auto pass_name = "count";
    static constexpr std::uint32_t pass_flags = RIFFLE_OCCASIONAL;
    static constexpr auto every = "every", interval = "interval";
    static constexpr riffle_read reads[] = {at_i(runs, RIFFLE_PREVIOUS)};
    static constexpr riffle_write writes[] = {set(runs)};
    static void run(const Smooth&, const Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = b.in(0)[k] + 1;
    }
  };
  using passes = Passes<Weight, Noted<Apply>, Count, Scale<doubled, runs, 2>>;
  static constexpr riffle_evolved evolved[] = {evolved_field(f::density, f::density_rate)};
  explicit Smooth(const Values&) {}
};
struct Rate : ToyOf<'r', Noted<Scale<f::density_rate, f::density, 5>>> {
  using ToyOf::ToyOf;
};

Toys toys(const std::map<std::string, double>& parameters) {
  return Toys(2).add<ToyKernel>().add<Smooth>(parameters).add<Rate>();
}
WorldOptions options() {
  return {.given = {"density"}, .wanted = {"doubled"}};
}

TEST(OccasionalPasses, RunEverySoManySteps) {
  World world(toys({{"every", 3}}), options());
  for (std::int64_t step = 1; step <= 10; ++step) {
    world.evaluator->run_occasional_passes(step, 0.1 * static_cast<double>(step), 0.1);
    EXPECT_EQ(world.value("runs", 17), static_cast<double>(step / 3)) << "step " << step;
  }
}

TEST(OccasionalPasses, RunWhenAStepHasCrossedAMultipleOfTheInterval) {
  World world(toys({{"every", 0}, {"interval", 0.25}}), options());
  double time = 0;
  const std::vector<double> ends{0.1, 0.2, 0.25, 0.26, 0.49, 0.51, 1.3, 1.49};
  const std::vector<double> expected{0, 0, 1, 1, 1, 2, 3, 3};
  for (std::size_t k = 0; k < ends.size(); ++k) {
    world.evaluator->run_occasional_passes(static_cast<std::int64_t>(k) + 1, ends[k], ends[k] - time);
    time = ends[k];
    EXPECT_EQ(world.value("runs", 17), expected[k]) << "t = " << time;
  }
}

TEST(OccasionalPasses, BringAlongWhatTheyNeedAndOnlyThen) {
  World world(toys({{"every", 2}}), options());
  world.compute({"density_rate"});
  ran().take();
  world.evaluator->run_occasional_passes(1, 0.1, 0.1);
  EXPECT_EQ(ran().take(), std::set<std::string>{});
  const auto before = world.values("density");
  world.evaluator->run_occasional_passes(2, 0.2, 0.1);
  EXPECT_EQ(ran().take(), (std::set<std::string>{"apply", "kernel_weight"}));
  EXPECT_NE(world.values("density"), before);
  world.compute({"density_rate"});
  EXPECT_EQ(ran().take(), (std::set<std::string>{"density_rate"})) << "what reads the filtered field is stale";
  EXPECT_EQ(world.value("density_rate", 5), 5 * world.value("density", 5));
}

TEST(OccasionalPasses, WhatTheyLeaveBehindCanBeReadAndKeepsItsValue) {
  World world(toys({{"every", 2}}), options());
  for (std::int64_t step = 1; step <= 5; ++step) world.evaluator->run_occasional_passes(step, 0, 0);
  world.compute({"doubled"});
  EXPECT_EQ(world.value("doubled", 3), 4.0);
}

// At t = 0: constants of each particle, from neighbours too.
struct Start {
  static constexpr auto pass_name = "start";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL | RIFFLE_WITH_SELF, neighbours = RIFFLE_SCATTER;
  static constexpr riffle_read reads[] = {at_j(f::cell_measure), at_j(f::kernel)};
  static constexpr riffle_write writes[] = {sum(kernel_weight)};
  template <class P>
  static void run(const P&, const Block& b) {
    RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] * b.in(1)[k];
  }
};

TEST(InitialPasses, RunOnceAndMaySumOverNeighbours) {
  World world(Toys(2).add<ToyKernel>().add<ToyOf<'i', Start, Scale<doubled, kernel_weight, 2>>>(),
              {.wanted = {"doubled"}});
  world.evaluator->run_initial_passes();
  const double* l = world.store.data("smoothing_length");
  const double* cell = world.store.data("cell_measure");
  auto expected = brute_force_sum(world, {Reach::scatter, RIFFLE_FLUID, gathered.sources},
                                  [&](const FoundPair& p) { return cell[p.j] * world.kernel_value(0, p.r, l[p.j]); });
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] += cell[i] * world.kernel_value(0, 0, l[i]);
  expect_same_sums(world.values("kernel_weight"), expected);
  world.move(0.05, 3);
  world.compute({"doubled"});
  for (double& e : expected) e *= 2;
  expect_same_sums(world.values("doubled"), expected);
}

}  // namespace
}  // namespace riffle::test
