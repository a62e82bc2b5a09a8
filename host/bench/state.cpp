#include "host/bench/state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace riffle::bench {

namespace {

class Random {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  std::uint64_t below(std::uint64_t n) { return engine_() % n; }

 private:
  std::mt19937_64 engine_{20240607};
};

void place(BenchState& state, std::int64_t along, Random& random) {
  const double spacing = 1.0 / static_cast<double>(along);
  for (std::int64_t k = 0; k < state.particles; ++k) {
    const auto column = static_cast<double>(k % along), row = static_cast<double>(k / along);
    state.x.push_back((column + 0.5 + random(-0.2, 0.2)) * spacing);
    state.z.push_back((row + 0.5 + random(-0.2, 0.2)) * spacing);
  }
  for (std::size_t k = state.x.size(); k-- > 1;) {
    const std::size_t other = random.below(k + 1);
    std::swap(state.x[k], state.x[other]);
    std::swap(state.z[k], state.z[other]);
  }
}

void sort_by_cell(BenchState& state) {
  state.cells_along = static_cast<std::int64_t>(1 / state.physics.support());
  const auto along = static_cast<double>(state.cells_along);
  std::vector<std::int64_t> cell(state.x.size()), order(state.x.size());
  for (std::size_t k = 0; k < cell.size(); ++k) {
    cell[k] = static_cast<std::int64_t>(state.z[k] * along) * state.cells_along +
              static_cast<std::int64_t>(state.x[k] * along);
  }
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
    return cell[static_cast<std::size_t>(a)] < cell[static_cast<std::size_t>(b)];
  });
  state.cell_begin.assign(static_cast<std::size_t>(state.cells_along * state.cells_along) + 1, 0);
  for (const std::int64_t c : cell) ++state.cell_begin[static_cast<std::size_t>(c) + 1];
  std::partial_sum(state.cell_begin.begin(), state.cell_begin.end(), state.cell_begin.begin());
  for (auto* field : {&state.x, &state.z}) {
    const std::vector<double> old(*field);
    for (std::size_t k = 0; k < order.size(); ++k) (*field)[k] = old[static_cast<std::size_t>(order[k])];
  }
}

void fill(BenchState& state, double spacing, Random& random) {
  constexpr double pi = std::numbers::pi;
  const Physics& physics = state.physics;
  for (std::size_t k = 0; k < state.x.size(); ++k) {
    const double x = state.x[k], z = state.z[k];
    state.u.push_back(std::sin(pi * x) * std::cos(pi * z) + random(-0.05, 0.05));
    state.w.push_back(-std::cos(pi * x) * std::sin(pi * z) + random(-0.05, 0.05));
    state.density.push_back(physics.reference_density * (1 + 0.005 * random(-1, 1)));
    state.pressure.push_back(physics.sound_speed * physics.sound_speed *
                             (state.density[k] - physics.reference_density));
    state.mass.push_back(physics.reference_density * spacing * spacing * random(0.9, 1.1));
  }
}

}  // namespace

double Physics::kernel_factor() const {
  const double h2 = smoothing_length * smoothing_length;
  return -5 * 7 / (4 * std::numbers::pi * h2 * h2);
}

BenchRates::BenchRates(std::int64_t particles)
    : acceleration_x(static_cast<std::size_t>(particles)),
      acceleration_z(static_cast<std::size_t>(particles)),
      density_rate(static_cast<std::size_t>(particles)) {}

BenchState make_state(std::int64_t along, double skin) {
  BenchState state;
  Random random;
  const double spacing = 1.0 / static_cast<double>(along);
  state.particles = along * along;
  state.physics.smoothing_length = 1.41 * spacing;
  place(state, along, random);
  sort_by_cell(state);
  fill(state, spacing, random);

  ParticleView view;
  view.dim = 2;
  view.owned = view.all = state.particles;
  view.x[0] = state.x.data();
  view.x[1] = state.z.data();
  view.uniform_l = state.physics.smoothing_length;
  build(view, 2, 0, {}, state.list);
  state.true_pairs = state.list.pairs;
  if (skin > 0) build(view, 2, skin, {}, state.list);
  return state;
}

double relative_difference(const BenchRates& a, const BenchRates& b) {
  const auto of = [](const std::vector<double>& p, const std::vector<double>& q) {
    double difference = 0, norm = 0;
    for (std::size_t k = 0; k < p.size(); ++k) {
      difference += (p[k] - q[k]) * (p[k] - q[k]);
      norm += q[k] * q[k];
    }
    return std::sqrt(difference / norm);
  };
  return std::max({of(a.acceleration_x, b.acceleration_x), of(a.acceleration_z, b.acceleration_z),
                   of(a.density_rate, b.density_rate)});
}

}  // namespace riffle::bench
