#include <algorithm>
#include <cassert>
#include <numeric>

#include "host/neighbours/cells.hpp"
#include "host/neighbours/counting_sort.hpp"
#include "host/neighbours/view_checks.hpp"

namespace riffle {

namespace {

// Places where the role changes: [0, ..., owned].
std::vector<std::int64_t> role_groups(const ParticleView& particles) {
  std::vector<std::int64_t> group{0};
  for (std::int64_t i = 1; i < particles.owned && particles.role != nullptr; ++i) {
    if (particles.role[i] != particles.role[i - 1]) group.push_back(i);
  }
  group.push_back(particles.owned);
  return group;
}

std::vector<std::int64_t> order_along_line(const ParticleView& particles, const std::vector<std::int64_t>& group) {
  std::vector<std::int64_t> order(static_cast<std::size_t>(particles.owned));
  std::iota(order.begin(), order.end(), 0);
  const double* x = particles.x[0];
  for (std::size_t g = 0; g + 1 < group.size(); ++g) {
    std::stable_sort(order.begin() + group[g], order.begin() + group[g + 1],
                     [x](std::int64_t a, std::int64_t b) { return x[a] < x[b]; });
  }
  return order;
}

}  // namespace

std::vector<std::int64_t> cell_order(const ParticleView& particles, double cell_size) {
  assert(particles.dim >= 1 && particles.dim <= 3 && cell_size > 0);
  require_searchable(particles);
  const std::vector<std::int64_t> group = role_groups(particles);
  if (particles.dim == 1) return order_along_line(particles, group);
  if (particles.owned == 0) return {};

  Box bounds;
  for (int d = 0; d < particles.dim; ++d) {
    const auto a = static_cast<std::size_t>(d);
    const auto [lower, upper] = std::minmax_element(particles.x[d], particles.x[d] + particles.owned);
    bounds.lower[a] = *lower;
    bounds.upper[a] = *upper;
  }
  const Cells cells =
      fit_cells(particles, bounds, particles.owned, cell_size, [&](std::int64_t i) { return i < particles.owned; });
  std::vector<std::int32_t> place(static_cast<std::size_t>(particles.owned)), begin, histogram;
  for (std::size_t g = 0; g + 1 < group.size(); ++g) {
    const std::int64_t first_cell = static_cast<std::int64_t>(g) * cells.count();
    for_parts(group[g + 1] - group[g], parts_for(group[g + 1] - group[g]),
              [&](int, std::int64_t first, std::int64_t last) {
                for (std::int64_t i = group[g] + first; i < group[g] + last; ++i) {
                  place[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(first_cell + cells.at(particles, i));
                }
              });
  }
  places_by_counting(static_cast<std::int64_t>(group.size() - 1) * cells.count(), place, begin, histogram);
  std::vector<std::int64_t> order(place.size());
  for (std::size_t i = 0; i < place.size(); ++i) {
    order[static_cast<std::size_t>(place[i])] = static_cast<std::int64_t>(i);
  }
  return order;
}

}  // namespace riffle
