// Attributes with one value for all particles are constant arrays that nobody gathers. A probe that nobody looks at, with
// values of its own, ends that short cut; the sums must not notice, to the last bit.
#include "tests/unit/schedule/world.hpp"

namespace riffle::test::uniform {
namespace {

constexpr riffle_field blend = scalar_field("blend", "1", "sum of all that can be read of a pair");
constexpr riffle_field absent = scalar_field("absent", "1", "what nobody provides");
constexpr riffle_field with_absent = scalar_field("with_absent", "1", "sum that would use it");

struct Blend {
  static constexpr auto pass_name = "blend";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr std::uint32_t pass_flags = RIFFLE_WITH_SELF;
  static constexpr riffle_read reads[] = {at_i(weight),
                                          at_j(weight),
                                          difference(weight),
                                          mean(weight),
                                          at_i(fields::kernel),
                                          at_j(fields::kernel),
                                          mean(fields::kernel),
                                          at_j(fields::smoothing_length),
                                          pair(fields::distance),
                                          mean(fields::smoothing_length),
                                          at_i(fields::kernel_gradient)};
  static constexpr riffle_write writes[] = {sum(blend)};
  template <class P>
  static void run(const P&, const Block& b) {
    RIFFLE_EACH(k, b) {
      b.out(0)[k] = b.in(0)[k] * b.in(4)[k] + b.in(1)[k] * b.in(5)[k] + (b.in(2)[k] + b.in(3)[k]) * b.in(6)[k] +
                    b.in(7)[k] * b.in(8)[k] - b.in(9)[k] * b.in(10)[k];
    }
  }
};

class Uniform : public testing::TestWithParam<int> {
 protected:
  // Sums of 300 particles whose weights and lengths are all alike; those of the probe are its own, or not.
  std::vector<double> sums(bool short_cut) const {
    WorldOptions options;
    options.dim = GetParam();
    options.per_role = {300, 0, 0, 0, 0, 1};
    options.given = {"weight"};
    options.wanted = {"blend"};
    options.uniform_length = true;
    World world(Toys(GetParam()).add<ToyKernel>().add<ToyOf<'u', Blend>>(), options);
    const std::int64_t probe = world.store.role_begin(5);
    for (std::int64_t i = 0; i < world.store.owned(); ++i) world.store.data("weight")[i] = 1.3;
    if (!short_cut) {
      world.store.data("weight")[probe] = 0.7;
      world.store.data("smoothing_length")[probe] *= 0.9;  // shorter: the search for neighbours goes by the longest
    }
    world.changed("weight");
    world.changed("smoothing_length");
    world.compute({"blend"});
    const double* values = world.store.data("blend");
    return {values, values + 300};
  }
};
INSTANTIATE_TEST_SUITE_P(Dimensions, Uniform, testing::Values(1, 2, 3));

TEST_P(Uniform, FieldsGiveTheSameBitsWithAndWithoutTheShortCut) {
  const std::vector<double> with = sums(true), without = sums(false);
  double largest = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_EQ(with[i], without[i]) << "particle " << i;
    largest = std::max(largest, std::abs(with[i]));
  }
  EXPECT_GT(largest, 0);
}

struct UsesAbsent {
  static constexpr auto pass_name = "with absent";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr riffle_read reads[] = {at_j(weight), at_j(absent, RIFFLE_OPTIONAL)};
  static constexpr riffle_write writes[] = {sum(with_absent)};
  template <class P>
  static void run(const P&, const Block& b) {
    const bool there = b.has(1);
    RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k] + (there ? b.in(1)[k] : 0);
  }
};

class Optional : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, Optional, testing::Values(1, 2, 3));

TEST_P(Optional, ReadsAreNullWhenNobodyProvidesTheField) {
  for (const bool provided : {false, true}) {
    WorldOptions options;
    options.dim = GetParam();
    options.given = provided ? std::vector<std::string>{"weight", "absent"} : std::vector<std::string>{"weight"};
    options.wanted = {"with_absent"};
    options.skin = 0;  // nothing here vanishes beyond the support
    World world(Toys(GetParam()).add<ToyKernel>().add<ToyOf<'o', UsesAbsent>>(), options);
    world.compute({"with_absent"});
    const double *w = world.store.data("weight"), *more = provided ? world.store.data("absent") : nullptr;
    expect_same_sums(world.values("with_absent"), brute_force_sum(world, gathered, [&](const FoundPair& p) {
                       return w[p.j] + (provided ? more[p.j] : 0);
                     }));
  }
}

}  // namespace
}  // namespace riffle::test::uniform
