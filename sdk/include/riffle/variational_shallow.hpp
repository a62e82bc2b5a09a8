// Shallow water from a discrete Lagrangian: what the equation sets built on it share. A support that follows the depth,
// its grad-h terms, and the hydrostatic forces of water, bed and side walls.
//
//   h_i = A_i / B_i,   A_i = sum_j V_j W(x_ij, l_i),   l_i^d A_i = eta^d V_i         (together, by Newton's method)
//   Omega_i = 1 + l_i / (d A_i) sum_j V_j dW/dl
//   a_i = - 1/2 sum_j V_j [ (g + Pi_ij h_ij h_ij / h_i^2) grad W(l_i) / (B_i Omega_i)
//                         + (g + Pi_ij h_ij h_ij / h_j^2) grad W(l_j) / (B_j Omega_j) ]
//         - g grad b + g h_i / (2 B_i) grad B
//
// Rodriguez-Paz & Bonet (2005); Price (2012) eq. 18-29. The passes are templates over the plugin, which has the members
// gravity, smoothing_ratio, reference_width and terrain, and says by `force` which field the accelerations
// are added to, and by `pressure` which one holds the pressure over g h / 2, by Omega (pressure_factor unless water has more).
#pragma once

#include <cmath>
#include <vector>

#include "riffle/sdk.hpp"

namespace riffle::variational {

namespace f = riffle::fields;

inline constexpr riffle_field section = riffle::scalar_field("section", "m", "A = sum V W: depth times width");
inline constexpr riffle_field section_dl = riffle::scalar_field("section_dl", "1", "dA/dl");
inline constexpr riffle_field section_dldl = riffle::scalar_field("section_dldl", "m-1", "d2A/dl2");
inline constexpr riffle_field support_error =
    riffle::scalar_field("support_error", "1", "relative error of l^d A = eta^d V that the last iteration left");
inline constexpr riffle_field pressure_factor =
    riffle::scalar_field("pressure_factor", "1", "1 / (B Omega), with B over the reference width");
inline constexpr riffle_field dissipation_factor =
    riffle::scalar_field("dissipation_factor", "m-2", "1 / (B Omega h^2)");

template <class Plugin>
struct Start {
  static constexpr auto pass_name = "initial volume and support";
  static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
  static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure), riffle::at_i(f::depth),
                                          riffle::at_i(f::position)};
  static constexpr riffle_write writes[] = {riffle::set(f::volume), riffle::set(f::smoothing_length)};
  static void run(const Plugin& s, const riffle::Block& b) {
    const double *cell = b.in(0), *depth = b.in(1);
    double *volume = b.out(0), *l = b.out(1);
    for (std::int64_t k = 0; k < b.size(); ++k) {
      volume[k] = depth[k] * cell[k];
      l[k] = s.smoothing_ratio * (b.dim() == 1 ? cell[k] : std::sqrt(cell[k]));
    }
    if (s.terrain.has_width == 0) return;
    std::vector<double> width(static_cast<std::size_t>(b.size()));
    s.terrain.width(s.terrain.context, b.size(), b.in(2), width.data(), nullptr);
    for (std::int64_t k = 0; k < b.size(); ++k) volume[k] *= width[static_cast<std::size_t>(k)] / s.reference_width;
  }
};

template <class Plugin>
struct Section {
  static constexpr auto pass_name = "section";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr std::uint32_t pass_flags = RIFFLE_WITH_SELF | RIFFLE_STEADY;
  static constexpr auto iteration = "support";
  static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::at_i(f::kernel, RIFFLE_PREVIOUS),
                                          riffle::at_i(f::kernel_dl, RIFFLE_PREVIOUS),
                                          riffle::at_i(f::kernel_dldl, RIFFLE_PREVIOUS)};
  static constexpr riffle_write writes[] = {riffle::sum(section), riffle::sum(section_dl), riffle::sum(section_dldl)};
  static void run(const Plugin&, const riffle::Block& b) {
    const double *volume = b.in(0), *w = b.in(1), *w_l = b.in(2), *w_ll = b.in(3);
    double *a = b.out(0), *a_l = b.out(1), *a_ll = b.out(2);
    RIFFLE_EACH(k, b) {
      a[k] = volume[k] * w[k];
      a_l[k] = volume[k] * w_l[k];
      a_ll[k] = volume[k] * w_ll[k];
    }
  }
};

// One Newton step for l^d A(l) = eta^d V, and A and dA/dl carried over to the new l by their Taylor series: a step of
// relative size x leaves an error of x^3, so that the steps of smooth flow need no second sum.
template <class Plugin>
struct Support {
  static constexpr auto pass_name = "support";
  static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
  static constexpr auto iteration = "support";
  static constexpr riffle_read reads[] = {riffle::at_i(section),
                                          riffle::at_i(section_dl),
                                          riffle::at_i(section_dldl),
                                          riffle::at_i(f::volume),
                                          riffle::at_i(f::smoothing_length, RIFFLE_PREVIOUS),
                                          riffle::at_i(f::channel_width, RIFFLE_OPTIONAL)};
  static constexpr riffle_write writes[] = {
      riffle::set(f::smoothing_length), riffle::set(support_error),   riffle::set(f::depth),
      riffle::set(f::wave_speed),       riffle::set(pressure_factor), riffle::set(dissipation_factor)};
  static void run(const Plugin& s, const riffle::Block& b) {
    const double *sum = b.in(0), *sum_l = b.in(1), *sum_ll = b.in(2), *volume = b.in(3), *before = b.in(4);
    const double* width = b.has(5) ? b.in(5) : nullptr;
    double *l = b.out(0), *error = b.out(1), *depth = b.out(2), *c = b.out(3), *p = b.out(4), *q = b.out(5);
    const double d = b.dim(), eta_d = b.dim() == 1 ? s.smoothing_ratio : s.smoothing_ratio * s.smoothing_ratio;
    RIFFLE_EACH(k, b) {
      const double old = before[k], measure = b.dim() == 1 ? old : old * old;
      // in x = ln l: F = l^d A - eta^d V, F' = d l^d A Omega; monotone, but flat where there are no neighbours
      const double excess = 1 - eta_d * volume[k] / (measure * sum[k]);
      const double omega_old = 1 + old * sum_l[k] / (d * sum[k]);
      const double newton = -excess / (d * omega_old);
      const double flat = excess < 0 ? 0.3 : -0.25, bounded = newton < -0.5 ? -0.5 : newton > 1 ? 1.0 : newton;
      const double wanted = omega_old > 0.05 ? bounded : flat;
      const double x = wanted < 1e-13 && wanted > -1e-13 ? 0.0 : wanted, step = x * old;  // round-off: l stays as it is
      const double a = sum[k] + step * (sum_l[k] + 0.5 * step * sum_ll[k]), a_l = sum_l[k] + step * sum_ll[k];
      const double fresh = old + step;
      const double omega = 1 + fresh * a_l / (d * a), b_i = width != nullptr ? width[k] / s.reference_width : 1.0;
      l[k] = fresh;
      error[k] = x * x * x;
      const double h = a / b_i;
      depth[k] = h;
      c[k] = std::sqrt(s.gravity * h);
      p[k] = 1 / (b_i * omega);
      q[k] = 1 / (b_i * omega * h * h);
    }
  }
};

template <class Plugin>
struct Momentum {
  static constexpr auto pass_name = "momentum";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
  static constexpr std::uint32_t neighbours = RIFFLE_EITHER;
  static constexpr riffle_read reads[] = {riffle::at_j(f::volume),
                                          riffle::pair(f::separation),
                                          riffle::at_i(f::kernel_gradient),
                                          riffle::at_j(f::kernel_gradient),
                                          riffle::at_i(Plugin::pressure),
                                          riffle::at_j(Plugin::pressure),
                                          riffle::pair(f::viscous_pressure, RIFFLE_OPTIONAL),
                                          riffle::at_i(dissipation_factor),
                                          riffle::at_j(dissipation_factor),
                                          riffle::at_i(f::depth),
                                          riffle::at_j(f::depth)};
  static constexpr riffle_write writes[] = {riffle::sum(Plugin::force)};
  static void run(const Plugin& s, const riffle::Block& b) {
    const double *volume = b.in(0), *fi = b.in(2), *fj = b.in(3), *pi = b.in(4), *pj = b.in(5);
    const double g = s.gravity;
    for (int c = 0; c < b.dim(); ++c) {
      const double* dx = b.in(1, c);
      double* a = b.out(0, c);
      if (b.has(6)) {
        const double *viscous = b.in(6), *qi = b.in(7), *qj = b.in(8), *hi = b.in(9), *hj = b.in(10);
        RIFFLE_EACH(k, b) {
          const double dissipation = viscous[k] * 0.5 * (hi[k] + hj[k]);
          a[k] = -0.5 * volume[k] * dx[k] *
                 (g * (pi[k] * fi[k] + pj[k] * fj[k]) + dissipation * (qi[k] * fi[k] + qj[k] * fj[k]));
        }
      } else {
        RIFFLE_EACH(k, b) a[k] = -0.5 * volume[k] * dx[k] * g * (pi[k] * fi[k] + pj[k] * fj[k]);
      }
    }
  }
};

template <class Plugin>
struct BedSlope {
  static constexpr auto pass_name = "bed slope";
  static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED | RIFFLE_STEADY;
  static constexpr riffle_read reads[] = {riffle::at_i(f::smoothed_bed_slope)};
  static constexpr riffle_write writes[] = {riffle::sum(Plugin::force)};
  static void run(const Plugin& s, const riffle::Block& b) {
    for (int c = 0; c < b.dim(); ++c) {
      const double* slope = b.in(0, c);
      double* a = b.out(0, c);
      RIFFLE_EACH(k, b) a[k] -= s.gravity * slope[k];
    }
  }
};

template <class Plugin>
struct SideWalls {
  static constexpr auto pass_name = "pressure of the side walls";
  static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED | RIFFLE_STEADY;
  static constexpr riffle_read reads[] = {riffle::at_i(f::depth), riffle::at_i(f::channel_width),
                                          riffle::at_i(f::width_slope)};
  static constexpr riffle_write writes[] = {riffle::sum(Plugin::force)};
  static void run(const Plugin& s, const riffle::Block& b) {
    const double *h = b.in(0), *width = b.in(1), *slope = b.in(2);
    double* a = b.out(0);
    RIFFLE_EACH(k, b) a[k] += 0.5 * s.gravity * h[k] * slope[k] / width[k];
  }
};

template <class Plugin>
struct Acoustic {  // particles move with the water, so only waves count
  static constexpr auto name = "acoustic";
  static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::wave_speed)};
  static double limit(const Plugin&, const riffle::Block& b) {
    const double *l = b.in(0), *c = b.in(1);
    double least = riffle::infinity;
    RIFFLE_EACH_LEAST(k, b, least) least = l[k] < least * c[k] ? l[k] / c[k] : least;
    return least;
  }
};

}  // namespace riffle::variational
