// Weakly compressible flow in two and three dimensions: continuity with density diffusion, linear state equation,
// symmetric pressure force, gravity along the last axis.
//
//   drho_i/dt = sum_j m_j (u_ij . x_ij) F + 2 delta c0 sum_j l_j V_j (rho_i - rho_j) F r^2 / (r^2 + eta^2)
//   a_i       = - sum_j m_j (p_i / rho_i^2 + p_j / rho_j^2 + Pi_ij / rho_ij) F x_ij + g
//   p         = c0^2 (rho - rho0),   F = (dW/dr) / r,   eta^2 = 0.01 l^2
//
// F is never positive, so diffusion moves density from dense to thin. Water starts from rho0 everywhere.
// Not in it: turbulence, laminar stress, porosity, and the hydrostatic correction of the diffusion, without which it
// presses against the free surface: keep delta at or below 0.1. Stable for delta times CFL below about 0.35.
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct Wcsph {
  static constexpr auto id = "wcsph", kind = "equations", version = "0.1.0";
  static constexpr auto summary = "Weakly compressible flow in the vertical plane and in space";
  static constexpr auto source = "Monaghan (1994); Molteni & Colagrossi (2009); Kazemi (2017) eqs 3.9-3.11";
  static constexpr auto leaves_out =
      "turbulence, laminar stress, porosity; hydrostatic correction of the density diffusion";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;

  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("sound_speed", "m.s-1", 0, 1e5,
                            "c0: ten times the largest velocity or sqrt(g H) keeps density within 1 %",
                            RIFFLE_ABOVE_MIN),
      riffle::real("delta", "1", 0.1, 0, 1, "density diffusion of delta-SPH; 0 turns it off"),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity, against the last axis"),
      riffle::inherited("density", "kg.m-3", "fluid.density", 0, 1e5, "reference density rho0", RIFFLE_ABOVE_MIN),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.5, 10, "smoothing length over spacing")};
  static constexpr riffle_field initial[] = {f::velocity};
  static constexpr const riffle_field* conserved = &f::mass;
  static constexpr riffle_evolved evolved[] = {riffle::evolved_field(f::density, f::density_rate),
                                               riffle::evolved_field(f::velocity, f::acceleration, &f::drag_rate),
                                               riffle::evolved_field(f::position, f::velocity)};
  // Formed once per particle, because each operation saved per pair counts twenty times.
  static constexpr riffle_field pressure_term =
      riffle::scalar_field("pressure_term", "kg-1.m5.s-2", "pressure over density squared");
  static constexpr riffle_field diffusion_term =
      riffle::scalar_field("diffusion_term", "kg-1.m5.s-1", "2 delta l c0 over density");
  static constexpr riffle_field softening =
      riffle::scalar_field("softening", "m2", "eta squared, which keeps quotients finite at r = 0");

  struct Start {
    static constexpr auto pass_name = "initial mass and density";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure)};
    static constexpr riffle_write writes[] = {riffle::set(f::mass), riffle::set(f::density),
                                              riffle::set(f::smoothing_length), riffle::set(f::wave_speed),
                                              riffle::set(softening)};
    static void run(const Wcsph& s, const riffle::Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) {
        b.out(0)[k] = s.rho0 * b.in(0)[k];
        b.out(1)[k] = s.rho0;
        const double l = s.smoothing_ratio * (b.dim() == 2 ? std::sqrt(b.in(0)[k]) : std::cbrt(b.in(0)[k]));
        b.out(2)[k] = l;
        b.out(3)[k] = s.c0;
        b.out(4)[k] = 0.01 * l * l;
      }
    }
  };

  struct State {
    static constexpr auto pass_name = "state equation";
    static constexpr riffle_read reads[] = {riffle::at_i(f::density), riffle::at_i(f::smoothing_length)};
    static constexpr riffle_write writes[] = {riffle::set(pressure_term), riffle::set(diffusion_term)};
    static void run(const Wcsph& s, const riffle::Block& b) {
      const double *density = b.in(0), *l = b.in(1), c2 = s.c0 * s.c0, rho0 = s.rho0, diffusion = 2 * s.delta * s.c0;
      double *term = b.out(0), *diffusion_over_density = b.out(1);
      RIFFLE_EACH(k, b) {
        const double inverse = 1 / density[k];
        term[k] = c2 * (density[k] - rho0) * inverse * inverse;
        diffusion_over_density[k] = diffusion * l[k] * inverse;
      }
    }
  };

  struct Rates {
    static constexpr auto pass_name = "continuity and momentum";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {
        riffle::at_i(pressure_term),       riffle::at_i(f::kernel_gradient),
        riffle::pair(f::separation),       riffle::pair(f::approach),
        riffle::at_i(softening),           riffle::at_j(f::mass),
        riffle::at_i(f::density),          riffle::at_j(f::density),
        riffle::at_j(diffusion_term),      riffle::at_j(pressure_term),
        riffle::pair(f::distance_squared), riffle::pair(f::viscous_pressure, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration), riffle::sum(f::density_rate)};
    static void run(const Wcsph&, const riffle::Block& b) {
      if (b.dim() == 2)
        b.has(11) ? rates<2, true>(b) : rates<2, false>(b);
      else
        b.has(11) ? rates<3, true>(b) : rates<3, false>(b);
    }
    // Multiplications are what it costs: V_j (rho_i - rho_j) is m_j (rho_i - rho_j) / rho_j, the division by density lies
    // in the neighbour's diffusion term, and one division serves the other two quotients.
    template <int Dim, bool Viscous>
    static void rates(const riffle::Block& b) {
      const double *term_i = b.in(0), *gradient = b.in(1), *approach = b.in(3), *eta2 = b.in(4), *mass = b.in(5);
      const double *rho_i = b.in(6), *rho_j = b.in(7), *diffusion = b.in(8), *term_j = b.in(9), *r2 = b.in(10);
      const double *x = b.in(2, 0), *y = b.in(2, 1), *z = Dim == 3 ? b.in(2, Dim - 1) : x;
      const double* viscous = Viscous ? b.in(11) : term_i;
      double *ax = b.out(0, 0), *ay = b.out(0, 1), *az = Dim == 3 ? b.out(0, Dim - 1) : ax, *rate = b.out(1);
      RIFFLE_EACH(k, b) {
        const double mf = mass[k] * gradient[k];
        const double sum = rho_i[k] + rho_j[k], softened = r2[k] + eta2[k];
        const double inverse = 1 / (sum * softened);
        const double pi = Viscous ? (viscous[k] + viscous[k]) * (softened * inverse) : 0.0;
        const double a = (-(term_i[k] + term_j[k]) - pi) * mf;
        ax[k] = a * x[k];
        ay[k] = a * y[k];
        if (Dim == 3) az[k] = a * z[k];
        rate[k] = mf * (approach[k] + diffusion[k] * (rho_i[k] - rho_j[k]) * (r2[k] * sum * inverse));
      }
    }
  };

  struct Gravity {
    static constexpr auto pass_name = "gravity";
    static constexpr riffle_read reads[] = {riffle::at_i(f::density)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const Wcsph& s, const riffle::Block& b) {
      double* a = b.out(0, b.dim() - 1);
      RIFFLE_EACH(k, b) a[k] -= s.gravity;
    }
  };
  using passes = riffle::Passes<Start, State, Rates, Gravity>;

  struct Acoustic {
    static constexpr auto name = "acoustic";
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length)};
    static double limit(const Wcsph& s, const riffle::Block& b) {
      double least = riffle::infinity;
      for (std::int64_t k = 0; k < b.size(); ++k) least = b.in(0)[k] < least ? b.in(0)[k] : least;
      return least / s.c0;
    }
  };
  using votes = riffle::Votes<Acoustic>;

  explicit Wcsph(const riffle::Values& v)
      : c0(v.number("sound_speed")),
        delta(v.number("delta")),
        gravity(v.number("gravity")),
        rho0(v.number("density")),
        smoothing_ratio(v.number("smoothing_ratio")) {}
  double c0, delta, gravity, rho0, smoothing_ratio;
};

RIFFLE_PLUGIN(Wcsph)
