// The dissipation of a linearised Riemann problem between velocities that are reconstructed to the middle of the pair
// (MUSCL, van Leer 1979): nearly none where the flow is smooth, that of `riemann` at shocks.
//
//   Pi_ij h_ij = alpha c_ij w + beta max(w, 0)^2
//   w = -(d - (phi(2 s_i - d, d) + phi(2 s_j - d, d)) / 2),   d = (u_j - u_i) . e,  s_i = e . G_i e r,  e = (x_j - x_i) / r
//   G_i = (sum_j u_ij x_ij F) (sum_j x_ij x_ij F)^-1          exact for linear velocities on any particles
//
// phi is the limiter. w never has another sign than in `riemann`: where two limited slopes cross, it is 0, so that every pair
// takes energy out. With approaching_only parting pairs are left alone ("visc=6" in the notes that this follows): necessary
// over a step of the bed, where velocities part over one spacing and no limiter sees that it is smooth.
#include <algorithm>
#include <cmath>
#include <riffle/viscous_limit.hpp>

namespace f = riffle::fields;

struct RiemannMuscl {
  static constexpr auto id = "riemann-muscl", kind = "viscosity", version = "1.0.0";
  static constexpr auto summary = "Dissipation of a linearised Riemann problem between reconstructed velocities";
  static constexpr auto source = "van Leer (1979); Vila (1999); Inutsuka (2002)";
  static constexpr auto leaves_out = "reconstruction of the depth: the pressure between two particles stays their mean";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;
  static constexpr riffle_parameter parameters[] = {
      riffle::real("alpha", "1", 1.0, 0, 100, "1: the linearised Riemann problem; less rings, more smears"),
      riffle::real("beta", "1", 1.0, 0, 100, "quadratic coefficient, for strong shocks"),
      riffle::choice("limiter", "minmod|van-leer|mc|superbee", "van-leer",
                     "from the most to the least dissipative; they differ little"),
      riffle::boolean("approaching_only", false, "leave parting pairs alone: for beds with steps")};

  static constexpr riffle_field slope_sum{
      sizeof(riffle_field), RIFFLE_TENSOR, 0, 0, "velocity_slope_sum", "m-d.s-1", "sum over j of u_ij x_ij F"};
  static constexpr riffle_field moment{sizeof(riffle_field),       RIFFLE_SYMMETRIC, 0, 0, "separation_moment", "m-d",
                                       "sum over j of x_ij x_ij F"};
  static constexpr riffle_field gradient{sizeof(riffle_field),
                                         RIFFLE_TENSOR,
                                         0,
                                         0,
                                         "renormalised_velocity_gradient",
                                         "s-1",
                                         "du_a/dx_b, exact for linear velocities"};

  struct Sums {
    static constexpr auto pass_name = "sums of the velocity gradient";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::difference(f::velocity), riffle::pair(f::separation),
                                            riffle::at_i(f::kernel_gradient)};
    static constexpr riffle_write writes[] = {riffle::sum(slope_sum), riffle::sum(moment)};
    static void run(const RiemannMuscl&, const riffle::Block& b) {
      const double* F = b.in(2);
      for (int column = 0; column < b.dim(); ++column) {
        const double* x = b.in(1, column);
        for (int row = 0; row < b.dim(); ++row) {
          const double *u = b.in(0, row), *y = b.in(1, row);
          double* slope = b.out(0, row * b.dim() + column);
          RIFFLE_EACH(k, b) slope[k] = u[k] * x[k] * F[k];
          if (row > column) continue;
          double* product = b.out(1, column * (column + 1) / 2 + row);
          RIFFLE_EACH(k, b) product[k] = x[k] * y[k] * F[k];
        }
      }
    }
  };

  struct Gradient {
    static constexpr auto pass_name = "velocity gradient";
    static constexpr auto pass_type = RIFFLE_PASS_PARTICLE;
    static constexpr riffle_read reads[] = {riffle::at_i(slope_sum), riffle::at_i(moment)};
    static constexpr riffle_write writes[] = {riffle::set(gradient)};
    static void run(const RiemannMuscl&, const riffle::Block& b) {
      if (b.dim() == 1) {
        const double *sum = b.in(0), *m = b.in(1);
        double* g = b.out(0);
        RIFFLE_EACH(k, b) g[k] = m[k] < 0 ? sum[k] / m[k] : 0.0;  // 0 without neighbours
        return;
      }
      const double *xx = b.in(1, 0), *xy = b.in(1, 1), *yy = b.in(1, 2);
      for (int row = 0; row < 2; ++row) {
        const double *sx = b.in(0, 2 * row), *sy = b.in(0, 2 * row + 1);
        double *gx = b.out(0, 2 * row), *gy = b.out(0, 2 * row + 1);
        RIFFLE_EACH(k, b) {  // 0 where the neighbours lie on a line
          const double det = xx[k] * yy[k] - xy[k] * xy[k], trace = xx[k] + yy[k];
          const double inverse = det > 1e-6 * trace * trace ? 1 / det : 0.0;
          gx[k] = (sx[k] * yy[k] - sy[k] * xy[k]) * inverse;
          gy[k] = (sy[k] * xx[k] - sx[k] * xy[k]) * inverse;
        }
      }
    }
  };

  struct Dissipation {
    static constexpr auto pass_name = "dissipation";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::pair(f::approach),   riffle::pair(f::distance),
                                            riffle::mean(f::wave_speed), riffle::pair(f::separation),
                                            riffle::at_i(gradient),      riffle::at_j(gradient)};
    static constexpr riffle_write writes[] = {riffle::set(f::viscous_pressure)};
    static void run(const RiemannMuscl& s, const riffle::Block& b) {
      const auto minmod = [](double a, double d) { return std::copysign(std::min(std::abs(a), std::abs(d)), d); };
      switch (s.limiter) {  // phi(a, d) of the arguments a and d of one sign
        case 0: return s.pairs(b, minmod);
        case 1: return s.pairs(b, [](double a, double d) { return 2 * a * d / (a + d); });
        case 2: return s.pairs(b, [=](double a, double d) { return minmod(0.5 * (a + d), 2 * minmod(a, d)); });
        default:
          return s.pairs(b, [=](double a, double d) {
            const double one = std::abs(minmod(2 * a, d)), two = std::abs(minmod(a, 2 * d));
            return std::copysign(std::max(one, two), d);
          });
      }
    }
  };
  using passes = riffle::Passes<Sums, Gradient, Dissipation>;

  // All differences of velocity times r, so that one division is enough.
  template <class Limiter>
  void pairs(const riffle::Block& b, Limiter phi) const {
    const double *approach = b.in(0), *r = b.in(1), *c = b.in(2), *x = b.in(3), *gi = b.in(4), *gj = b.in(5);
    double* pi = b.out(0);
    const double least = parting ? -riffle::infinity : 0.0;
    const auto pair = [&](std::int64_t k, double si, double sj) {
      const double d = approach[k], ai = 2 * si - d, aj = 2 * sj - d;
      const double pi_i = ai * d > 0 ? phi(ai, d) : 0.0, pi_j = aj * d > 0 ? phi(aj, d) : 0.0;
      const double left = d - 0.5 * (pi_i + pi_j);
      const double speed = left * d > 0 ? -left / r[k] : 0.0;
      const double closing = speed > 0 ? speed : 0.0, acting = speed > least ? speed : least;
      pi[k] = alpha * c[k] * acting + beta * closing * closing;
    };
    if (b.dim() == 1) {
      RIFFLE_EACH(k, b) pair(k, gi[k] * x[k] * x[k], gj[k] * x[k] * x[k]);
      return;
    }
    const double* y = b.in(3, 1);
    const double *ixy = b.in(4, 1), *iyx = b.in(4, 2), *iyy = b.in(4, 3);
    const double *jxy = b.in(5, 1), *jyx = b.in(5, 2), *jyy = b.in(5, 3);
    RIFFLE_EACH(k, b) {
      const double xx = x[k] * x[k], xy = x[k] * y[k], yy = y[k] * y[k];
      pair(k, gi[k] * xx + (ixy[k] + iyx[k]) * xy + iyy[k] * yy, gj[k] * xx + (jxy[k] + jyx[k]) * xy + jyy[k] * yy);
    }
  }

  explicit RiemannMuscl(const riffle::Values& v)
      : alpha(v.number("alpha")),
        beta(v.number("beta")),
        parting(!v.flag("approaching_only")),
        limiter(static_cast<int>(v.number("limiter"))) {}

  struct Viscous : riffle::ViscousLimit<RiemannMuscl> {};
  using votes = riffle::Votes<Viscous>;
  double alpha, beta;
  bool parting;
  int limiter;
};

RIFFLE_PLUGIN(RiemannMuscl)
