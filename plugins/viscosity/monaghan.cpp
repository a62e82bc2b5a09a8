// Artificial viscosity of Monaghan (1992), as Diwakar & Mohapatra (2023) use it in eq. 7.
//
//   Pi_ij rho_ij = -alpha c_ij mu + beta mu^2 for approaching pairs, else 0;  mu = l_ij (u_ij . x_ij) / (r^2 + eps l_ij^2)
//
// The paper's eq. 7 lacks the division by the pair-mean depth and multiplies beta by c_ij: both are put right here (the
// equation set divides by its own pair-mean depth or density). In one dimension alpha acts as a kinematic viscosity of
// about alpha l c / 2. Not in it: a limiter; alpha = 0 lets shocks ring.
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct Monaghan {
  static constexpr auto id = "monaghan", kind = "viscosity", version = "1.0.0";
  static constexpr auto summary = "Pairwise viscosity that acts on approaching particles only";
  static constexpr auto source = "Monaghan (1992) eqs 4.1-4.2; Diwakar & Mohapatra (2023) eq. 7";
  static constexpr riffle_parameter parameters[] = {
      riffle::real("alpha", "1", 1.0, 0, 100,
                   "linear coefficient; 2 in the 2023 paper, 0.01-0.1 in weakly compressible flow"),
      riffle::real("beta", "1", 0.0, 0, 100, "quadratic coefficient, against interpenetration in strong shocks"),
      riffle::real("epsilon", "1", 0.01, 0, 1, "keeps mu finite at r = 0, in units of l squared", RIFFLE_ABOVE_MIN)};
  static constexpr std::uint32_t pass_flags = RIFFLE_STEADY;
  static constexpr riffle_read reads[] = {riffle::pair(f::approach), riffle::pair(f::distance_squared),
                                          riffle::mean(f::smoothing_length), riffle::mean(f::wave_speed)};
  static constexpr riffle_write writes[] = {riffle::set(f::viscous_pressure)};

  explicit Monaghan(const riffle::Values& v)
      : alpha(v.number("alpha")), beta(v.number("beta")), epsilon(v.number("epsilon")) {}

  void run(const riffle::Block& b) const {
    const double *approach = b.in(0), *r2 = b.in(1), *l = b.in(2), *c = b.in(3), a = alpha, q = beta, eps = epsilon;
    double* pi = b.out(0);
    RIFFLE_EACH(k, b) {
      const double closing = approach[k] < 0 ? approach[k] : 0.0;
      const double mu = l[k] * closing / (r2[k] + eps * l[k] * l[k]);
      pi[k] = mu * (q * mu - a * c[k]);
    }
  }

  // Measured on disturbed still water with all shipped kernels: stable to 0.6 l / (alpha c) for alpha = 2 and 4, where
  // it is what counts; Wendland C4 is the first to become unstable, at 0.65, the cubic spline at 0.8.
  struct Viscous {
    static constexpr auto name = "viscous";
    static constexpr std::uint32_t scaled = 0;
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::wave_speed)};
    static double limit(const Monaghan& m, const riffle::Block& b) {
      const double *l = b.in(0), *c = b.in(1);
      double least = riffle::infinity;
      RIFFLE_EACH_LEAST(k, b, least) least = l[k] < least * c[k] ? l[k] / c[k] : least;
      return 0.55 * least / m.alpha;
    }
  };
  using votes = riffle::Votes<Viscous>;
  double alpha, beta, epsilon;
};

RIFFLE_PLUGIN(Monaghan)
