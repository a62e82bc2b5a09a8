// Density filter of order zero, every n steps: the density of a particle becomes the mean of those around it.
//
//   rho_i = sum_j V_j psi_j W / sum_j V_j W - rho0 g z_i / c0^2,   psi = rho + rho0 g z / c0^2,   itself included
//
// over the water. psi is even in water at rest. With hydrostatic = false the mean is that of the density itself, the
// filter as it is usually printed (Kazemi 2017, section 3.2.1): where the support is cut off by the surface it takes density
// from below, and a still column gains some 5 % of its depth in ten seconds.
// Source: Shepard (1968), Panizzo (2004). Where it fails: it smooths sound away, and wave crests with it.
#include <riffle/weakly_compressible.hpp>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct Shepard {
  static constexpr auto id = "shepard", kind = "filter", version = "1.0.0";
  static constexpr auto summary = "Density as the mean of those around, every n steps";
  static constexpr auto source = "Shepard (1968); Panizzo (2004); Kazemi (2017) section 3.2.1";
  static constexpr auto leaves_out = "the gradient of density other than that of water at rest: waves lose height";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::integer("every", 30, 1, 1e6, "steps from one filtering to the next"),
      riffle::boolean("hydrostatic", true, "leave the density gradient of water at rest alone")};

  static constexpr riffle_field kernel_share =
      riffle::scalar_field("shepard_share", "1", "sum over the water of V W, the particle itself included");
  static constexpr riffle_field density_share =
      riffle::scalar_field("shepard_density", "kg.m-3", "sum over the water of V psi W, the particle itself included");

  struct Gather {
    static constexpr auto pass_name = "sums of the density filter";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_WITH_SELF | RIFFLE_OCCASIONAL, sources = wc::water;
    static constexpr auto every = "every";
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel), riffle::at_j(wc::particle_volume),
                                            riffle::at_j(wc::excess_density), riffle::at_j(f::density)};
    static constexpr riffle_write writes[] = {riffle::sum(kernel_share), riffle::sum(density_share)};
    static void run(const Shepard& s, const riffle::Block& b) {
      const double *w = b.in(0), *volume = b.in(1), *density = s.hydrostatic ? b.in(2) : b.in(3);
      double *share = b.out(0), *sum = b.out(1);
      RIFFLE_EACH(k, b) {
        share[k] = volume[k] * w[k];
        sum[k] = volume[k] * w[k] * density[k];
      }
    }
  };
  struct Set {
    static constexpr auto pass_name = "density filter";
    static constexpr std::uint32_t pass_flags = RIFFLE_OCCASIONAL;
    static constexpr auto every = "every";
    static constexpr riffle_read reads[] = {riffle::at_i(kernel_share), riffle::at_i(density_share),
                                            riffle::at_i(wc::excess_density), riffle::at_i(f::density)};
    static constexpr riffle_write writes[] = {riffle::set(f::density)};
    static void run(const Shepard& s, const riffle::Block& b) {
      const double *share = b.in(0), *sum = b.in(1), *excess = b.in(2), *rho = b.in(3);
      const bool hydrostatic = s.hydrostatic;
      RIFFLE_EACH(k, b) {
        const double at_rest = hydrostatic ? excess[k] - rho[k] : 0.0;
        b.out(0)[k] = sum[k] / share[k] - at_rest;
      }
    }
  };
  using passes = riffle::Passes<Gather, Set>;

  explicit Shepard(const riffle::Values& v) : hydrostatic(v.flag("hydrostatic")) {}
  bool hydrostatic;
};

RIFFLE_PLUGIN(Shepard)
