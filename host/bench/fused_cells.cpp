#include "host/bench/fused_cells.hpp"

#include <algorithm>
#include <cmath>

namespace riffle::bench {

FusedCells::FusedCells(const BenchState& state) : state_(state), volume_(state.x.size()) {}

void FusedCells::operator()(BenchRates& rates) {
  const BenchState& s = state_;
  const auto n = static_cast<std::size_t>(s.particles);
  for (std::size_t i = 0; i < n; ++i) {
    volume_[i] = s.mass[i] / s.density[i];
  }
  const double *x = s.x.data(), *z = s.z.data(), *u = s.u.data(), *w = s.w.data();
  const double *density = s.density.data(), *pressure = s.pressure.data(), *volume = volume_.data();
  const double support2 = s.physics.support() * s.physics.support(), eta2 = s.physics.eta2();
  const double inverse_support = 1 / s.physics.support(), kernel = s.physics.kernel_factor();
  const double viscosity = s.physics.viscosity_factor(), diffusion = s.physics.diffusion_factor();
  const std::int64_t along = s.cells_along;

  for (std::int64_t row = 0; row < along; ++row) {
    for (std::int64_t column = 0; column < along; ++column) {
      const std::int32_t* cell = s.cell_begin.data() + row * along + column;
      const std::int64_t left = column > 0 ? -1 : 0, right = column + 1 < along ? 1 : 0;
      const std::int64_t below = row > 0 ? -1 : 0, above = row + 1 < along ? 1 : 0;
      for (std::int32_t i = cell[0]; i < cell[1]; ++i) {
        double acceleration_x = 0, acceleration_z = 0, density_rate = 0;
        for (std::int64_t neighbour_row = below; neighbour_row <= above; ++neighbour_row) {
          const std::int32_t first = cell[neighbour_row * along + left];
          const std::int32_t last = cell[neighbour_row * along + right + 1];
          for (std::int32_t j = first; j < last; ++j) {
            const double dx = x[i] - x[j], dz = z[i] - z[j];
            const double r2 = dx * dx + dz * dz;
            if (r2 >= support2 || j == i) continue;
            const double q = 1 - std::sqrt(r2) * inverse_support;
            const double f = kernel * q * q * q;
            const double vx = (u[i] - u[j]) * dx + (w[i] - w[j]) * dz;
            const double pi = vx < 0 ? viscosity * vx / (r2 + eta2) : 0;
            const double vf = volume[j] * f;
            const double a = -(pressure[i] + pressure[j] + pi) * vf;
            acceleration_x += a * dx;
            acceleration_z += a * dz;
            density_rate += vf * (density[i] * vx + diffusion * (density[i] - density[j]));
          }
        }
        const auto k = static_cast<std::size_t>(i);
        rates.acceleration_x[k] = acceleration_x / density[i];
        rates.acceleration_z[k] = acceleration_z / density[i];
        rates.density_rate[k] = density_rate;
      }
    }
  }
}

}  // namespace riffle::bench
