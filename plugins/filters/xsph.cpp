// XSPH: particles move with a mean of their own velocity and those around them, which keeps them in order.
//
//   dx_i/dt = u_i - epsilon sum_j V_j (u_i - u_j) W   over the water
//
// applied to the positions after each step. Velocities stay as they are, so momentum does.
// Source: Monaghan (1989). Not in it: the term of energy that makes it conservative.
#include <riffle/weakly_compressible.hpp>

namespace f = riffle::fields;
namespace wc = riffle::wc;

struct Xsph {
  static constexpr auto id = "xsph", kind = "filter", version = "1.0.0";
  static constexpr auto summary = "Particles move with a mean of the velocities around them";
  static constexpr auto source = "Monaghan (1989)";
  static constexpr auto leaves_out = "the term that makes it conserve energy";
  static constexpr std::uint32_t dims = 1u << 2 | 1u << 3;
  static constexpr riffle_parameter parameters[] = {
      riffle::real("epsilon", "1", 0.5, 0, 1, "share of the mean: 0 moves particles with their own velocity"),
      riffle::integer("every", 1, 1, 1, "steps from one correction to the next")};

  static constexpr riffle_field lag =
      riffle::vector_field("xsph_lag", "m.s-1", "sum over the water of V (u_i - u_j) W");

  struct Gather {
    static constexpr auto pass_name = "velocity against those around";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_OCCASIONAL, sources = wc::water;
    static constexpr auto every = "every";
    static constexpr riffle_read reads[] = {riffle::at_i(f::kernel), riffle::at_j(wc::particle_volume),
                                            riffle::difference(f::velocity)};
    static constexpr riffle_write writes[] = {riffle::sum(lag)};
    static void run(const Xsph&, const riffle::Block& b) {
      const double *w = b.in(0), *volume = b.in(1);
      for (int c = 0; c < b.dim(); ++c) RIFFLE_EACH(k, b) b.out(0, c)[k] = volume[k] * w[k] * b.in(2, c)[k];
    }
  };
  struct Move {
    static constexpr auto pass_name = "xsph";
    static constexpr std::uint32_t pass_flags = RIFFLE_OCCASIONAL;
    static constexpr auto every = "every";
    static constexpr riffle_read reads[] = {riffle::at_i(lag), riffle::at_i(f::position)};
    static constexpr riffle_write writes[] = {riffle::set(f::position)};
    static void run(const Xsph& s, const riffle::Block& b) {
      const double by = s.epsilon * b.dt();
      for (int c = 0; c < b.dim(); ++c) RIFFLE_EACH(k, b) b.out(0, c)[k] = b.in(1, c)[k] - by * b.in(0, c)[k];
    }
  };
  using passes = riffle::Passes<Gather, Move>;

  explicit Xsph(const riffle::Values& v) : epsilon(v.number("epsilon")) {}
  double epsilon;
};

RIFFLE_PLUGIN(Xsph)
