// Viscous forces of weakly compressible flow, gradients of velocity and the stresses that outputs show, as passes of the
// equation set that names them: a Plugin with members rho0 and nu [m2.s-1] and parameters `laminar` and `stress`.
//
//   morris   f_i = (1/phi_i) sum_j V_j F rho0 (nu_i + nu_j) u_ij      Morris et al. (1997), arithmetic mean
//   tensor   f_i = (1/phi_i) sum_j V_j (tau_i + tau_j) . x_ij F,   tau = 2 rho0 nu_t S,   Kazemi (2017) eq. 3.10:
//            a derivative of a derivative, which does not see neighbouring rows move against each other
//
// The water's own viscosity, in pores with the weight phi of the water there: (1/phi) div(phi nu grad u). Kazemi (2017)
// eq. 4.57 has nu u div grad phi besides, a force on water that does not shear; in the armour layers of his chapter 6 it
// changes the mean velocity by less than 0.05 %, and here it is left out.
#pragma once

#include <riffle/weakly_compressible.hpp>

namespace riffle::wc {

namespace detail {
// f = coefficient V_j F u_ij, component by component.
template <class Coefficient>
void pull(const Block& b, const Coefficient& coefficient) {
  const double *gradient = b.in(0), *volume = b.in(1);
  for (int c = 0; c < b.dim(); ++c) {
    const double* u = b.in(2, c);
    double* a = b.out(0, c);
    RIFFLE_EACH(k, b) a[k] = coefficient(k) * (volume[k] * gradient[k]) * u[k];
  }
}
}  // namespace detail

// The water's own viscosity. Walls take part with their velocity: no slip.
template <class Plugin>
struct LaminarStress {
  static constexpr auto pass_name = "laminar stress";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr auto when = "laminar=true";
  static constexpr riffle_read reads[] = {at_i(fields::kernel_gradient), at_j(particle_volume),
                                          difference(fields::velocity), at_i(fields::porosity, RIFFLE_OPTIONAL),
                                          at_j(fields::porosity, RIFFLE_OPTIONAL)};
  static constexpr riffle_write writes[] = {sum(pair_force)};
  static void run(const Plugin& s, const Block& b) {
    const double mu2 = 2 * s.rho0 * s.nu;
    if (b.has(3)) {
      const double *phi_i = b.in(3), *phi_j = b.in(4);
      detail::pull(b, [=](std::int64_t k) { return mu2 * (0.5 + 0.5 * phi_j[k] / phi_i[k]); });
    } else {
      detail::pull(b, [=](std::int64_t) { return mu2; });
    }
  }
};

// Eddies, where a turbulence plugin gives their viscosity; that of walls is 0.
template <class Plugin>
struct EddyStress {
  static constexpr auto pass_name = "eddy stress";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr auto when = "stress=morris";
  static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
  static constexpr riffle_read reads[] = {at_i(fields::kernel_gradient), at_j(particle_volume),
                                          difference(fields::velocity), mean(fields::eddy_viscosity),
                                          at_i(fields::porosity, RIFFLE_OPTIONAL)};
  static constexpr riffle_write writes[] = {sum(pair_force)};
  static void run(const Plugin& s, const Block& b) {
    const double *eddy = b.in(3), rho2 = 2 * s.rho0;
    if (b.has(4)) {
      const double* phi = b.in(4);
      detail::pull(b, [=](std::int64_t k) { return rho2 * eddy[k] / phi[k]; });
    } else {
      detail::pull(b, [=](std::int64_t k) { return rho2 * eddy[k]; });
    }
  }
};

// Gradient of the velocity, du_a/dx_b = - sum_j V_j F u_ij,a x_ij,b, with volumes at rest density (within the 1 % of the
// compressibility): so it stays valid while only densities change. Runs where somebody reads it.
template <class Plugin>
struct VelocityGradient {
  static constexpr auto pass_name = "velocity gradient";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr riffle_read reads[] = {at_i(fields::kernel_gradient), at_j(rest_volume),
                                          difference(fields::velocity), pair(fields::separation)};
  static constexpr riffle_write writes[] = {sum(fields::velocity_gradient)};
  static void run(const Plugin&, const Block& b) {
    const double *gradient = b.in(0), *volume = b.in(1);
    for (int r = 0; r < b.dim(); ++r) {
      for (int c = 0; c < b.dim(); ++c) {
        const double *u = b.in(2, r), *x = b.in(3, c);
        double* out = b.out(0, r * b.dim() + c);
        RIFFLE_EACH(k, b) out[k] = -volume[k] * gradient[k] * (u[k] * x[k]);
      }
    }
  }
};

// |S| = sqrt(2 S:S) = sqrt(sum_ab (G_ab + G_ba)^2 / 2)
template <class Plugin>
struct StrainRate {
  static constexpr auto pass_name = "strain rate";
  static constexpr riffle_read reads[] = {at_i(fields::velocity_gradient)};
  static constexpr riffle_write writes[] = {set(fields::strain_rate)};
  static void run(const Plugin&, const Block& b) {
    const int dim = b.dim();
    double* out = b.out(0);
    RIFFLE_EACH(k, b) out[k] = 0;
    for (int r = 0; r < dim; ++r) {
      for (int c = 0; c < dim; ++c) {
        const double *g = b.in(0, r * dim + c), *t = b.in(0, c * dim + r);
        RIFFLE_EACH(k, b) out[k] += 0.5 * (g[k] + t[k]) * (g[k] + t[k]);
      }
    }
    RIFFLE_EACH(k, b) out[k] = std::sqrt(out[k]);
  }
};

// tau = rho0 nu_t (G + G^T), for stress = "tensor".
template <class Plugin>
struct StressTensor {
  static constexpr auto pass_name = "stress tensor";
  static constexpr auto when = "stress=tensor";
  static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
  static constexpr riffle_read reads[] = {at_i(fields::velocity_gradient), at_i(fields::eddy_viscosity)};
  static constexpr riffle_write writes[] = {set(eddy_stress)};
  static void run(const Plugin& s, const Block& b) {
    const int dim = b.dim();
    const double *eddy = b.in(1), rho0 = s.rho0;
    for (int c = 0; c < dim; ++c) {
      for (int r = 0; r <= c; ++r) {
        const double *g = b.in(0, r * dim + c), *t = b.in(0, c * dim + r);
        double* out = b.out(0, c * (c + 1) / 2 + r);  // xx, xy, yy, xz, yz, zz
        RIFFLE_EACH(k, b) out[k] = rho0 * eddy[k] * (g[k] + t[k]);
      }
    }
  }
};

template <class Plugin>
struct StressDivergence {
  static constexpr auto pass_name = "stress divergence";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr auto when = "stress=tensor";
  static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
  static constexpr riffle_read reads[] = {at_i(fields::kernel_gradient), at_j(particle_volume), mean(eddy_stress),
                                          pair(fields::separation), at_i(fields::porosity, RIFFLE_OPTIONAL)};
  static constexpr riffle_write writes[] = {sum(pair_force)};
  static void run(const Plugin&, const Block& b) {
    const int dim = b.dim();
    const double *gradient = b.in(0), *volume = b.in(1), *phi = b.has(4) ? b.in(4) : nullptr;
    for (int r = 0; r < dim; ++r) {
      double* a = b.out(0, r);
      RIFFLE_EACH(k, b) a[k] = 0;
      for (int c = 0; c < dim; ++c) {
        const int low = r < c ? r : c, high = r < c ? c : r;
        const double *tau = b.in(2, high * (high + 1) / 2 + low), *x = b.in(3, c);
        RIFFLE_EACH(k, b) a[k] += tau[k] * x[k];
      }
      RIFFLE_EACH(k, b) a[k] *= 2 * volume[k] * gradient[k] / (phi != nullptr ? phi[k] : 1.0);
    }
  }
};

// Stresses for outputs, in the plane of the first and the last axis.
template <class Plugin>
struct ModelledShearStress {
  static constexpr auto pass_name = "modelled shear stress";
  static constexpr riffle_read reads[] = {at_i(fields::velocity_gradient),
                                          at_i(fields::eddy_viscosity, RIFFLE_OPTIONAL)};
  static constexpr riffle_write writes[] = {set(modelled_shear_stress)};
  static void run(const Plugin& s, const Block& b) {
    const int last = b.dim() - 1;
    const double *g = b.in(0, last), *t = b.in(0, last * b.dim()), *eddy = b.has(1) ? b.in(1) : nullptr;
    const double rho0 = s.rho0, nu = s.laminar ? s.nu : 0;
    RIFFLE_EACH(k, b) b.out(0)[k] = rho0 * (nu + (eddy != nullptr ? eddy[k] : 0.0)) * (g[k] + t[k]);
  }
};

template <class Plugin>
struct VirialShearStress {
  static constexpr auto pass_name = "virial shear stress";
  static constexpr auto pass_type = RIFFLE_PASS_PAIR;
  static constexpr riffle_read reads[] = {at_i(fields::kernel_gradient), at_j(particle_volume), mean(pair_pressure),
                                          pair(fields::separation)};
  static constexpr riffle_write writes[] = {sum(virial_shear_stress)};
  static void run(const Plugin&, const Block& b) {
    const double *gradient = b.in(0), *volume = b.in(1), *p = b.in(2), *x = b.in(3, 0), *z = b.in(3, b.dim() - 1);
    RIFFLE_EACH(k, b) b.out(0)[k] = volume[k] * gradient[k] * p[k] * (x[k] * z[k]);
  }
};

}  // namespace riffle::wc
