// Kernel outputs on request: a pass names which it reads and with whose smoothing length; only those are computed.
#include <set>

#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

constexpr const riffle_field* outputs[] = {&fields::kernel,     &fields::kernel_gradient, &fields::kernel_dl,
                                           &fields::kernel_drr, &fields::kernel_drdl,     &fields::kernel_dldl};

// The sum over neighbours of one output, evaluated at one place.
template <int Bit, std::uint32_t Where>
struct Sum {
  static constexpr char pass_name[] = {'s', 'u', 'm', '_', 'a' + Bit, '_', 'a' + static_cast<char>(Where), 0};
  static constexpr riffle_field field = scalar_field(pass_name, "1", "sum of a kernel output");
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr std::uint32_t neighbours = RIFFLE_EITHER;
  static constexpr riffle_read reads[] = {{sizeof(riffle_read), Where, 0, 0, outputs[Bit]}};
  static constexpr riffle_write writes[] = {sum(field)};
  template <class P>
  static void run(const P&, const Block& b) {
    RIFFLE_EACH(k, b) b.out(0)[k] = b.in(0)[k];
  }
};

template <std::uint32_t Where>
struct Six;
template <>
struct Six<RIFFLE_AT_I> : ToyOf<'i', Sum<0, RIFFLE_AT_I>, Sum<1, RIFFLE_AT_I>, Sum<2, RIFFLE_AT_I>, Sum<3, RIFFLE_AT_I>,
                                Sum<4, RIFFLE_AT_I>, Sum<5, RIFFLE_AT_I>> {
  using ToyOf::ToyOf;
};
template <>
struct Six<RIFFLE_AT_J> : ToyOf<'j', Sum<0, RIFFLE_AT_J>, Sum<1, RIFFLE_AT_J>, Sum<2, RIFFLE_AT_J>, Sum<3, RIFFLE_AT_J>,
                                Sum<4, RIFFLE_AT_J>, Sum<5, RIFFLE_AT_J>> {
  using ToyOf::ToyOf;
};
template <>
struct Six<RIFFLE_MEAN> : ToyOf<'m', Sum<0, RIFFLE_MEAN>, Sum<1, RIFFLE_MEAN>, Sum<2, RIFFLE_MEAN>, Sum<3, RIFFLE_MEAN>,
                                Sum<4, RIFFLE_MEAN>, Sum<5, RIFFLE_MEAN>> {
  using ToyOf::ToyOf;
};

std::vector<std::string> names(std::uint32_t where) {
  std::vector<std::string> all;
  for (int bit = 0; bit < RIFFLE_KERNEL_OUTPUTS; ++bit)
    all.push_back(std::string("sum_") + static_cast<char>('a' + bit) + "_" + static_cast<char>('a' + where));
  return all;
}

class KernelOutputs : public testing::TestWithParam<int> {};

TEST_P(KernelOutputs, AllSixWithLengthOfTheParticleOfTheNeighbourAndTheirMean) {
  WorldOptions options;
  options.dim = GetParam();
  std::vector<std::string> all;
  for (const std::uint32_t where : {RIFFLE_AT_I, RIFFLE_AT_J, RIFFLE_MEAN}) {
    for (const auto& name : names(where)) all.push_back(name);
  }
  options.wanted = all;
  World world(
      Toys(options.dim).add<ToyKernel>().add<Six<RIFFLE_AT_I>>().add<Six<RIFFLE_AT_J>>().add<Six<RIFFLE_MEAN>>(),
      options);
  world.compute(all);

  const NeighbourRequest either{Reach::either, gathered.targets, gathered.sources};
  const double* l = world.store.data("smoothing_length");
  for (int bit = 0; bit < RIFFLE_KERNEL_OUTPUTS; ++bit) {
    for (const std::uint32_t where : {RIFFLE_AT_I, RIFFLE_AT_J, RIFFLE_MEAN}) {
      const std::string name = names(where)[static_cast<std::size_t>(bit)];
      SCOPED_TRACE(name);
      expect_same_sums(world.values(name), brute_force_sum(world, either, [&](const FoundPair& pair) {
                         const double length = where == RIFFLE_AT_I   ? l[pair.i]
                                               : where == RIFFLE_AT_J ? l[pair.j]
                                                                      : 0.5 * (l[pair.i] + l[pair.j]);
                         return world.kernel_value(bit, pair.r, length);
                       }));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, KernelOutputs, testing::Values(1, 2, 3));

// A kernel that keeps a list of what it was asked for.
std::set<std::uint32_t> asked;
struct ListeningKernel : RadialKernel<ToyKernel> {
  using RadialKernel::RadialKernel;
  static constexpr auto id = "listening", kind = "kernel", version = "1.0.0", summary = "a kernel", source = "";
  void evaluate(std::int64_t n, const double* r, const double* inverse_l, std::uint32_t want,
                double* const* out) const {
    asked.insert(want);
    RadialKernel::evaluate(n, r, inverse_l, want, out);
  }
};

struct Asks : ToyOf<'a', Sum<1, RIFFLE_AT_I>, Sum<4, RIFFLE_AT_I>, Sum<0, RIFFLE_AT_J>> {
  using ToyOf::ToyOf;
};

TEST(KernelOutputs, OnlyThoseAreComputedThatAPassReads) {
  WorldOptions options;
  options.wanted = {"sum_b_a", "sum_e_a", "sum_a_b"};
  options.runner.chunk = 1 << 20;  // one chunk, so one thread: the set needs no lock
  World world(Toys(2).add<ListeningKernel>().add<Asks>(), options);
  asked.clear();
  world.compute(options.wanted);
  EXPECT_EQ(asked, (std::set<std::uint32_t>{RIFFLE_F | RIFFLE_W_RL, RIFFLE_W}));
}

TEST(KernelOutputs, WithOneLengthForAllTheThreePlacesAreOneCall) {
  WorldOptions options;
  options.wanted = {"sum_b_a", "sum_e_a", "sum_a_b"};
  options.uniform_length = true;
  options.runner.chunk = 1 << 20;
  World world(Toys(2).add<ListeningKernel>().add<Asks>(), options);
  asked.clear();
  world.compute(options.wanted);
  EXPECT_EQ(asked, (std::set<std::uint32_t>{RIFFLE_W | RIFFLE_F | RIFFLE_W_RL}));
}

struct PlainKernel : ToyKernel {  // hides what the base provides
  using ToyKernel::ToyKernel;
  static constexpr auto id = "plain";
  [[nodiscard]] riffle_kernel describe() const { return {sizeof(riffle_kernel), RIFFLE_W | RIFFLE_F, support, 1}; }
};

TEST(KernelOutputs, AKernelThatCannotGiveOneIsRefusedWithBothNames) {
  WorldOptions options;
  options.wanted = {"sum_b_a", "sum_e_a", "sum_a_b"};
  try {
    World world(Toys(2).add<PlainKernel>().add<Asks>(), options);
    FAIL() << "nobody complained";
  } catch (const ScheduleError& error) {
    ASSERT_EQ(error.lines().size(), 1u);
    EXPECT_EQ(error.lines()[0], "toy-a: sum_e_a uses \"kernel_drdl\", which the kernel \"plain\" does not give");
  }
}

}  // namespace
}  // namespace riffle::test
