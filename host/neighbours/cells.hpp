// A box cut into equal cells.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "host/neighbours/neighbours.hpp"

namespace riffle {

struct Box {
  std::array<double, 3> lower{}, upper{};  // m
};

struct Cells {
  double inverse_edge = 0;  // 1/m
  std::array<double, 3> lower{};
  std::array<std::int32_t, 3> along{1, 1, 1};  // number of cells along each axis

  // Column, row or layer of a coordinate. Monotone in x and clamped at the border cells, which therefore also hold
  // whatever lies beyond them: the box decides speed, never what is found.
  [[nodiscard]] std::int32_t index(double x, int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    const double c = (x - lower[a]) * inverse_edge;
    const double last = along[a] - 1;
    return static_cast<std::int32_t>(c > 0 ? (c < last ? c : last) : 0);
  }
  // The first cell of a row; rows run along x[0].
  [[nodiscard]] std::int64_t row(std::int64_t layer, std::int64_t row) const {
    return (layer * along[1] + row) * along[0];
  }
  // The cell of particle i.
  [[nodiscard]] std::int64_t at(const ParticleView& particles, std::int64_t i) const {
    const std::int64_t z = particles.dim > 2 ? index(particles.x[2][i], 2) : 0;
    const std::int64_t y = particles.dim > 1 ? index(particles.x[1][i], 1) : 0;
    return row(z, y) + index(particles.x[0][i], 0);
  }
  [[nodiscard]] std::int64_t count() const { return row(along[2], 0); }
};

// Cells of the given edge (m) over the bounding box of the n particles that are members; coarser when there would be
// many more cells than particles. A few particles far away from all others do not make them coarse.
Cells fit_cells(const ParticleView& particles, const Box& bounds, std::int64_t n, double edge,
                const std::function<bool(std::int64_t)>& member);

}  // namespace riffle
