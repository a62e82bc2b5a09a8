// Which pairs a pass sees, how their contributions are reduced, and the pair of a particle with itself.
#include <algorithm>
#include <limits>

#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

constexpr riffle_field share = scalar_field("share", "1", "something to sum");
constexpr riffle_field by_gather = scalar_field("by_gather", "1", "sum over r < kappa l_i");
constexpr riffle_field by_scatter = scalar_field("by_scatter", "1", "sum over r < kappa l_j");
constexpr riffle_field by_either = scalar_field("by_either", "1", "sum over both");

struct Criteria : ToyOf<'c', Reduce<by_gather, RIFFLE_AT_J, share, RIFFLE_SUM, RIFFLE_GATHER>,
                        Reduce<by_scatter, RIFFLE_AT_J, share, RIFFLE_SUM, RIFFLE_SCATTER>,
                        Reduce<by_either, RIFFLE_AT_J, share, RIFFLE_SUM, RIFFLE_EITHER>> {
  using ToyOf::ToyOf;
};

class Neighbours : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, Neighbours, testing::Values(1, 2, 3));

TEST_P(Neighbours, AreThoseOfTheParticleOfTheNeighbourOrOfEither) {
  WorldOptions options;
  options.dim = GetParam();
  options.given = {"share"};
  options.wanted = {"by_gather", "by_scatter", "by_either"};
  options.skin = 0;  // with a skin, lists hold pairs in which every kernel is 0; these sums know no kernel
  World world(Toys(options.dim).add<ToyKernel>().add<Criteria>(), options);
  world.compute(options.wanted);
  const double* w = world.store.data("share");
  const auto at_j = [&](const FoundPair& pair) { return w[pair.j]; };
  for (const auto& [name, reach] : std::map<std::string, Reach>{
           {"by_gather", Reach::gather}, {"by_scatter", Reach::scatter}, {"by_either", Reach::either}}) {
    SCOPED_TRACE(name);
    expect_same_sums(world.values(name), brute_force_sum(world, {reach, gathered.targets, gathered.sources}, at_j));
  }
}

// A walk along the line may end only when nobody further can see this stretch, however far some reach.
TEST(NeighboursOnALine, AreFoundWhenSupportsVaryAHundredfold) {
  WorldOptions options;
  options.dim = 1;
  options.given = {"share"};
  options.wanted = {"by_gather", "by_scatter", "by_either"};
  options.images = [](ParticleStore& store, std::vector<Image>& images) {  // a mirror at each end
    const std::int64_t n = store.owned();
    for (std::int64_t i = 0; i < n; ++i) {
      for (const double wall : {0.0, 1.0}) {
        const double x = store.data("position")[i], l = store.data("smoothing_length")[i];
        if (std::abs(x - wall) < 2 * l) images.push_back({i, true, 0, {wall, 0, 0}});
      }
    }
  };
  std::vector<std::vector<double>> first;
  for (const std::int64_t chunk : {256, 40}) {
    options.runner.chunk = chunk;
    World world(Toys(1).add<ToyKernel>().add<Criteria>(), options);
    double* l = world.store.data("smoothing_length");
    for (std::int64_t i = 0; i < world.store.owned(); ++i) l[i] *= i % 37 == 0 ? 40 : i % 5 == 0 ? 0.4 : 1;
    world.changed("smoothing_length");
    world.compute(options.wanted);
    std::vector<std::vector<double>> found;
    const double* w = world.store.data("share");
    for (const auto& [name, reach] : std::map<std::string, Reach>{
             {"by_gather", Reach::gather}, {"by_scatter", Reach::scatter}, {"by_either", Reach::either}}) {
      SCOPED_TRACE(name);
      found.push_back(world.values(name));
      expect_same_sums(found.back(), brute_force_sum(world, {reach, gathered.targets, gathered.sources},
                                                     [&](const FoundPair& pair) { return w[pair.j]; }));
    }
    if (first.empty()) first = found;
    EXPECT_EQ(found, first);  // to the last bit, wherever stretches begin
  }
}

constexpr riffle_field least_weight = scalar_field("least_weight", "1", "smallest over the neighbours");
constexpr riffle_field largest_weight = scalar_field("largest_weight", "1", "largest over the neighbours");
struct Extremes : ToyOf<'e', Reduce<least_weight, RIFFLE_AT_J, share, RIFFLE_MIN>,
                        Reduce<largest_weight, RIFFLE_AT_J, share, RIFFLE_MAX>> {
  using ToyOf::ToyOf;
};

TEST_P(Neighbours, LeastAndLargestAreExactAndInfiniteWithoutNeighbours) {
  WorldOptions options;
  options.dim = GetParam();
  options.given = {"share"};
  options.wanted = {"least_weight", "largest_weight"};
  options.skin = 0;
  World world(Toys(options.dim).add<ToyKernel>().add<Extremes>(), options);
  world.store.data("position")[5] = 17;  // alone
  world.changed("position");
  world.compute(options.wanted);
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> least(300, infinite), largest(300, -infinite);
  const double* w = world.store.data("share");
  each_pair(world, gathered, [&](const FoundPair& pair) {
    const auto i = static_cast<std::size_t>(pair.i);
    least[i] = std::min(least[i], w[pair.j]);
    largest[i] = std::max(largest[i], w[pair.j]);
  });
  EXPECT_EQ(world.values("least_weight"), least);
  EXPECT_EQ(world.values("largest_weight"), largest);
  EXPECT_EQ(std::count(least.begin(), least.end(), infinite), 1);
}

constexpr riffle_field with_self = scalar_field("with_self", "1", "sum, itself included");
constexpr riffle_field without = scalar_field("without_self", "1", "sum, itself excluded");
constexpr riffle_field least_distance = scalar_field("least_distance", "m", "smallest r, itself included");
// One group with and without: the pair of the particle with itself counts only where it was asked for.
struct Selves
    : ToyOf<'s', Reduce<with_self, RIFFLE_AT_J, share, RIFFLE_SUM, RIFFLE_GATHER, RIFFLE_WITH_SELF>,
            Reduce<without, RIFFLE_AT_J, share>,
            Reduce<least_distance, RIFFLE_PAIR, fields::distance, RIFFLE_MIN, RIFFLE_GATHER, RIFFLE_WITH_SELF>> {
  using ToyOf::ToyOf;
};

TEST_P(Neighbours, AParticleIsItsOwnNeighbourOnlyWhereAPassAsksForIt) {
  WorldOptions options;
  options.dim = GetParam();
  options.given = {"share"};
  options.wanted = {"with_self", "without_self", "least_distance"};
  options.skin = 0;
  World world(Toys(options.dim).add<ToyKernel>().add<Selves>(), options);
  world.compute(options.wanted);
  std::vector<double> expected =
      brute_force_sum(world, gathered, [&](const FoundPair& pair) { return world.value("share", pair.j); });
  expect_same_sums(world.values("without_self"), expected);
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] += world.value("share", static_cast<std::int64_t>(i));
  expect_same_sums(world.values("with_self"), expected);
  EXPECT_EQ(world.values("least_distance"), std::vector<double>(300, 0.0));
}

constexpr riffle_field difference_sum = scalar_field("difference_sum", "1", "sum of differences");
constexpr riffle_field mean_sum = scalar_field("mean_sum", "1", "sum of means");
constexpr riffle_field own_sum = scalar_field("own_sum", "1", "sum of own values");
constexpr riffle_field approach_sum = scalar_field("approach_sum", "m2.s-1", "sum of u_ij . x_ij");
constexpr riffle_field distance_sum = scalar_field("distance_sum", "m", "sum of r");
constexpr riffle_field square_sum = scalar_field("square_sum", "m2", "sum of r^2");
struct Readings : ToyOf<'r', Reduce<difference_sum, RIFFLE_DIFFERENCE, share>, Reduce<mean_sum, RIFFLE_MEAN, share>,
                        Reduce<own_sum, RIFFLE_AT_I, share>, Reduce<approach_sum, RIFFLE_PAIR, fields::approach>,
                        Reduce<distance_sum, RIFFLE_PAIR, fields::distance>,
                        Reduce<square_sum, RIFFLE_PAIR, fields::distance_squared>> {
  using ToyOf::ToyOf;
};

TEST_P(Neighbours, ValuesCanBeReadAtIAtJAsDifferenceAndAsMeanAndGeometryIsOffered) {
  WorldOptions options;
  options.dim = GetParam();
  options.given = {"share", "velocity"};
  options.wanted = {"difference_sum", "mean_sum", "own_sum", "approach_sum", "distance_sum", "square_sum"};
  options.skin = 0;
  World world(Toys(options.dim).add<ToyKernel>().add<Readings>(), options);
  world.compute(options.wanted);
  const double* w = world.store.data("share");
  const auto expect = [&](const std::string& name, const std::function<double(const FoundPair&)>& term) {
    SCOPED_TRACE(name);
    expect_same_sums(world.values(name), brute_force_sum(world, gathered, term));
  };
  expect("difference_sum", [&](const FoundPair& pair) { return w[pair.i] - w[pair.j]; });
  expect("mean_sum", [&](const FoundPair& pair) { return 0.5 * (w[pair.i] + w[pair.j]); });
  expect("own_sum", [&](const FoundPair& pair) { return w[pair.i]; });
  expect("distance_sum", [](const FoundPair& pair) { return pair.r; });
  expect("square_sum", [](const FoundPair& pair) { return pair.r * pair.r; });
  expect("approach_sum", [&](const FoundPair& pair) {
    double sum = 0;
    for (int c = 0; c < options.dim; ++c)
      sum += (world.value("velocity", pair.i, c) - world.value("velocity", pair.j, c)) * pair.dx[c];
    return sum;
  });
}

TEST(Neighbours, APairPassWithoutAKernelIsAnErrorBecauseNobodySaysHowFarItSees) {
  try {
    World world(Toys(2).add<Extremes>(), {.given = {"share"}, .wanted = {"least_weight"}});
    FAIL() << "nobody complained";
  } catch (const ScheduleError& error) {
    ASSERT_FALSE(error.lines().empty());
    EXPECT_EQ(error.lines()[0],
              "toy-e: least_weight looks at neighbours, but the case names no plugin of kind kernel, "
              "whose support says which");
  }
}

}  // namespace
}  // namespace riffle::test
