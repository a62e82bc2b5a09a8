#include "host/particles/placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "host/particles/equal_water.hpp"
#include "host/particles/quantiles.hpp"
#include "host/particles/water.hpp"

namespace riffle {
namespace {

constexpr double largest_number = std::numeric_limits<std::int32_t>::max();  // neighbour lists hold 32-bit indices

struct Placed {
  PlacedParticles particles;
  std::vector<double> width;  // of the cell around each particle: twice the distance to the nearer face
};

std::size_t axes_of(const Case& scene) {
  return static_cast<std::size_t>(scene.dimension);
}

// Cells along an axis whose middle lies before its end. The slack forgives the round-off of the division.
double cells_along(const Case& scene, std::size_t axis) {
  const double cells = (scene.upper[axis] - scene.lower[axis]) / scene.placement.spacing;
  return std::max(0.0, std::ceil(cells - 0.5 - 1e-9));
}

// Coordinates of particle axes as functions take them: (x, y, z).
std::array<double, 3> as_xyz(const Case& scene, const std::array<double, 3>& at) {
  if (scene.dimension == 3) return at;
  return {at[0], 0.0, scene.dimension == 2 ? at[1] : 0.0};
}

Placed place_by_spacing(const Case& scene, const Water& water) {
  const std::size_t axes = axes_of(scene);
  const double spacing = scene.placement.spacing;
  std::array<std::int64_t, 3> cells{1, 1, 1};
  double all = 1;
  for (std::size_t axis = 0; axis < axes; ++axis) all *= cells_along(scene, axis);
  if (all > largest_number) {
    std::ostringstream text;
    text.precision(15);
    text << "initial.particles.spacing = " << spacing << " m gives " << all << " cells, at most " << largest_number
         << " particles are possible";
    throw PlacementError(text.str());
  }
  for (std::size_t axis = 0; axis < axes; ++axis) cells[axis] = static_cast<std::int64_t>(cells_along(scene, axis));
  if (all < 1) {
    std::ostringstream text;
    text << "no particle results: initial.particles.spacing = " << spacing << " m is more than twice the domain";
    throw PlacementError(text.str());
  }

  // One line of cells along the last axis at a time.
  const std::size_t last = axes - 1;
  const auto n = static_cast<std::size_t>(cells[last]);
  std::array<std::vector<double>, 3> line;
  for (auto& coordinate : line) coordinate.resize(n);
  std::vector<double> depth(n);
  const auto middle = [&](std::size_t axis, std::int64_t k) {
    return scene.lower[axis] + (static_cast<double>(k) + 0.5) * spacing;
  };
  Placed placed;
  const std::int64_t outer = axes > 1 ? cells[0] : 1, inner = axes > 2 ? cells[1] : 1;
  for (std::int64_t i = 0; i < outer; ++i) {
    for (std::int64_t j = 0; j < inner; ++j) {
      for (std::size_t k = 0; k < n; ++k) {
        const auto cell = static_cast<std::int64_t>(k);
        if (axes > 1) line[0][k] = middle(0, i);
        if (axes > 2) line[1][k] = middle(1, j);
        line[last][k] = middle(last, cell);
      }
      const double* const y = axes == 3 ? line[1].data() : nullptr;
      const double* const z = axes > 1 ? line[last].data() : nullptr;
      water.depth(cells[last], line[0].data(), y, z, depth.data());
      for (std::size_t k = 0; k < n; ++k) {
        if (!(depth[k] > 0)) continue;
        for (std::size_t axis = 0; axis < axes; ++axis) placed.particles.x[axis].push_back(line[axis][k]);
      }
    }
  }
  placed.particles.cell_measure.assign(placed.particles.x[0].size(), std::pow(spacing, scene.dimension));
  placed.width.assign(placed.particles.x[0].size(), spacing);
  return placed;
}

// Places `count` particles in cells of equal length of the wetted stretches.
Placed place_by_count(const std::vector<Stretch>& split, std::int64_t count) {
  std::vector<Stretch> stretches;  // jumps of the depth do not matter here
  for (const Stretch& part : split) {
    if (!stretches.empty() && stretches.back().end == part.begin) {
      stretches.back().end = part.end;
    } else {
      stretches.push_back({part.begin, part.end, {}});
    }
  }
  double length = 0;
  for (const Stretch& stretch : stretches) length += stretch.end - stretch.begin;
  const double width = length / static_cast<double>(count);
  Placed placed;
  std::size_t at = 0;
  double passed = 0;  // length of the stretches before this one
  for (std::int64_t k = 0; k < count; ++k) {
    const double along = (static_cast<double>(k) + 0.5) * length / static_cast<double>(count);
    while (at + 1 < stretches.size() && along >= passed + (stretches[at].end - stretches[at].begin)) {
      passed += stretches[at].end - stretches[at].begin;
      ++at;
    }
    placed.particles.x[0].push_back(stretches[at].begin + (along - passed));
  }
  placed.particles.cell_measure.assign(static_cast<std::size_t>(count), width);
  placed.width = placed.particles.cell_measure;
  return placed;
}

Placed place_by_volume(const Water& water, const std::vector<Stretch>& stretches, std::int64_t count) {
  const RunningVolume running(water, stretches);
  const auto number = static_cast<double>(count);
  const auto share = [&](double k) {
    return running.position(std::min(k * running.total() / number, running.total()));
  };
  Placed placed;
  double left = stretches.front().begin;
  for (std::int64_t k = 0; k < count; ++k) {
    const double x = share(static_cast<double>(k) + 0.5);
    const double right = k + 1 == count ? stretches.back().end : share(static_cast<double>(k) + 1);
    placed.particles.x[0].push_back(x);
    placed.particles.cell_measure.push_back(running.total() / number / water.depth(x));
    placed.width.push_back(2 * std::min(x - left, right - x));
    left = right;
  }
  return placed;
}

void perturb(const Case& scene, const Water& water, Placed& placed) {
  if (!(scene.placement.perturbation > 0)) return;
  // The standard fixes the numbers of the engine, but not those of its distributions.
  std::mt19937_64 engine(scene.placement.seed);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  const std::size_t axes = axes_of(scene);
  for (std::size_t k = 0; k < placed.width.size(); ++k) {
    std::array<double, 3> moved{};
    bool in_domain = true;
    for (std::size_t axis = 0; axis < axes; ++axis) {
      const double shift = (2 * uniform() - 1) * scene.placement.perturbation * placed.width[k];
      moved[axis] = placed.particles.x[axis][k] + shift;
      in_domain = in_domain && moved[axis] >= scene.lower[axis] && moved[axis] <= scene.upper[axis];
    }
    const std::array<double, 3> at = as_xyz(scene, moved);
    if (!in_domain || !(water.depth(at[0], at[1], at[2]) > 0)) continue;
    for (std::size_t axis = 0; axis < axes; ++axis) placed.particles.x[axis][k] = moved[axis];
  }
}

}  // namespace

PlacedParticles place(const Case& scene, const PorosityAt& porosity) {
  const Water water(scene);
  const Placement& placement = scene.placement;
  Placed placed;
  if (placement.mode == Placement::Mode::spacing) {
    placed = place_by_spacing(scene, water);
  } else if (placement.mode == Placement::Mode::equal_volume_in_plane) {
    placed.particles = place_equal_water(scene, water, porosity);
    for (const double cell : placed.particles.cell_measure) placed.width.push_back(std::sqrt(cell));
  } else {
    const std::int64_t samples = std::clamp<std::int64_t>(8 * placement.count, 8192, 262144);
    const std::vector<Stretch> stretches = stretches_of(water, scene.lower[0], scene.upper[0], samples);
    if (stretches.empty()) throw PlacementError("no particle results: " + water.why_dry());
    placed = placement.mode == Placement::Mode::count ? place_by_count(stretches, placement.count)
                                                      : place_by_volume(water, stretches, placement.count);
  }
  if (placed.width.empty()) throw PlacementError("no particle results: " + water.why_dry());
  perturb(scene, water, placed);
  return std::move(placed.particles);
}

}  // namespace riffle
