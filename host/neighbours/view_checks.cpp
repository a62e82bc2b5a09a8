#include "host/neighbours/view_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "host/neighbours/counting_sort.hpp"

namespace riffle {

std::string name_of(const ParticleView& particles, std::int64_t i) {
  std::string place;
  for (int d = 0; d < particles.dim; ++d) place += fmt::format("{}{:.6g}", d == 0 ? "" : ", ", particles.x[d][i]);
  return fmt::format("{} {} at ({})", i < particles.owned ? "particle" : "image particle", i, place);
}

namespace {

bool searchable(const ParticleView& particles) {
  const int parts = parts_for(particles.all);
  std::vector<std::uint8_t> good(static_cast<std::size_t>(parts));
  for_parts(particles.all, parts, [&](int part, std::int64_t first, std::int64_t last) {
    // x - x is 0 for finite numbers only, and sums of NaN stay NaN
    double sum = 0;
    for (int d = 0; d < particles.dim; ++d) {
      const double* x = particles.x[d];
#pragma omp simd reduction(+ : sum)
      for (std::int64_t i = first; i < last; ++i) sum += x[i] - x[i];
    }
    if (!uniform_reach(particles)) {
      const double* l = particles.l;
#pragma omp simd reduction(+ : sum)
      for (std::int64_t i = first; i < last; ++i) sum += (l[i] - l[i]) + (l[i] < 0 ? 1.0 : 0.0);
    } else {
      sum += (particles.uniform_l - particles.uniform_l) + (particles.uniform_l < 0 ? 1.0 : 0.0);
    }
    good[static_cast<std::size_t>(part)] = sum == 0 ? 1 : 0;
  });
  return std::all_of(good.begin(), good.end(), [](std::uint8_t g) { return g == 1; });
}

void throw_first_unsearchable(const ParticleView& particles) {
  for (std::int64_t i = 0; i < particles.all; ++i) {
    for (int d = 0; d < particles.dim; ++d) {
      if (!std::isfinite(particles.x[d][i])) {
        throw std::runtime_error(name_of(particles, i) + ": the position is not a finite number");
      }
    }
    const double l = smoothing_length(particles, i);
    if (!std::isfinite(l) || l < 0) {
      throw std::runtime_error(fmt::format("{}: the smoothing length is {} m, it must be finite and not negative",
                                           name_of(particles, i), l));
    }
  }
}

}  // namespace

void require_searchable(const ParticleView& particles) {
  if (!searchable(particles)) throw_first_unsearchable(particles);
}

void throw_too_many_neighbours(const ParticleView& particles, std::int64_t i) {
  throw std::runtime_error(
      fmt::format("{} has more than {} neighbours: its support (smoothing length {:.6g} m) is too "
                  "large for the particle spacing there",
                  name_of(particles, i), longest_segment, smoothing_length(particles, i)));
}

}  // namespace riffle
