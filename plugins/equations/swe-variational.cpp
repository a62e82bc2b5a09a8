// Shallow-water equations from a discrete Lagrangian, with the grad-h terms of a support that follows the depth.
//
//   h_i = A_i / B_i,   A_i = sum_j V_j W(x_ij, l_i),   l_i^d A_i = eta^d V_i         (together, by Newton's method)
//   Omega_i = 1 + l_i / (d A_i) sum_j V_j dW/dl
//   a_i = - 1/2 sum_j V_j [ (g + Pi_ij h_ij h_ij / h_i^2) grad W(l_i) / (B_i Omega_i)
//                         + (g + Pi_ij h_ij h_ij / h_j^2) grad W(l_j) / (B_j Omega_j) ]
//         - g grad b + g h_i / (2 B_i) grad B
//
// B is the width of the channel over reference_width, 1 without a width plugin; V_i then counts water per reference width.
// From E = 1/2 g sum V_i h_i + g sum V_i b_i: every pair acts on both particles alike, so momentum is kept to round-off
// and energy to the error in time; the last term is the pressure of the side walls. The bed is the one that a summation
// depth sees, smoothed by the same kernel.
// With eta = 1 and the cubic spline (a B-spline, whose lattice sum is 1) it is most accurate and cheapest.
// Not in it: balance of water at rest over an uneven bed (errors of the order of the spacing; swe-ale has it). Where it
// fails: without a viscosity at shocks; where the volumes of neighbours differ by more than 2 (place them equal-volume).
#include <cmath>
#include <riffle/sdk.hpp>
#include <vector>

namespace f = riffle::fields;

struct SweVariational {
  static constexpr auto id = "swe-variational", kind = "equations", version = "1.0.0";
  static constexpr auto summary = "Shallow-water equations from a Lagrangian, support by Newton's method";
  static constexpr auto source =
      "Rodriguez-Paz & Bonet (2005); Vacondio, Rogers & Stansby (2012); Price (2012) eq. 18-29";
  static constexpr auto leaves_out = "exact balance of water at rest over an uneven bed; non-hydrostatic pressure";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;

  static constexpr riffle_parameter parameters[] = {
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.8, 10,
                        "eta: smoothing length over spacing, everywhere and always"),
      riffle::real("reference_width", "m", 1, 0, 1e6, "width of the channel that volumes are counted for",
                   RIFFLE_ABOVE_MIN),
      riffle::real("support_tolerance", "1", 1e-8, 1e-14, 1e-3, "relative error of l^d A = eta^d V that is left"),
      riffle::integer("support_iterations", 50, 1, 1000, "largest number of Newton iterations per evaluation")};
  static constexpr riffle_field initial[] = {f::depth, f::velocity};
  static constexpr const riffle_field* conserved = &f::volume;
  static constexpr riffle_evolved evolved[] = {riffle::evolved_field(f::velocity, f::acceleration, &f::drag_rate),
                                               riffle::evolved_field(f::position, f::velocity)};

  static constexpr riffle_field section = riffle::scalar_field("section", "m", "A = sum V W: depth times width");
  static constexpr riffle_field section_dl = riffle::scalar_field("section_dl", "1", "dA/dl");
  static constexpr riffle_field section_dldl = riffle::scalar_field("section_dldl", "m-1", "d2A/dl2");
  static constexpr riffle_field support_error =
      riffle::scalar_field("support_error", "1", "relative error of l^d A = eta^d V that the last iteration left");
  static constexpr riffle_field pressure_factor =
      riffle::scalar_field("pressure_factor", "1", "1 / (B Omega), with B over the reference width");
  static constexpr riffle_field dissipation_factor =
      riffle::scalar_field("dissipation_factor", "m-2", "1 / (B Omega h^2)");
  static constexpr riffle_iteration iterations[] = {
      {sizeof(riffle_iteration), 0, "support", &support_error, "support_tolerance", "support_iterations"}};

  struct Start {
    static constexpr auto pass_name = "initial volume and support";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure), riffle::at_i(f::depth),
                                            riffle::at_i(f::position)};
    static constexpr riffle_write writes[] = {riffle::set(f::volume), riffle::set(f::smoothing_length)};
    static void run(const SweVariational& s, const riffle::Block& b) {
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

  struct Section {
    static constexpr auto pass_name = "section";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_WITH_SELF;
    static constexpr auto iteration = "support";
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::at_i(f::kernel, RIFFLE_PREVIOUS),
                                            riffle::at_i(f::kernel_dl, RIFFLE_PREVIOUS),
                                            riffle::at_i(f::kernel_dldl, RIFFLE_PREVIOUS)};
    static constexpr riffle_write writes[] = {riffle::sum(section), riffle::sum(section_dl), riffle::sum(section_dldl)};
    static void run(const SweVariational&, const riffle::Block& b) {
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
  struct Support {
    static constexpr auto pass_name = "support";
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
    static void run(const SweVariational& s, const riffle::Block& b) {
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
        const double x = omega_old > 0.05 ? bounded : flat, step = x * old;
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

  struct Momentum {
    static constexpr auto pass_name = "momentum";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t neighbours = RIFFLE_EITHER;
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume),
                                            riffle::pair(f::separation),
                                            riffle::at_i(f::kernel_gradient),
                                            riffle::at_j(f::kernel_gradient),
                                            riffle::at_i(pressure_factor),
                                            riffle::at_j(pressure_factor),
                                            riffle::pair(f::viscous_pressure, RIFFLE_OPTIONAL),
                                            riffle::at_i(dissipation_factor),
                                            riffle::at_j(dissipation_factor),
                                            riffle::at_i(f::depth),
                                            riffle::at_j(f::depth)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const SweVariational& s, const riffle::Block& b) {
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

  struct BedSlope {
    static constexpr auto pass_name = "bed slope";
    static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothed_bed_slope)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const SweVariational& s, const riffle::Block& b) {
      for (int c = 0; c < b.dim(); ++c) {
        const double* slope = b.in(0, c);
        double* a = b.out(0, c);
        RIFFLE_EACH(k, b) a[k] -= s.gravity * slope[k];
      }
    }
  };

  struct SideWalls {
    static constexpr auto pass_name = "pressure of the side walls";
    static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
    static constexpr riffle_read reads[] = {riffle::at_i(f::depth), riffle::at_i(f::channel_width),
                                            riffle::at_i(f::width_slope)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const SweVariational& s, const riffle::Block& b) {
      const double *h = b.in(0), *width = b.in(1), *slope = b.in(2);
      double* a = b.out(0);
      RIFFLE_EACH(k, b) a[k] += 0.5 * s.gravity * h[k] * slope[k] / width[k];
    }
  };
  using passes = riffle::Passes<Start, Section, Support, Momentum, BedSlope, SideWalls>;

  struct Acoustic {  // particles move with the water, so only waves count
    static constexpr auto name = "acoustic";
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::wave_speed)};
    static double limit(const SweVariational&, const riffle::Block& b) {
      const double *l = b.in(0), *c = b.in(1);
      double least = riffle::infinity;
      RIFFLE_EACH_LEAST(k, b, least) least = l[k] < least * c[k] ? l[k] / c[k] : least;
      return least;
    }
  };
  using votes = riffle::Votes<Acoustic>;

  explicit SweVariational(const riffle::Values& v)
      : gravity(v.number("gravity")),
        smoothing_ratio(v.number("smoothing_ratio")),
        reference_width(v.number("reference_width")) {}
  void connect(const riffle_services& services) { terrain = services; }
  double gravity, smoothing_ratio, reference_width;
  riffle_services terrain{};
};

RIFFLE_PLUGIN(SweVariational)
