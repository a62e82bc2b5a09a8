#include "host/neighbours/cells.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace riffle {

namespace {

Cells cells_over(const Box& box, int dim, double most, double edge) {
  Cells cells;
  cells.lower = box.lower;
  for (;; edge *= 1.5) {
    double product = 1;
    for (int d = 0; d < dim; ++d) {
      const auto a = static_cast<std::size_t>(d);
      const double along = std::floor((box.upper[a] - box.lower[a]) / edge) + 1;
      product *= along;
      cells.along[a] = static_cast<std::int32_t>(std::min(along, most));
    }
    if (product <= most) break;
  }
  cells.inverse_edge = 1 / edge;
  return cells;
}

// Where all but a few in a hundred of the members are, with a margin.
Box without_outliers(const ParticleView& particles, const Box& bounds,
                     const std::function<bool(std::int64_t)>& member) {
  std::vector<std::int64_t> sample;
  const std::int64_t stride = particles.all / 4096 + 1;
  for (std::int64_t i = 0; i < particles.all; i += stride) {
    if (member(i)) sample.push_back(i);
  }
  if (sample.size() < 64) return bounds;
  Box box = bounds;
  std::vector<double> x(sample.size());
  for (int d = 0; d < particles.dim; ++d) {
    const auto a = static_cast<std::size_t>(d);
    std::transform(sample.begin(), sample.end(), x.begin(), [&](std::int64_t i) { return particles.x[d][i]; });
    std::sort(x.begin(), x.end());
    const double low = x[x.size() / 50], high = x[x.size() - 1 - x.size() / 50];
    box.lower[a] = std::max(box.lower[a], low - 0.2 * (high - low));
    box.upper[a] = std::min(box.upper[a], high + 0.2 * (high - low));
  }
  return box;
}

}  // namespace

Cells fit_cells(const ParticleView& particles, const Box& bounds, std::int64_t n, double edge,
                const std::function<bool(std::int64_t)>& member) {
  double widest = 0;
  for (std::size_t a = 0; a < 3; ++a) widest = std::max(widest, bounds.upper[a] - bounds.lower[a]);
  if (!(edge > 0)) edge = widest > 0 ? widest / 1024 : 1;
  const double most = 4.0 * static_cast<double>(n) + 64;  // more empty cells than that only cost memory
  const Cells cells = cells_over(bounds, particles.dim, most, edge);
  if (cells.inverse_edge * edge > 0.99) return cells;
  return cells_over(without_outliers(particles, bounds, member), particles.dim, most, edge);
}

}  // namespace riffle
