// The scene of the boundary benchmark: one state of weakly compressible flow in the vertical plane, as plain arrays.
//
// Particles on a square lattice of the unit square, each moved by up to 0.2 dp, in random order before they are sorted
// by cell as any code would; smoothing length 1.41 dp, which gives about 22 neighbours; masses, densities and
// velocities vary from particle to particle. The same arrays are the input of all sides of the comparison.
//
// The physics of all sides, with x_ij = x_i - x_j, r = |x_ij|, F = (dW/dr) / r of Wendland C2 (support 2 h, 2D):
//
//   a_i    = - (1 / rho_i) sum_j V_j (p_i + p_j + rho0 Pi_ij) F x_ij,   V_j = m_j / rho_j
//   Pi_ij  = - alpha c h min(0, v_ij . x_ij) / (r^2 + eta^2)                                     (Monaghan 1992)
//   drho_i = rho_i sum_j V_j (v_ij . x_ij) F + 2 delta h c sum_j V_j (rho_i - rho_j) F     (Molteni & Colagrossi 2009)
//
// F is never positive, so the last term moves density from dense to thin: with the other sign it would run away.
#pragma once

#include <cstdint>
#include <vector>

#include "host/neighbours/neighbours.hpp"

namespace riffle::bench {

struct Physics {
  double smoothing_length = 0;      // m
  double sound_speed = 20;          // m/s
  double reference_density = 1000;  // kg/m3
  double alpha = 0.05;              // artificial viscosity
  double delta = 0.1;               // density diffusion

  [[nodiscard]] double support() const { return 2 * smoothing_length; }
  [[nodiscard]] double eta2() const { return 0.01 * smoothing_length * smoothing_length; }
  // -5 alpha_2D / h^2, where F = factor * (1 - r / 2h)^3
  [[nodiscard]] double kernel_factor() const;
  // rho0 Pi = viscosity_factor * min(0, v.x) / (r^2 + eta^2)
  [[nodiscard]] double viscosity_factor() const { return -reference_density * alpha * sound_speed * smoothing_length; }
  [[nodiscard]] double diffusion_factor() const { return 2 * delta * smoothing_length * sound_speed; }
};

struct BenchState {
  Physics physics;
  std::int64_t particles = 0;
  std::vector<double> x, z, u, w, density, pressure, mass;  // [particles], SI

  // Square cells of an edge not below the support, rows along x; particles are in their order.
  std::int64_t cells_along = 0;
  std::vector<std::int32_t> cell_begin;  // [cells_along^2 + 1]

  NeighbourList list;           // gather, all particles
  std::int64_t true_pairs = 0;  // r < support; what times are divided by, whatever the list holds beyond them
};

struct BenchRates {
  std::vector<double> acceleration_x, acceleration_z, density_rate;  // [particles]

  explicit BenchRates(std::int64_t particles);
};

// along^2 particles; 400 for the benchmark. `skin` is that of the list, as a fraction of the support.
BenchState make_state(std::int64_t along, double skin);

// |a - b| / |b| in the Euclidean norm over all particles, the largest over the three rates.
double relative_difference(const BenchRates& a, const BenchRates& b);

}  // namespace riffle::bench
