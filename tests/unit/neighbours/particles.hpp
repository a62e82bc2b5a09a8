// Particle sets for the tests of the neighbour search, and the plain double loop that it is compared with.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "host/neighbours/neighbours.hpp"

namespace riffle::test {

enum class Lengths { uniform, gentle, strong };  // smoothing lengths: one; +-30 %; over two decades

struct Particles {
  int dim = 1;
  std::int64_t owned = 0;
  std::vector<double> x[3], l;  // l empty: uniform
  std::vector<std::uint8_t> role;
  double uniform_l = 0;

  [[nodiscard]] std::int64_t all() const { return static_cast<std::int64_t>(x[0].size()); }
  [[nodiscard]] ParticleView view() const {
    ParticleView v;
    v.dim = dim;
    v.owned = owned;
    v.all = all();
    for (int d = 0; d < dim; ++d) v.x[d] = x[d].data();
    v.l = l.empty() ? nullptr : l.data();
    v.uniform_l = uniform_l;
    v.role = role.empty() ? nullptr : role.data();
    return v;
  }
};

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

// `owned` particles at random places of the unit interval, square or cube with about `neighbours` neighbours each, a
// third of them with role 1 and some with role 5, and images beyond two opposite sides. In no particular order.
inline Particles random_particles(int dim, std::int64_t owned, double neighbours, Lengths lengths, std::uint64_t seed) {
  Particles p;
  Random random(seed);
  p.dim = dim;
  p.owned = owned;
  const double per_volume = static_cast<double>(owned);
  const double ball[] = {0, 2, 3.14159265358979, 4.18879020478639};
  p.uniform_l = std::pow(neighbours / per_volume / ball[dim], 1.0 / dim) / 2;  // kappa = 2
  const std::int64_t all = owned + owned / 8;
  for (std::int64_t i = 0; i < all; ++i) {
    for (int d = 0; d < dim; ++d) {
      const bool image = i >= owned && d == 0;
      const double beyond = random(0, 0.1);
      p.x[d].push_back(image ? (i % 2 == 0 ? -beyond : 1 + beyond) : random(0, 1));
    }
    const std::int64_t tenth = 10 * (i < owned ? i : i - owned) / (i < owned ? owned : all - owned);
    p.role.push_back(tenth < 6 ? 0 : (tenth < 9 ? 1 : 5));
    if (lengths == Lengths::gentle) p.l.push_back(p.uniform_l * random(0.7, 1.3));
    if (lengths == Lengths::strong) p.l.push_back(p.uniform_l * std::pow(10, random(-1.5, 0.5)));
  }
  return p;
}

// Neighbours of i in ascending order, by trying all particles.
inline std::vector<std::int32_t> plain_neighbours(const ParticleView& p, double factor, const NeighbourRequest& request,
                                                  std::int64_t i) {
  const auto role = [&](std::int64_t k) { return p.role == nullptr ? 0u : p.role[k]; };
  const auto reach = [&](std::int64_t k) { return factor * (p.l == nullptr ? p.uniform_l : p.l[k]); };
  std::vector<std::int32_t> found;
  if ((request.targets >> role(i) & 1u) == 0) return found;
  for (std::int64_t j = 0; j < p.all; ++j) {
    if (j == i || (request.sources >> role(j) & 1u) == 0) continue;
    double r2 = 0;
    for (int d = 0; d < p.dim; ++d) r2 += (p.x[d][i] - p.x[d][j]) * (p.x[d][i] - p.x[d][j]);
    double limit = reach(i);
    if (request.reach == Reach::scatter) limit = reach(j);
    if (request.reach == Reach::either) limit = std::max(reach(i), reach(j));
    if (r2 < limit * limit) found.push_back(static_cast<std::int32_t>(j));
  }
  return found;
}

// Neighbours of i in a list, in ascending order.
inline std::vector<std::int32_t> listed_neighbours(const NeighbourList& list, std::int64_t i) {
  const auto k = static_cast<std::size_t>(i);
  const std::int32_t* first = list.neighbour.data() + list.begin[k];
  std::vector<std::int32_t> found(first, first + list.count[k]);
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace riffle::test
