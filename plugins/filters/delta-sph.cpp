// Density diffusion of delta-SPH, which smooths the noise of the pressure of weakly compressible water.
//
//   drho_i/dt = ... + 2 delta l c0 sum_j V_j F (psi_i - psi_j),   psi = rho + rho0 g z / c0^2   (hydrostatic = true)
//
// F = (dW/dr)/r is never positive, so density goes from dense to thin. psi is even in water at rest, so that nothing
// presses against the free surface, as diffusion of rho itself does (hydrostatic = false, the older form). Walls take no
// part: what their density says is not what the water's should become.
// Source: Molteni & Colagrossi (2009), Antuono et al. (2010) with the gradient of still water in place of the renormalised
// one. Where it fails: a pattern that alternates from particle to particle decays at 2 delta S c0 / l, S = the integral of
// -l^2 F over space (3.5 for Wendland C2, 4.5 for C4, 2.9 for the cubic spline), so that explicit steps are stable to
// delta dt c0 / l = 1 / S; measured: 0.27 to 0.31 for Wendland C2 and 0.32 to 0.35 for the cubic spline, whatever l/dx is,
// half of that with leap-frog. The vote is for 0.2. In a closed tank delta (l/dx)^2 above 0.23 lets an acoustic mode grow.
#include <riffle/weakly_compressible.hpp>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct DeltaSph {
  static constexpr auto id = "delta-sph", kind = "filter", version = "1.0.0";
  static constexpr auto summary = "Density diffusion in proportion to differences of density";
  static constexpr auto source = "Molteni & Colagrossi (2009); Antuono et al. (2010)";
  static constexpr auto leaves_out = "renormalised density gradients: only the gradient of water at rest is taken out";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::real("delta", "1", 0.1, 0, 10, "strength; 0.1 for l = 1.5 dx, 0.05 for l = 2 dx"),
      riffle::boolean("hydrostatic", true, "leave the density gradient of water at rest alone")};

  template <class Pass>
  static void diffuse(const DeltaSph& s, const riffle::Block& b) {
    const double *gradient = b.in(0), *volume = b.in(1), *excess = b.in(2), *diffusivity = b.in(3);
    const double delta2 = 2 * s.delta;
    double* rate = b.out(0);
    RIFFLE_EACH(k, b) rate[k] = delta2 * diffusivity[k] * (volume[k] * gradient[k]) * excess[k];
  }
  struct OfExcess {
    static constexpr auto pass_name = "density diffusion";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr auto when = "hydrostatic=true";
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient), riffle::at_j(wc::diffusing_volume),
                                            riffle::difference(wc::excess_density),
                                            riffle::at_i(wc::acoustic_diffusivity)};
    static constexpr riffle_write writes[] = {riffle::sum(wc::density_spread)};
    static void run(const DeltaSph& s, const riffle::Block& b) { diffuse<OfExcess>(s, b); }
  };
  struct OfDensity {
    static constexpr auto pass_name = "density diffusion, gradient of still water included";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr auto when = "hydrostatic=false";
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient), riffle::at_j(wc::diffusing_volume),
                                            riffle::difference(f::density), riffle::at_i(wc::acoustic_diffusivity)};
    static constexpr riffle_write writes[] = {riffle::sum(wc::density_spread)};
    static void run(const DeltaSph& s, const riffle::Block& b) { diffuse<OfDensity>(s, b); }
  };
  using passes = riffle::Passes<OfExcess, OfDensity>;

  struct Diffusive {
    static constexpr auto name = "diffusive";
    static constexpr std::uint32_t scaled = 0;
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::wave_speed)};
    static double limit(const DeltaSph& s, const riffle::Block& b) {
      double least = riffle::infinity;
      const double *l = b.in(0), *c = b.in(1);
      RIFFLE_EACH_LEAST(k, b, least) least = l[k] < least * c[k] ? l[k] / c[k] : least;
      return s.delta > 0 ? 0.2 * least / s.delta : riffle::infinity;
    }
  };
  using votes = riffle::Votes<Diffusive>;

  explicit DeltaSph(const riffle::Values& v) : delta(v.number("delta")) {}
  double delta;
};

RIFFLE_PLUGIN(DeltaSph)
