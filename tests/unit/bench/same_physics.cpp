// All sides of the benchmark compute the same thing, or their times mean nothing. The reference is the formulas of
// state.hpp over all pairs of particles, with nothing shared and nothing clever.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/bench/fused_best.hpp"
#include "host/bench/fused_cells.hpp"

namespace riffle::bench {

namespace {

constexpr double tolerance = 1e-12;  // round-off of sums of some twenty terms, with room for other orders of summation

BenchRates reference(const BenchState& s) {
  const Physics& p = s.physics;
  const double h = p.smoothing_length;
  BenchRates rates(s.particles);
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    for (std::size_t j = 0; j < s.x.size(); ++j) {
      const double dx = s.x[i] - s.x[j], dz = s.z[i] - s.z[j], r = std::hypot(dx, dz);
      if (i == j || r >= 2 * h) continue;
      const double q = r / h;
      // W = 7 / (4 pi h^2) (1 - q/2)^4 (2 q + 1)
      const double f = 7 / (4 * std::numbers::pi * h * h) * -5 * q * std::pow(1 - q / 2, 3) / h / r;
      const double vx = (s.u[i] - s.u[j]) * dx + (s.w[i] - s.w[j]) * dz;
      const double pi = vx < 0 ? -p.alpha * p.sound_speed * h * vx / (r * r + p.eta2()) : 0;
      const double volume = s.mass[j] / s.density[j];
      const double push = (s.pressure[i] + s.pressure[j] + p.reference_density * pi) / s.density[i];
      rates.acceleration_x[i] -= volume * push * f * dx;
      rates.acceleration_z[i] -= volume * push * f * dz;
      rates.density_rate[i] += s.density[i] * volume * f * vx;
      rates.density_rate[i] -= 2 * p.delta * h * p.sound_speed * volume * (s.density[j] - s.density[i]) * f;
    }
  }
  return rates;
}

BenchRates by_cells(const BenchState& state) {
  BenchRates rates(state.particles);
  FusedCells side(state);
  side(rates);
  return rates;
}

BenchRates by_best(const BenchState& state) {
  BenchRates rates(state.particles);
  FusedBest side(state);
  side(rates);
  return rates;
}

TEST(FusedCells, ComputesTheFormulas) {
  const BenchState state = make_state(40, 0);
  EXPECT_LT(relative_difference(by_cells(state), reference(state)), tolerance);
}

TEST(FusedBest, ComputesTheFormulasWithAndWithoutSkin) {
  for (const double skin : {0.0, 0.1}) {
    const BenchState state = make_state(40, skin);
    EXPECT_LT(relative_difference(by_best(state), reference(state)), tolerance) << "skin " << skin;
  }
}

TEST(FusedCellsAndFusedBest, Agree) {
  const BenchState state = make_state(120, 0.1);
  EXPECT_LT(relative_difference(by_cells(state), by_best(state)), tolerance);
}

TEST(RelativeDifference, SeesASingleWrongRate) {
  const BenchState state = make_state(40, 0);
  const BenchRates right = reference(state);
  BenchRates wrong = right;
  wrong.density_rate[700] *= 1 + 1e-6;
  EXPECT_GT(relative_difference(wrong, right), tolerance);
}

TEST(Physics, MovesDensityFromDenseToThin) {
  BenchState state = make_state(40, 0);
  std::fill(state.u.begin(), state.u.end(), 0);
  std::fill(state.w.begin(), state.w.end(), 0);
  const BenchRates rates = by_best(state);
  double growth = 0;  // of the variance of density, up to a factor
  for (std::size_t i = 0; i < state.density.size(); ++i) {
    growth += rates.density_rate[i] * (state.density[i] - state.physics.reference_density);
  }
  EXPECT_LT(growth, 0);
}

TEST(Physics, ViscosityDissipatesKineticEnergy) {
  BenchState state = make_state(40, 0);
  const BenchRates with = by_best(state);
  state.physics.alpha = 0;
  const BenchRates without = by_best(state);
  double power = 0;
  for (std::size_t i = 0; i < state.mass.size(); ++i) {
    power += state.mass[i] * (state.u[i] * (with.acceleration_x[i] - without.acceleration_x[i]) +
                              state.w[i] * (with.acceleration_z[i] - without.acceleration_z[i]));
  }
  EXPECT_LT(power, 0);
}

TEST(Scene, IsDisorderedWithAboutTwentyTwoNeighbours) {
  const BenchState state = make_state(200, 0.1);
  EXPECT_NEAR(static_cast<double>(state.true_pairs) / static_cast<double>(state.particles), 22.5, 0.6);
  EXPECT_GT(state.list.pairs, state.true_pairs);  // the skin's, which do not count
  const auto [fewest, most] = std::minmax_element(state.list.count.begin(), state.list.count.end());
  EXPECT_LT(*fewest, *most);
}

}  // namespace

}  // namespace riffle::bench
