// Every kernel in every dimension against its contract. Integrals are taken piece by piece between multiples of 1/8 l,
// where kernels have their joints, by Gauss quadrature that is exact there: what remains is round-off, a few 1e-16 per
// piece and per term, so 1e-12 of the largest value is asked for (the contract says 1e-10).
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "tests/contract/kernel_case.hpp"

namespace riffle::contract {
namespace {

constexpr double round_off = 1e-12, step = 0.125;
constexpr double pi = 3.14159265358979323846;

class Kernel : public testing::TestWithParam<std::tuple<Loaded, int>> {
 protected:
  const riffle_plugin& plugin = *std::get<0>(GetParam()).plugin;
  const int dim = std::get<1>(GetParam());
  const KernelCase kernel{plugin, dim, {{"lattice_normalised", 0}}};
  const double support = kernel.about().support;
};

TEST_P(Kernel, IntegratesToOne) {
  const double shell = dim == 1 ? 2 : dim == 2 ? 2 * pi : 4 * pi;
  double sum = 0;
  for (double r = 0; r < support; r += step) {
    sum += integral([&](double x) { return shell * std::pow(x, dim - 1) * kernel(RIFFLE_W, x); }, r, r + step);
  }
  EXPECT_NEAR(sum, 1, round_off);
  EXPECT_EQ(kernel.about().integral, 1);
}

TEST_P(Kernel, FallsFromItsPeakToZero) {
  double last = kernel(RIFFLE_W, 0);
  EXPECT_TRUE(std::isfinite(kernel(RIFFLE_F, 0)));
  EXPECT_LT(kernel(RIFFLE_F, 0), 0);
  for (double r = 0.01; r < support; r += 0.01) {
    EXPECT_LE(kernel(RIFFLE_F, r), 0) << r;
    EXPECT_LT(kernel(RIFFLE_W, r), last) << r;
    EXPECT_GE(kernel(RIFFLE_W, r), 0) << r;
    last = kernel(RIFFLE_W, r);
  }
}

TEST_P(Kernel, IsExactlyZeroFromItsSupportOn) {
  for (const double l : {0.25, 1.0, 4.0}) {  // powers of two, so that r / l is exact
    for (const double factor : {1.0, 1.0 + 1e-15, 1.1, 2.0, 1e6}) {
      for (std::uint32_t bit = 1; bit <= RIFFLE_W_LL; bit <<= 1) {
        EXPECT_EQ(kernel(bit, factor * support * l, l), 0) << "output " << bit << " at " << factor << " supports";
      }
    }
  }
}

// Each derivative, integrated, must give back what it is the derivative of.
TEST_P(Kernel, HasDerivativesThatIntegrateToItself) {
  ASSERT_EQ(kernel.about().provides, (1u << RIFFLE_KERNEL_OUTPUTS) - 1);
  const double peak = kernel(RIFFLE_W, 0);
  const auto slope = [&](double r, double l) { return r * kernel(RIFFLE_F, r, l); };
  for (double q = 0; q < support; q += step) {
    const double r = q + step;
    EXPECT_NEAR(kernel(RIFFLE_W, r) - kernel(RIFFLE_W, q), integral([&](double x) { return slope(x, 1); }, q, r),
                round_off * peak);
    EXPECT_NEAR(slope(r, 1) - slope(q, 1), integral([&](double x) { return kernel(RIFFLE_W_RR, x); }, q, r),
                round_off * peak);
    if (q == 0) continue;
    const double near = 1 / r, far = 1 / q;  // smoothing lengths that carry q over the same piece at distance 1
    EXPECT_NEAR(kernel(RIFFLE_W, 1, far) - kernel(RIFFLE_W, 1, near),
                integral([&](double l) { return kernel(RIFFLE_W_L, 1, l); }, near, far), round_off * peak);
    EXPECT_NEAR(slope(1, far) - slope(1, near),
                integral([&](double l) { return kernel(RIFFLE_W_RL, 1, l); }, near, far), 10 * round_off * peak);
    EXPECT_NEAR(kernel(RIFFLE_W_L, 1, far) - kernel(RIFFLE_W_L, 1, near),
                integral([&](double l) { return kernel(RIFFLE_W_LL, 1, l); }, near, far), 10 * round_off * peak);
  }
}

TEST_P(Kernel, ScalesWithItsSmoothingLength) {
  const std::vector<std::pair<std::uint32_t, int>> powers{{RIFFLE_W, 0},    {RIFFLE_F, 2},    {RIFFLE_W_L, 1},
                                                          {RIFFLE_W_RR, 2}, {RIFFLE_W_RL, 2}, {RIFFLE_W_LL, 2}};
  for (const auto& [output, power] : powers) {
    for (const double q : {0.0, 0.3, 0.9, 1.7}) {
      const double expected = kernel(output, q) * std::pow(0.25, dim + power);
      EXPECT_NEAR(kernel(output, 4 * q, 4), expected, 1e-15 * std::abs(expected)) << "output " << output;
    }
  }
}

using Outputs = std::vector<std::vector<double>>;  // one array per output, untouched where it holds `untouched`
constexpr double untouched = 7e77;

// Evaluates pairs [first, first + count) of 64 made-up ones, some beyond the support.
void evaluate(const Instance& kernel, std::uint32_t want, std::size_t first, std::size_t count, Outputs& to) {
  std::vector<double> r(count), inverse_l(count);
  for (std::size_t k = 0; k < count; ++k) {
    r[k] = 0.07 * static_cast<double>(((first + k) * 37) % 64);
    inverse_l[k] = 0.5 + 0.01 * static_cast<double>(((first + k) * 23) % 64);
  }
  std::vector<double*> out;
  for (auto& array : to) out.push_back(array.data() + first);
  kernel.table().evaluate_kernel(kernel.self(), static_cast<std::int64_t>(count), r.data(), inverse_l.data(), want,
                                 out.data());
}
Outputs nothing() {
  return Outputs(RIFFLE_KERNEL_OUTPUTS, std::vector<double>(72, untouched));
}

// The host pads blocks to multiples of four pairs, so that loops have no remainder.
TEST_P(Kernel, GivesTheSameBitsInAnyBlock) {
  for (const std::uint32_t want : {1u, 2u, 3u, 4u, 8u, 16u, 32u, 63u}) {
    Outputs whole = nothing(), parts = nothing();
    evaluate(kernel.instance(), want, 0, 64, whole);
    for (std::size_t first = 0, count = 4; first < 64; first += count, count += 4) {
      evaluate(kernel.instance(), want, first, std::min<std::size_t>(count, 64 - first), parts);
    }
    for (std::size_t b = 0; b < whole.size(); ++b)
      EXPECT_TRUE(whole[b] == parts[b]) << "output " << b << " of " << want;
  }
}

TEST_P(Kernel, WritesWhatIsWantedForAnyNumberOfPairsAndNothingElse) {
  for (const std::uint32_t want : {1u, 2u, 3u, 4u, 8u, 16u, 32u, 63u}) {
    for (const std::size_t count : {1u, 3u, 4u, 7u, 61u, 64u}) {
      Outputs out = nothing();
      evaluate(kernel.instance(), want, 0, count, out);
      for (std::size_t b = 0; b < out.size(); ++b) {
        const std::size_t written = ((want >> b) & 1u) != 0 ? count : 0;
        for (std::size_t k = 0; k < out[b].size(); ++k) {
          ASSERT_EQ(out[b][k] != untouched, k < written) << "output " << b << " at " << k << " of " << count;
        }
      }
    }
  }
}

// Sums over up to 21^3 points: round-off of a few 1e-15.
TEST_P(Kernel, SumsToOneOverItsLatticeWhenNormalisedThere) {
  for (const double ratio : {0.6, 1.0, 1.2, 1.3, 1.5, 2.0}) {
    const KernelCase normalised(plugin, dim, {{"lattice_normalised", 1}, {"smoothing_ratio", ratio}});
    const double l = 0.02, spacing = l / ratio;
    const int reach = static_cast<int>(std::ceil(support * ratio)), y = dim > 1 ? reach : 0, z = dim > 2 ? reach : 0;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
      for (int j = -y; j <= y; ++j) {
        for (int k = -z; k <= z; ++k) sum += normalised(RIFFLE_W, spacing * std::sqrt(i * i + j * j + k * k), l);
      }
    }
    EXPECT_NEAR(sum * std::pow(spacing, dim), 1, 1e-13) << "ratio " << ratio;
    EXPECT_NEAR(normalised(RIFFLE_W, 0), normalised.about().integral * kernel(RIFFLE_W, 0), 1e-14);
  }
}

std::string name_of(const testing::TestParamInfo<std::tuple<Loaded, int>>& info) {
  return test_name(std::get<0>(info.param)) + "_in_" + std::to_string(std::get<1>(info.param)) + "d";
}
INSTANTIATE_TEST_SUITE_P(Contract, Kernel,
                         testing::Combine(testing::ValuesIn(plugins_of("kernel")), testing::Values(1, 2, 3)), name_of);

}  // namespace
}  // namespace riffle::contract
