// Particle shifting: particles move a little from where they crowd to where they are rare, after each step.
//
//   x_i := x_i - A l |u_i| dt grad C_i,   grad C_i = sum_j V_j (1 + 0.2 b) F x_ij,   at most 0.2 dx
//
// b = (1 + (r^2 - dx^2) / l^2)^-4 grows where pairs are closer than the lattice, against clumping; Lind et al. have
// (W(r) / W(dx))^4 there. Near the free surface, where the kernel
// sum falls below `surface`, nothing is shifted, since the surface would spread. Velocities and densities stay with the
// particles: what shifting carries away with them is left out.
// Source: Lind et al. (2012), Skillen et al. (2013). Where it fails: it moves volume, so long runs creep.
#include <riffle/weakly_compressible.hpp>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct Shifting {
  static constexpr auto id = "shifting", kind = "filter", version = "1.0.0";
  static constexpr auto summary = "Particles move a little from where they crowd to where they are rare";
  static constexpr auto source = "Lind et al. (2012) eqs 21-24; Skillen et al. (2013) eq. 13";
  static constexpr auto leaves_out = "what moves with the particles; shifting along the free surface";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::real("strength", "1", 2, 0, 10, "A: 1 to 6 in use"),
      riffle::real("surface", "1", 0.9, 0, 1.2, "kernel sum below which a particle belongs to the surface"),
      riffle::integer("every", 1, 1, 1, "steps from one shift to the next"),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.5, 10, "smoothing length over spacing")};

  static constexpr riffle_field crowding =
      riffle::vector_field("crowding", "m-1", "gradient of the concentration of particles");

  struct Gather {
    static constexpr auto pass_name = "crowding";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_OCCASIONAL;
    static constexpr auto every = "every";
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel_gradient), riffle::at_j(wc::particle_volume),
                                            riffle::pair(f::separation), riffle::pair(f::distance_squared),
                                            riffle::at_i(f::smoothing_length)};
    static constexpr riffle_write writes[] = {riffle::sum(crowding)};
    static void run(const Shifting& s, const riffle::Block& b) {
      const double *gradient = b.in(0), *volume = b.in(1), *r2 = b.in(3), *l = b.in(4);
      const double spacing2 = 1 / (s.smoothing_ratio * s.smoothing_ratio);
      for (int c = 0; c < b.dim(); ++c) {
        const double* x = b.in(2, c);
        double* out = b.out(0, c);
        RIFFLE_EACH(k, b) {
          // (W / W(dx))^4 by a bell of the same width as the kernel's fourth power
          const double q2 = (r2[k] - spacing2 * l[k] * l[k]) / (l[k] * l[k]);
          const double near = 1 / (1 + (q2 > -0.5 ? q2 : -0.5)), push = near * near * near * near;
          out[k] = (1 + 0.2 * push) * volume[k] * gradient[k] * x[k];
        }
      }
    }
  };
  struct Move {
    static constexpr auto pass_name = "shift";
    static constexpr std::uint32_t pass_flags = RIFFLE_OCCASIONAL;
    static constexpr auto every = "every";
    static constexpr riffle_read reads[] = {riffle::at_i(crowding), riffle::at_i(f::position),
                                            riffle::at_i(f::velocity), riffle::at_i(f::smoothing_length),
                                            riffle::at_i(f::kernel_sum)};
    static constexpr riffle_write writes[] = {riffle::set(f::position)};
    static void run(const Shifting& s, const riffle::Block& b) {
      const int dim = b.dim();
      const double *l = b.in(3), *sum = b.in(4), dt = b.dt(), strength = s.strength, surface = s.surface;
      const double most = 0.2 / s.smoothing_ratio;
      RIFFLE_EACH(k, b) {
        double u2 = 0, g2 = 0;
        for (int c = 0; c < dim; ++c) {
          u2 += b.in(2, c)[k] * b.in(2, c)[k];
          g2 += b.in(0, c)[k] * b.in(0, c)[k];
        }
        const double wanted = strength * l[k] * std::sqrt(u2) * dt, size = wanted * std::sqrt(g2);
        const double factor = sum[k] < surface ? 0.0 : size > most * l[k] ? wanted * most * l[k] / size : wanted;
        for (int c = 0; c < dim; ++c) b.out(0, c)[k] = b.in(1, c)[k] - factor * b.in(0, c)[k];
      }
    }
  };
  using passes = riffle::Passes<Gather, Move>;

  explicit Shifting(const riffle::Values& v)
      : strength(v.number("strength")), surface(v.number("surface")), smoothing_ratio(v.number("smoothing_ratio")) {}
  double strength, surface, smoothing_ratio;
};

RIFFLE_PLUGIN(Shifting)
