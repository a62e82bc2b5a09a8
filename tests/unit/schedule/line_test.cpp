// One dimension along the line: particles of other roles beyond the ends of the water, as open boundaries have them.
#include "tests/unit/schedule/world.hpp"

namespace riffle::test::line {
namespace {

constexpr riffle_field by_gather = scalar_field("by_gather", "1", "sum over r < kappa l_i");
constexpr riffle_field by_either = scalar_field("by_either", "1", "sum over r < kappa max(l_i, l_j)");
constexpr riffle_field without_inflow = scalar_field("without_inflow", "1", "sum over all but inflow");
constexpr std::uint32_t all_but_inflow = RIFFLE_FLUID | RIFFLE_WALL | RIFFLE_OUTFLOW;

using Sums = ToyOf<'l', Reduce<by_gather, RIFFLE_AT_J, weight>,
                   Reduce<by_either, RIFFLE_AT_J, weight, RIFFLE_SUM, RIFFLE_EITHER>,
                   Reduce<without_inflow, RIFFLE_AT_J, weight, RIFFLE_SUM, RIFFLE_GATHER, 0, 0, all_but_inflow>>;

class Line : public testing::Test {
 protected:
  Line() : world_(Toys(1).add<ToyKernel>().add<Sums>(), options()) { place(); }
  static WorldOptions options() {
    WorldOptions options;
    options.dim = 1;
    options.per_role = {300, 6, 7, 5, 0, 20};
    options.given = {"weight"};
    options.wanted = {"by_gather", "by_either", "without_inflow"};
    options.images = [](ParticleStore& store, std::vector<Image>& images) {  // a mirror at x = 1, behind the water
      for (std::int64_t i = 0; i < store.role_begin(1); ++i) {
        if (store.data("position")[i] > 0.98) images.push_back({i, true, 0, {1, 0, 0}});
      }
    };
    return options;
  }
  // Water in (0, 1), inflow before it, walls and outflow after it, probes anywhere.
  void place() {
    double* x = world_.store.data("position");
    const double spacing = 1.0 / 300;
    for (std::int64_t i = 0; i < world_.store.owned(); ++i) {
      const std::int64_t rank = i - world_.store.role_begin(world_.store.role_of(i));
      const double at = (static_cast<double>(rank) + 0.5 + 0.3 * std::sin(7.0 * static_cast<double>(i))) * spacing;
      const std::uint32_t role = world_.role(i);
      x[i] = role == RIFFLE_INFLOW ? -at : role == RIFFLE_WALL || role == RIFFLE_OUTFLOW ? 1 + at : at;
      world_.store.data("smoothing_length")[i] = 1.6 * spacing * (1 + 0.25 * std::cos(3.0 * static_cast<double>(i)));
    }
    world_.changed("position");
    world_.changed("smoothing_length");
  }
  void expect_right() {
    world_.compute(world_.options.wanted);
    const double* w = world_.store.data("weight");
    const auto at_j = [&](const FoundPair& pair) { return w[pair.j]; };
    const NeighbourRequest either{Reach::either, gathered.targets, gathered.sources};
    expect_same_sums(world_.values("by_gather"), brute_force_sum(world_, gathered, at_j));
    expect_same_sums(world_.values("by_either"), brute_force_sum(world_, either, at_j));
    expect_same_sums(world_.values("without_inflow"), brute_force_sum(world_, limited, at_j));
  }
  static constexpr NeighbourRequest limited{Reach::gather, RIFFLE_FLUID, all_but_inflow};
  World world_;
};

TEST_F(Line, ParticlesOfOtherRolesBeyondTheEndsOfTheWaterAreNeighboursThere) {
  expect_right();
  EXPECT_TRUE(world_.neighbourhood.on_a_line(gathered));
  EXPECT_TRUE(world_.neighbourhood.on_a_line(limited));
}

TEST_F(Line, OneAmongTheWaterIsFoundOverAListAndOnlyByThoseWhoLookAtItsRole) {
  world_.store.data("position")[world_.store.role_begin(2) + 3] = 0.5;
  world_.changed("position");
  expect_right();
  EXPECT_FALSE(world_.neighbourhood.on_a_line(gathered)) << "an inflow particle stands in the water";
  EXPECT_TRUE(world_.neighbourhood.on_a_line(limited)) << "which this pass does not see";
}

TEST_F(Line, ProbesAreTargetsOfListsOnly) {
  world_.compute(world_.options.wanted);
  EXPECT_FALSE(world_.neighbourhood.on_a_line({Reach::gather, RIFFLE_PROBE, RIFFLE_FLUID}));
  EXPECT_FALSE(world_.neighbourhood.on_a_line({Reach::gather, RIFFLE_FLUID, RIFFLE_PROBE}));
}

TEST_F(Line, ListAndLineGiveTheSameSumsToRoundOff) {
  double* x = world_.store.data("position");
  const std::int64_t last_wall = world_.store.role_begin(2) - 1;  // the furthest, out of the reach of all water
  x[last_wall] = 1.5;
  world_.changed("position");
  world_.compute(world_.options.wanted);
  const std::vector<double> before = world_.values("by_gather");
  ASSERT_TRUE(world_.neighbourhood.on_a_line(gathered));
  world_.store.data("weight")[last_wall] = 0;  // seen by its neighbours, and adding nothing
  x[last_wall] = 0.5;
  world_.changed("position");
  world_.changed("weight");
  world_.compute(world_.options.wanted);
  ASSERT_FALSE(world_.neighbourhood.on_a_line(gathered));
  expect_same_sums(world_.values("by_gather"), before);
}

}  // namespace
}  // namespace riffle::test::line
