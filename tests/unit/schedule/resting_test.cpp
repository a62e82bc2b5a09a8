// Particles around which nothing has changed are left out, and nobody can tell from the numbers.
#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

constexpr riffle_field resting_near = scalar_field("resting_near", "1", "sum of weights around");
constexpr riffle_field resting_far = scalar_field("resting_far", "1", "sum of those sums around");

template <std::uint32_t Flags>
struct RestingNear : Reduce<resting_near, RIFFLE_AT_J, weight, RIFFLE_SUM, RIFFLE_GATHER, Flags> {};
template <std::uint32_t Flags>
struct RestingFar : Reduce<resting_far, RIFFLE_AT_J, resting_near, RIFFLE_SUM, RIFFLE_EITHER, Flags> {};
template <std::uint32_t Flags>
struct RestingPush {  // a force that depends on the kernel, and so on places to the last bit
  static constexpr auto pass_name = "push";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr std::uint32_t neighbours = RIFFLE_EITHER, pass_flags = Flags;
  static constexpr riffle_read reads[] = {at_j(resting_far), at_i(fields::kernel), difference(fields::velocity)};
  static constexpr riffle_write writes[] = {sum(fields::acceleration)};
  template <class P>
  static void run(const P&, const Block& b) {
    RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] * b.in(1)[k] + b.in(2)[k];
  }
};
template <std::uint32_t Flags>
struct RestingToy {
  static constexpr auto id = "moving", kind = "equations", version = "1.0.0", summary = "a toy", source = "";
  static constexpr riffle_evolved evolved[] = {evolved_field(fields::velocity, fields::acceleration),
                                               evolved_field(fields::position, fields::velocity)};
  using passes = Passes<RestingNear<Flags>, RestingFar<Flags>, RestingPush<Flags>>;
  explicit RestingToy(const Values&) {}
};

WorldOptions resting_line() {
  WorldOptions options;
  options.dim = 1;
  options.per_role = {1500, 0, 0, 0, 0, 0};
  options.given = {"weight", "velocity"};
  options.wanted = {"resting_far"};
  options.images = [](ParticleStore& store, std::vector<Image>& images) {  // mirrors at x = 0
    for (std::int64_t i = 0; i < store.owned(); ++i) {
      if (store.data("position")[i] < 0.002) images.push_back({i, true, 0, {}});
    }
  };
  return options;
}

void stir(World& world, std::int64_t first, std::int64_t last, double step) {
  for (std::int64_t i = first; i < last; ++i) world.store.data("position")[i] += step * (i % 3 - 1);
  world.changed("position");
}

void expect_equal(World& some, World& all) {
  for (World* world : {&some, &all}) world->compute({"acceleration", "resting_far"});
  for (const char* field : {"position", "resting_near", "resting_far", "acceleration"})
    ASSERT_EQ(some.values(field), all.values(field)) << field;
}

TEST(Resting, LeavesOutWhatIsFarFromAllChangesAndChangesNoBit) {
  World some(Toys(1).add<ToyKernel>().add<RestingToy<RIFFLE_STEADY>>(), resting_line());
  World all(Toys(1).add<ToyKernel>().add<RestingToy<0>>(), resting_line());
  expect_equal(some, all);
  for (int k = 0; k < 12; ++k) {  // long enough for any pause between looks to end
    for (World* world : {&some, &all}) stir(*world, 100 + k, 140 + k, 1e-5);
    expect_equal(some, all);
  }
  for (World* world : {&some, &all}) stir(*world, 0, 5, 1e-5);  // at the mirror
  expect_equal(some, all);
  const std::int64_t before_some = some.evaluator->evaluations(), before_all = all.evaluator->evaluations();
  for (World* world : {&some, &all}) stir(*world, 1000, 1003, 3e-3);  // past some tens of neighbours
  expect_equal(some, all);
  EXPECT_LT(some.evaluator->evaluations() - before_some, (all.evaluator->evaluations() - before_all) / 4);
}

TEST(Resting, SeesVelocitiesAndAttributesToo) {
  World some(Toys(1).add<ToyKernel>().add<RestingToy<RIFFLE_STEADY>>(), resting_line());
  World all(Toys(1).add<ToyKernel>().add<RestingToy<0>>(), resting_line());
  expect_equal(some, all);
  expect_equal(some, all);
  for (World* world : {&some, &all}) {
    world->store.data("velocity")[700] += 1e-12;
    world->changed("velocity");
  }
  expect_equal(some, all);
  for (World* world : {&some, &all}) {
    world->store.data("weight")[1200] += 1;
    world->changed("weight");
  }
  expect_equal(some, all);
}

}  // namespace
}  // namespace riffle::test
