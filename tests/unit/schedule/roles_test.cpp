// Roles as targets and sources: walls that learn from water, probes that look and are not seen.
#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

constexpr riffle_field seen = scalar_field("seen", "1", "sum over the neighbours", RIFFLE_ACCUMULATES);
constexpr riffle_field learnt = scalar_field("learnt", "1", "what walls take from water");
constexpr riffle_field marked = scalar_field("marked", "1", "by one pass per role");
constexpr riffle_field twice = scalar_field("twice", "1", "added to by passes whose roles overlap", RIFFLE_ACCUMULATES);

template <const riffle_field& Out, std::uint32_t Targets, std::uint32_t Sources>
using Look = Reduce<Out, RIFFLE_AT_J, weight, RIFFLE_SUM, RIFFLE_GATHER, 0, Targets, Sources>;

WorldOptions mixed(int dim, std::vector<std::string> wanted) {
  WorldOptions options;
  options.dim = dim;
  options.per_role = {150, 80, 20, 20, 10, 20};
  options.given = {"weight"};
  options.wanted = std::move(wanted);
  options.skin = 0;
  return options;
}

class Roles : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, Roles, testing::Values(1, 2, 3));

TEST_P(Roles, ByDefaultWaterIsTheTargetAndAllButProbesAreSources) {
  World world(Toys(GetParam()).add<ToyKernel>().add<ToyOf<'d', Reduce<seen, RIFFLE_AT_J, weight>>>(),
              mixed(GetParam(), {"seen"}));
  world.compute({"seen"});
  const double* w = world.store.data("weight");
  const NeighbourRequest request{Reach::gather, RIFFLE_FLUID,
                                 RIFFLE_FLUID | RIFFLE_WALL | RIFFLE_INFLOW | RIFFLE_OUTFLOW | RIFFLE_PISTON};
  expect_same_sums(world.values("seen"), brute_force_sum(world, request, [&](const FoundPair& p) { return w[p.j]; }));
}

TEST_P(Roles, WallsLearnFromWaterAlone) {
  World world(Toys(GetParam()).add<ToyKernel>().add<ToyOf<'w', Look<learnt, RIFFLE_WALL, RIFFLE_FLUID>>>(),
              mixed(GetParam(), {"learnt"}));
  world.compute({"learnt"});
  const double* w = world.store.data("weight");
  expect_same_sums(world.values("learnt"), brute_force_sum(world, {Reach::gather, RIFFLE_WALL, RIFFLE_FLUID},
                                                           [&](const FoundPair& p) { return w[p.j]; }));
}

TEST_P(Roles, ProbesSeeWhatTheyAskForAndAreSeenOnlyByWhoAsksForProbes) {
  using Probing =
      ToyOf<'p', Look<seen, RIFFLE_PROBE, RIFFLE_FLUID | RIFFLE_WALL>, Look<learnt, RIFFLE_FLUID, RIFFLE_PROBE>>;
  World world(Toys(GetParam()).add<ToyKernel>().add<Probing>(), mixed(GetParam(), {"seen", "learnt"}));
  world.compute({"seen", "learnt"});
  const double* w = world.store.data("weight");
  const auto at_j = [&](const FoundPair& p) { return w[p.j]; };
  expect_same_sums(world.values("seen"),
                   brute_force_sum(world, {Reach::gather, RIFFLE_PROBE, RIFFLE_FLUID | RIFFLE_WALL}, at_j));
  expect_same_sums(world.values("learnt"), brute_force_sum(world, {Reach::gather, RIFFLE_FLUID, RIFFLE_PROBE}, at_j));
}

template <int Value, std::uint32_t Roles>
struct Mark {
  static constexpr char pass_name[] = {'m', 'a', 'r', 'k', static_cast<char>('0' + Value), 0};
  static constexpr std::uint32_t targets = Roles;
  static constexpr riffle_read reads[] = {at_i(weight)};
  static constexpr riffle_write writes[] = {set(marked)};
  template <class P>
  static void run(const P&, const Block& b) {
    for (std::int64_t k = 0; k < b.size(); ++k) b.out(0)[k] = Value;
  }
};

TEST_P(Roles, OneFieldMayHaveOneWriterPerRole) {
  using Marks = ToyOf<'m', Mark<1, RIFFLE_FLUID>, Mark<2, RIFFLE_WALL | RIFFLE_PISTON>, Mark<3, RIFFLE_PROBE>>;
  World world(Toys(GetParam()).add<Marks>(), mixed(GetParam(), {"marked"}));
  world.compute({"marked"});
  for (std::int64_t i = 0; i < world.store.owned(); ++i) {
    const std::uint32_t role = world.role(i);
    const double expected = role == RIFFLE_FLUID                          ? 1
                            : (role & (RIFFLE_WALL | RIFFLE_PISTON)) != 0 ? 2
                            : role == RIFFLE_PROBE                        ? 3
                                                                          : 0;
    ASSERT_EQ(world.value("marked", i), expected) << role_name(world.store.role_of(i));
  }
}

TEST_P(Roles, TwoWritersForOneRoleAreAnErrorThatNamesBoth) {
  using Marks = ToyOf<'m', Mark<1, RIFFLE_FLUID | RIFFLE_WALL>, Mark<2, RIFFLE_WALL>>;
  try {
    World world(Toys(GetParam()).add<Marks>(), mixed(GetParam(), {"marked"}));
    FAIL() << "nobody complained";
  } catch (const ScheduleError& error) {
    ASSERT_EQ(error.lines().size(), 1u);
    EXPECT_EQ(error.lines()[0],
              "two writers of the field \"marked\": toy-m: mark1 and toy-m: mark2; only fields that "
              "accumulate, such as acceleration, may have several");
  }
}

TEST_P(Roles, SumsOfPassesWhoseRolesOverlapInPartAreWhole) {
  using Overlap = ToyOf<'o', Look<twice, RIFFLE_FLUID | RIFFLE_WALL, RIFFLE_FLUID>,
                        Look<twice, RIFFLE_WALL | RIFFLE_PROBE, RIFFLE_FLUID>, Look<twice, RIFFLE_FLUID, RIFFLE_WALL>>;
  World world(Toys(GetParam()).add<ToyKernel>().add<Overlap>(), mixed(GetParam(), {"twice"}));
  for (int k = 0; k < 2; ++k) {
    world.changed("weight");
    world.compute({"twice"});
    const double* w = world.store.data("weight");
    const auto at_j = [&](const FoundPair& p) { return w[p.j]; };
    auto expected = brute_force_sum(world, {Reach::gather, RIFFLE_FLUID | RIFFLE_WALL, RIFFLE_FLUID}, at_j);
    for (const NeighbourRequest& more : {NeighbourRequest{Reach::gather, RIFFLE_WALL | RIFFLE_PROBE, RIFFLE_FLUID},
                                         NeighbourRequest{Reach::gather, RIFFLE_FLUID, RIFFLE_WALL}}) {
      const auto part = brute_force_sum(world, more, at_j);
      for (std::size_t i = 0; i < part.size(); ++i) expected[i] += part[i];
    }
    expect_same_sums(world.values("twice"), expected);
  }
}

}  // namespace
}  // namespace riffle::test
