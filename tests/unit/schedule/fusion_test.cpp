// What is one sweep, and where a sweep must end.
#include <omp.h>

#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

namespace f = riffle::fields;
constexpr riffle_field a = scalar_field("a", "1", "a particle field");
constexpr riffle_field b = scalar_field("b", "1", "a particle field");
constexpr riffle_field c = scalar_field("c", "1", "a particle field");
constexpr riffle_field d = scalar_field("d", "1", "a particle field");
constexpr riffle_field e = scalar_field("e", "1", "a particle field");

// Sweeps of everything, each as the labels of its stages: "{x + y}" for a group over pairs, "z" for a particle pass.
std::vector<std::string> sweeps(const Toys& toys, const std::vector<std::string>& given,
                                const std::vector<std::string>& wanted) {
  const Graph graph(2, toys.active, given, wanted);
  std::vector<int> nodes;
  for (std::size_t n = 0; n < graph.nodes().size(); ++n) nodes.push_back(static_cast<int>(n));
  const auto name = [&](int n) { return std::string(graph.nodes()[static_cast<std::size_t>(n)].pass->name); };
  std::vector<std::string> all;
  for (const Sweep& sweep : make_plan(graph, nodes).sweeps) {
    std::string text = sweep.global >= 0 ? "global " + name(sweep.global) : "";
    for (const Stage& stage : sweep.stages) {
      if (!text.empty()) text += ", ";
      if (stage.group < 0) {
        text += name(stage.node);
        continue;
      }
      const PairGroup& group = sweep.groups[static_cast<std::size_t>(stage.group)];
      std::string inside;
      for (const int n : group.producers) inside += name(n) + " -> ";
      for (std::size_t k = 0; k < group.nodes.size(); ++k) inside += (k > 0 ? " + " : "") + name(group.nodes[k]);
      text += "{" + inside + "}";
    }
    all.push_back(text);
  }
  return all;
}
using Texts = std::vector<std::string>;

template <class... Pass>
Toys with() {
  return Toys(2).add<ToyKernel>().add<ToyOf<'t', Pass...>>();
}

TEST(Fusion, PairPassesOverOneListThatDoNotFeedEachOtherAreGatheredOnce) {
  EXPECT_EQ(sweeps(with<Reduce<a, RIFFLE_AT_I, f::kernel>, Reduce<b, RIFFLE_AT_J, f::kernel>>(), {"smoothing_length"},
                   {"a", "b"}),
            (Texts{"{a + b}"}));
}

TEST(Fusion, AParticlePassAndAPairPassThatReadsItsOwnParticleStayInTheSweep) {
  EXPECT_EQ(sweeps(with<Reduce<a, RIFFLE_AT_I, f::kernel>, Scale<b, a>, Reduce<c, RIFFLE_AT_I, b>>(),
                   {"smoothing_length"}, {"c"}),
            (Texts{"{a}, b, {c}"}));
}

TEST(Fusion, ASweepEndsWhereAPassReadsOfNeighboursWhatItWrote) {
  for (const auto& text : {sweeps(with<Reduce<a, RIFFLE_AT_I, f::kernel>, Scale<b, a>, Reduce<c, RIFFLE_AT_J, b>>(),
                                  {"smoothing_length"}, {"c"}),
                           sweeps(with<Reduce<a, RIFFLE_AT_I, f::kernel>, Scale<b, a>, Reduce<c, RIFFLE_MEAN, b>>(),
                                  {"smoothing_length"}, {"c"})}) {
    EXPECT_EQ(text, (Texts{"{a}, b", "{c}"}));
  }
}

TEST(Fusion, WhatDoesNotWaitGoesIntoTheEarlierSweep) {
  EXPECT_EQ(sweeps(with<Reduce<a, RIFFLE_AT_I, f::kernel>, Reduce<b, RIFFLE_AT_J, a>, Reduce<c, RIFFLE_AT_J, f::kernel>,
                        Scale<d, c>>(),
                   {"smoothing_length"}, {"b", "d"}),
            (Texts{"{a + c}, d", "{b}"}));
}

TEST(Fusion, ListsOfAnotherReachOrOtherRolesAreGroupsOfTheirOwn) {
  EXPECT_EQ(sweeps(with<Reduce<a, RIFFLE_AT_I, f::kernel>, Reduce<b, RIFFLE_AT_I, f::kernel, RIFFLE_SUM, RIFFLE_EITHER>,
                        Reduce<c, RIFFLE_AT_I, f::kernel, RIFFLE_SUM, RIFFLE_GATHER, 0, RIFFLE_WALL>>(),
                   {"smoothing_length"}, {"a", "b", "c"}),
            (Texts{"{a}, {b}, {c}"}));
}

struct Global {
  static constexpr auto pass_name = "g";
  static constexpr auto pass_type = RIFFLE_PASS_GLOBAL;
  static constexpr riffle_read reads[] = {at_i(a)};
  static constexpr riffle_write writes[] = {set(b)};
  template <class P>
  static void run(const P&, const Block&, const riffle_pairs&) {}
};

TEST(Fusion, AGlobalPassStandsAlone) {
  EXPECT_EQ(sweeps(with<Reduce<a, RIFFLE_AT_I, f::kernel>, Global, Scale<c, b>, Reduce<d, RIFFLE_AT_I, f::kernel>>(),
                   {"smoothing_length"}, {"c", "d"}),
            (Texts{"{a + d}", "global g", "c"}));
}

TEST(Fusion, ASmoothingLengthThatWasJustWrittenMakesNewLists) {
  EXPECT_EQ(sweeps(with<Scale<f::smoothing_length, f::depth>, Scale<b, f::depth>, Reduce<a, RIFFLE_AT_I, f::kernel>>(),
                   {"depth"}, {"a", "b"}),
            (Texts{"smoothing_length, b", "{a}"}));
}

constexpr riffle_field first_pair = scalar_field("first_pair", "1", "of a closure", RIFFLE_PER_PAIR);
constexpr riffle_field second_pair = scalar_field("second_pair", "1", "of a closure", RIFFLE_PER_PAIR);
template <const riffle_field& Out, const riffle_field& In, std::uint32_t Where>
struct Closure {
  static constexpr auto pass_name = Out.name;
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr riffle_read reads[] = {{sizeof(riffle_read), Where, 0, 0, &In}};
  static constexpr riffle_write writes[] = {set(Out)};
  template <class P>
  static void run(const P&, const Block& block) {
    RIFFLE_EACH(k, block) block.out(0)[k] = 2 * block.in(0)[k];
  }
};
using Chain = ToyOf<'t', Closure<second_pair, first_pair, RIFFLE_PAIR>, Reduce<b, RIFFLE_PAIR, second_pair>,
                    Closure<first_pair, a, RIFFLE_AT_J>, Reduce<a, RIFFLE_AT_I, f::kernel>>;

TEST(Fusion, ClosuresAreEvaluatedWithinTheGroupThatReadsThemInTheirOrder) {
  EXPECT_EQ(sweeps(Toys(2).add<ToyKernel>().add<Chain>(), {"smoothing_length"}, {"b"}),
            (Texts{"{a}", "{first_pair -> second_pair -> b}"}));
}

TEST(Fusion, ClosuresOfClosuresGiveTheRightSums) {
  for (const int dim : {1, 2, 3}) {
    World world(Toys(dim).add<ToyKernel>().add<Chain>(), {.dim = dim, .wanted = {"b"}, .skin = 0});
    world.compute({"b"});
    const double* own = world.store.data("a");
    expect_same_sums(world.values("b"),
                     brute_force_sum(world, gathered, [&](const FoundPair& pair) { return 4 * own[pair.j]; }));
  }
}

// Two passes of one sweep, the second of which reads its own particle's new value: also where nothing is gathered.
using Fresh = ToyOf<'t', Reduce<a, RIFFLE_AT_I, f::kernel>, Scale<b, a, 3>, Reduce<c, RIFFLE_AT_I, b>,
                    Reduce<d, RIFFLE_AT_I, a, RIFFLE_SUM, RIFFLE_EITHER>>;

TEST(Fusion, WithinASweepAPassSeesWhatWasJustWrittenForItsParticle) {
  for (const int dim : {1, 2, 3}) {
    World world(Toys(dim).add<ToyKernel>().add<Fresh>(),
                {.dim = dim, .per_role = {600, 0, 0, 0, 0, 0}, .wanted = {"c", "d"}, .skin = 0});
    world.compute({"c", "d"});
    const double* l = world.store.data("smoothing_length");
    const auto sums = brute_force_sum(world, gathered,
                                      [&](const FoundPair& pair) { return world.kernel_value(0, pair.r, l[pair.i]); });
    const NeighbourRequest either{Reach::either, gathered.targets, gathered.sources};
    expect_same_sums(world.values("c"), brute_force_sum(world, gathered, [&](const FoundPair& pair) {
                       return 3 * sums[static_cast<std::size_t>(pair.i)];
                     }));
    expect_same_sums(world.values("d"), brute_force_sum(world, either, [&](const FoundPair& pair) {
                       return sums[static_cast<std::size_t>(pair.i)];
                     }));
  }
}

// A length that follows from the particles: every list after it must be the new one.
TEST(Fusion, ListsFollowASmoothingLengthThatAPassWrites) {
  for (const int dim : {1, 2, 3}) {
    World world(Toys(dim)
                    .add<ToyKernel>()
                    .add<ToyOf<'t', Scale<f::smoothing_length, f::depth>, Reduce<a, RIFFLE_AT_I, f::kernel>>>(),
                {.dim = dim, .given = {"depth"}, .wanted = {"a"}, .written_length = true});
    for (const double factor : {0.08, 0.16}) {
      for (std::int64_t i = 0; i < world.store.owned(); ++i) world.store.data("depth")[i] *= factor;
      world.changed("depth");
      world.compute({"a"});
      const double* l = world.store.data("smoothing_length");
      expect_same_sums(world.values("a"), brute_force_sum(world, gathered, [&](const FoundPair& pair) {
                         return world.kernel_value(0, pair.r, l[pair.i]);
                       }));
      for (std::int64_t i = 0; i < world.store.owned(); ++i) world.store.data("depth")[i] /= factor;
    }
  }
}

// Support and depth together, repeated until the support no longer changes.
struct Coupled {
  static constexpr auto id = "coupled", kind = "equations", version = "1.0.0", summary = "", source = "";
  static constexpr riffle_parameter parameters[] = {real("tolerance", "1", 1e-12, 0, 1, ""),
                                                    integer("most", 200, 1, 1000, "")};
  static constexpr riffle_field change = scalar_field("change", "1", "of the support");
  static constexpr riffle_iteration iterations[] = {
      {sizeof(riffle_iteration), 0, "support", &change, "tolerance", "most"}};
  struct Sum : Reduce<a, RIFFLE_AT_I, f::kernel, RIFFLE_SUM, RIFFLE_GATHER, RIFFLE_WITH_SELF> {
    static constexpr auto iteration = "support";
    static constexpr riffle_read reads[] = {at_i(f::kernel, RIFFLE_PREVIOUS)};
  };
  struct Support {
    static constexpr auto pass_name = "support", iteration = "support";
    static constexpr riffle_read reads[] = {at_i(a), at_i(f::smoothing_length, RIFFLE_PREVIOUS)};
    static constexpr riffle_write writes[] = {set(f::smoothing_length), set(change)};
    static void run(const Coupled&, const Block& block) {  // l^d sum W = 5, approached half way each time
      for (std::int64_t k = 0; k < block.size(); ++k) {
        const double l = std::sqrt(block.in(1)[k] * std::pow(5.0 / block.in(0)[k], 1.0 / block.dim()));
        block.out(1)[k] = l / block.in(1)[k] - 1;
        block.out(0)[k] = l;
      }
    }
  };
  using passes = Passes<Sum, Support>;
  explicit Coupled(const Values&) {}
};

TEST(Iteration, RepeatsItsPassesUntilTheResidualIsSmall) {
  for (const int dim : {1, 2, 3}) {
    World world(Toys(dim).add<ToyKernel>().add<Coupled>(), {.dim = dim, .wanted = {"a"}, .written_length = true});
    world.compute({"smoothing_length"});
    for (const double change : world.values("change")) ASSERT_LE(std::abs(change), 1e-12);
    const double* l = world.store.data("smoothing_length");
    const double* sum = world.store.data("a");
    for (std::int64_t i = 0; i < world.store.owned(); ++i)
      ASSERT_NEAR(sum[i] * std::pow(l[i], dim), 5.0, 1e-10);  // twice the tolerance per power of l, and slack
  }
}

TEST(Iteration, StopsAtItsLargestNumber) {
  World world(Toys(2).add<ToyKernel>().add<Coupled>({{"most", 3}}), {.wanted = {"a"}, .written_length = true});
  world.compute({"smoothing_length"});
  EXPECT_EQ(world.evaluator->evaluations(), 3 * 300);
}

// One particle of 6000 has moved: its neighbours need the 40 halvings of the error to 1e-12, all others one look.
TEST(Iteration, ParticlesThatHaveConvergedRestWhateverTheChunks) {
  omp_set_num_threads(1);  // some hundred sweeps over few particles
  std::vector<double> results[2];
  for (const std::int64_t chunk : {256, 7}) {
    World world(Toys(1).add<ToyKernel>().add<Coupled>(), {.dim = 1,
                                                          .per_role = {6000, 0, 0, 0, 0, 0},
                                                          .wanted = {"a"},
                                                          .written_length = true,
                                                          .runner = {.chunk = chunk}});
    world.compute({"smoothing_length"});
    const std::int64_t before = world.evaluator->evaluations();
    world.store.data("position")[3000] += 1e-5;
    world.changed("position");
    world.compute({"smoothing_length"});
    EXPECT_GT(world.evaluator->evaluations() - before, 6000);
    EXPECT_LT(world.evaluator->evaluations() - before, 4 * 6000);
    results[chunk == 7 ? 1 : 0] = world.values("smoothing_length");
  }
  EXPECT_EQ(results[0], results[1]);
}

}  // namespace
}  // namespace riffle::test
