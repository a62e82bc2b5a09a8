#include "host/neighbours/grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/neighbours/counting_sort.hpp"
#include "host/neighbours/view_checks.hpp"

namespace riffle {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_levels = 8;  // reaches below 1/128 of the largest share the last level

struct Reaches {
  double smallest = infinity, largest = 0;  // m

  void add(double low, double high) {
    smallest = std::min(smallest, low);
    largest = std::max(largest, high);
  }
};

Reaches range_of_reaches(const ParticleView& particles, std::uint32_t sources, double factor) {
  if (uniform_reach(particles)) return {factor * particles.uniform_l, factor * particles.uniform_l};
  const int parts = parts_for(particles.all);
  std::vector<Reaches> found(static_cast<std::size_t>(parts));
  for_parts(particles.all, parts, [&](int part, std::int64_t first, std::int64_t last) {
    Reaches range;
    for (std::int64_t i = first; i < last; ++i) {
      if (has_role(particles, sources, i)) range.add(factor * particles.l[i], factor * particles.l[i]);
    }
    found[static_cast<std::size_t>(part)] = range;
  });
  Reaches all;
  for (const Reaches& range : found) all.add(range.smallest, range.largest);
  return all;
}

// Level k holds reaches in (largest / 2^(k+1), largest / 2^k], the last one also all smaller ones.
struct LevelOf {
  double largest;
  int levels = 1;

  explicit LevelOf(const Reaches& range) : largest(range.largest) {
    while (largest > 0 && levels < most_levels && range.smallest <= std::ldexp(largest, -levels)) ++levels;
  }
  [[nodiscard]] int operator()(double reach) const {
    double bound = 0.5 * largest;
    int level = 0;
    while (level < levels - 1 && reach <= bound) {
      bound *= 0.5;
      ++level;
    }
    return level;
  }
};

// What is to be known of a level's sources before its cells can be laid out.
struct Extent {
  Box bounds;
  double radius = 0;
  std::int64_t sources = 0;

  Extent() {
    bounds.lower.fill(infinity);
    bounds.upper.fill(-infinity);
  }
  void add(const ParticleView& particles, std::int64_t i, double reach) {
    for (int d = 0; d < particles.dim; ++d) {
      const auto a = static_cast<std::size_t>(d);
      bounds.lower[a] = std::min(bounds.lower[a], particles.x[d][i]);
      bounds.upper[a] = std::max(bounds.upper[a], particles.x[d][i]);
    }
    radius = std::max(radius, reach);
    ++sources;
  }
  void add(const Extent& other) {
    for (std::size_t a = 0; a < 3; ++a) {
      bounds.lower[a] = std::min(bounds.lower[a], other.bounds.lower[a]);
      bounds.upper[a] = std::max(bounds.upper[a], other.bounds.upper[a]);
    }
    radius = std::max(radius, other.radius);
    sources += other.sources;
  }
};

std::vector<Extent> measure_levels(const ParticleView& particles, std::uint32_t sources, double factor,
                                   const LevelOf& level_of) {
  const int parts = parts_for(particles.all);
  const auto levels = static_cast<std::size_t>(level_of.levels);
  std::vector<Extent> found(static_cast<std::size_t>(parts) * levels);
  for_parts(particles.all, parts, [&](int part, std::int64_t first, std::int64_t last) {
    std::vector<Extent> own(levels);
    for (std::int64_t i = first; i < last; ++i) {
      if (!has_role(particles, sources, i)) continue;
      const double reach = factor * smoothing_length(particles, i);
      own[static_cast<std::size_t>(level_of(reach))].add(particles, i, reach);
    }
    std::copy(own.begin(), own.end(), found.begin() + static_cast<std::ptrdiff_t>(part) * level_of.levels);
  });
  std::vector<Extent> all(levels);
  for (std::size_t k = 0; k < found.size(); ++k) all[k % levels].add(found[k]);
  return all;
}

}  // namespace

void sort_into_cells(const ParticleView& particles, std::uint32_t sources, double factor, Grid& grid) {
  require_searchable(particles);
  const LevelOf level_of(range_of_reaches(particles, sources, factor));
  const std::vector<Extent> extents = measure_levels(particles, sources, factor, level_of);
  const auto level_of_source = [&](std::int64_t i) {
    return level_of.levels == 1 ? 0 : level_of(factor * smoothing_length(particles, i));
  };

  grid.levels.clear();
  std::array<std::size_t, most_levels> kept{};  // index of a level among those that have sources
  std::int64_t cells = 0;
  for (std::size_t k = 0; k < extents.size(); ++k) {
    const Extent& extent = extents[k];
    if (extent.sources == 0) continue;
    const auto member = [&](std::int64_t i) {
      return has_role(particles, sources, i) && level_of_source(i) == static_cast<int>(k);
    };
    kept[k] = grid.levels.size();
    GridLevel level;
    level.radius = extent.radius;
    level.cells = fit_cells(particles, extent.bounds, extent.sources, extent.radius, member);
    level.first_cell = cells;
    cells += level.cells.count();
    grid.levels.push_back(level);
  }

  grid.place.resize(static_cast<std::size_t>(particles.all));
  const int parts = parts_for(particles.all);
  for_parts(particles.all, parts, [&](int, std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i < last; ++i) {
      std::int64_t cell = -1;
      if (has_role(particles, sources, i)) {
        const GridLevel& level = grid.levels[kept[static_cast<std::size_t>(level_of_source(i))]];
        cell = level.first_cell + level.cells.at(particles, i);
      }
      grid.place[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(cell);
    }
  });
  places_by_counting(cells, grid.place, grid.begin, grid.histogram);

  const auto sorted = static_cast<std::size_t>(grid.begin.back());
  for (int d = 0; d < particles.dim; ++d) grid.x[d].resize(sorted + 8);
  grid.particle.resize(sorted + 8);
  grid.reach2.resize(uniform_reach(particles) ? 0 : sorted + 8);
  for_parts(particles.all, parts, [&](int, std::int64_t first, std::int64_t last) {
    for (std::int64_t i = first; i < last; ++i) {
      const std::int32_t place = grid.place[static_cast<std::size_t>(i)];
      if (place < 0) continue;
      const auto p = static_cast<std::size_t>(place);
      for (int d = 0; d < particles.dim; ++d) grid.x[d][p] = particles.x[d][i];
      grid.particle[p] = static_cast<std::int32_t>(i);
      if (!uniform_reach(particles)) grid.reach2[p] = (factor * particles.l[i]) * (factor * particles.l[i]);
    }
  });
}

}  // namespace riffle
