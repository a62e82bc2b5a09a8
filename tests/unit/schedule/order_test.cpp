// Order follows from the fields; what contradicts itself is refused in sentences that name the plugins.
#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

namespace f = riffle::fields;
constexpr riffle_field a = scalar_field("a", "1", "first");
constexpr riffle_field b = scalar_field("b", "1", "second");
constexpr riffle_field c = scalar_field("c", "1", "third");
constexpr riffle_field a_in_metres = scalar_field("a", "m", "the same name, another unit");
constexpr riffle_field a_vector = vector_field("a", "1", "the same name, another shape");

std::vector<std::string> labels(const Graph& graph) {
  std::vector<std::string> all;
  for (const auto& node : graph.nodes()) all.push_back(node.label);
  return all;
}

std::vector<std::string> complaints(const Toys& toys, const std::vector<std::string>& given,
                                    const std::vector<std::string>& wanted) {
  try {
    const Graph graph(2, toys.active, given, wanted);
  } catch (const ScheduleError& error) {
    return error.lines();
  }
  return {};
}

TEST(Order, FollowsFromTheFieldsAndNotFromTheOrderOfDeclaration) {
  const Toys toys = Toys(2).add<ToyOf<'z', Scale<c, b>, Scale<a, f::depth>>>().add<ToyOf<'y', Scale<b, a>>>();
  const Graph graph(2, toys.active, {"depth"}, {"c"});
  EXPECT_EQ(labels(graph), (std::vector<std::string>{"toy-z: a", "toy-y: b", "toy-z: c"}));
}

TEST(Order, ReadingThePreviousValueOrdersNothing) {
  const Toys toys = Toys(2).add<ToyOf<'z', Scale<b, a, 1, RIFFLE_PREVIOUS>, Scale<a, b>>>();
  const Graph graph(2, toys.active, {}, {"a"});
  EXPECT_EQ(labels(graph), (std::vector<std::string>{"toy-z: b", "toy-z: a"}));
  EXPECT_TRUE(graph.fields()[static_cast<std::size_t>(graph.field("a"))].carried);
}

TEST(Order, TwoWritersOfOneFieldAreRefused) {
  const Toys toys = Toys(2).add<ToyOf<'y', Scale<a, f::depth>>>().add<ToyOf<'z', Scale<a, f::depth>>>();
  EXPECT_EQ(complaints(toys, {"depth"}, {"a"}),
            (std::vector<std::string>{"two writers of the field \"a\": toy-y: a and toy-z: a; only fields that "
                                      "accumulate, such as acceleration, may have several"}));
}

TEST(Order, AFieldThatNobodyWritesIsRefusedWithItsReader) {
  const Toys toys = Toys(2).add<ToyOf<'y', Scale<b, a>>>();
  EXPECT_EQ(complaints(toys, {}, {"b"}),
            (std::vector<std::string>{
                "toy-y: b reads the field \"a\" [1], which no plugin writes and [initial] does not give"}));
}

TEST(Order, ACircleIsRefusedWithAllItsPasses) {
  const Toys toys =
      Toys(2).add<ToyOf<'x', Scale<a, c>>>().add<ToyOf<'y', Scale<b, a>>>().add<ToyOf<'z', Scale<c, b>>>();
  EXPECT_EQ(complaints(toys, {}, {"c"}),
            (std::vector<std::string>{"these passes wait for each other in a circle: toy-x: a, toy-y: b, toy-z: c; one "
                                      "of them must read the previous value, or they must be declared as an "
                                      "iteration"}));
}

TEST(Order, OneNameWithTwoUnitsOrShapesIsRefused) {
  const std::vector<std::string> units = complaints(
      Toys(2).add<ToyOf<'y', Scale<a, f::depth>>>().add<ToyOf<'z', Scale<b, a_in_metres>>>(), {"depth"}, {"b"});
  EXPECT_EQ(units, (std::vector<std::string>{"toy-z: its field \"a\" [m] differs in shape or unit from that of toy-y "
                                             "[1]; two plugins that share a field name must agree"}));
  const std::vector<std::string> shapes =
      complaints(Toys(2).add<ToyOf<'y', Scale<a, f::depth>>>().add<ToyOf<'z', Scale<b, a_vector>>>(), {"depth"}, {"b"});
  ASSERT_EQ(shapes.size(), 1u);
}

struct Evolving : ToyOf<'e', Scale<f::density, f::depth>> {
  using ToyOf::ToyOf;
  static constexpr riffle_evolved evolved[] = {evolved_field(f::density, f::density_rate)};
};

TEST(Order, AllContradictionsAreToldAtOnce) {
  const auto lines = complaints(Toys(2).add<Evolving>(), {"depth"}, {});
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], "the field \"density\" is advanced in time and must not also be written by toy-e: density");
  EXPECT_EQ(lines[1], "the field \"density\" is advanced in time, but no plugin writes its rate \"density_rate\"");
  EXPECT_EQ(lines[2],
            "the field \"density\" is advanced in time, but neither [initial] nor a pass gives its initial value");
}

using Deep = ToyOf<'d', Reduce<a, RIFFLE_AT_I, f::kernel>>;

TEST(Order, TheKernelAndTheSmoothingLengthMustComeFromSomewhere) {
  EXPECT_EQ(
      complaints(Toys(2).add<Deep>(), {"smoothing_length"}, {"a"}),
      (std::vector<std::string>{"toy-d: a looks at neighbours, but the case names no plugin of kind kernel, whose "
                                "support says which"}));
  EXPECT_EQ(complaints(Toys(2).add<ToyKernel>().add<Deep>(), {}, {"a"}),
            (std::vector<std::string>{"toy-d: a uses \"kernel\", which needs the field \"smoothing_length\"; no plugin "
                                      "writes it and [initial] does not give it"}));
  EXPECT_EQ(complaints(Toys(2).add<ToyKernel>().add<ToyOf<'n', Reduce<a, RIFFLE_PAIR, f::distance>>>(), {}, {"a"}),
            (std::vector<std::string>{"toy-n: a looks at neighbours as far as the field \"smoothing_length\" says; no "
                                      "plugin writes it and [initial] does not give it"}));
}

}  // namespace
}  // namespace riffle::test
