// What the filter does, in one line; author (year), equation. This one smooths velocities every few steps:
//
//   u_i <- u_i + strength sum_j (V_j / h_ij) (u_j - u_i) W_ij
//
// W at the mean smoothing length makes the exchange between i and j equal and opposite, so momentum is conserved; mass
// is not touched.
#include <riffle/sdk.hpp>

namespace f = riffle::fields;  // what there is to read and write: riffle/fields.h

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "filter", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equation; here the smoothing of Monaghan (1989), done to the velocity";
  static constexpr auto leaves_out = "what it does not contain, and where it fails: it dissipates";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;  // scenes in one and two dimensions

  static constexpr riffle_parameter parameters[] = {
      riffle::real("strength", "1", 0.1, 0, 1, "share of the difference to the neighbours that is taken away"),
      riffle::integer("steps", 10, 1, 1000000, "number of steps between two times")};

  // A field of its own: shape, unit and meaning are said here.
  static constexpr riffle_field correction =
      riffle::vector_field("velocity_correction", "m.s-1", "what the filter adds to the velocity");

  struct Gather {
    static constexpr auto pass_name = "velocity correction";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::mean(f::depth),
                                            riffle::difference(f::velocity), riffle::mean(f::kernel)};
    static constexpr riffle_write writes[] = {riffle::sum(correction)};
    static void run(const MyPlugin& p, const riffle::Block& b) {
      const double *volume = b.in(0), *depth = b.in(1), *w = b.in(3);
      const double strength = p.strength;
      for (int c = 0; c < b.dim(); ++c) {
        const double* u = b.in(2, c);
        double* sum = b.out(0, c);
        RIFFLE_EACH(k, b) sum[k] = -strength * volume[k] / depth[k] * u[k] * w[k];
      }
    }
  };

  struct Apply {
    static constexpr auto pass_name = "apply";
    static constexpr std::uint32_t pass_flags =
        RIFFLE_OCCASIONAL;                  // between steps; the pass above runs when this needs it
    static constexpr auto every = "steps";  // the parameter that says how often
    static constexpr riffle_read reads[] = {riffle::at_i(f::velocity), riffle::at_i(correction)};
    static constexpr riffle_write writes[] = {riffle::set(f::velocity)};
    static void run(const MyPlugin&, const riffle::Block& b) {
      for (int c = 0; c < b.dim(); ++c) {
        for (std::int64_t k = 0; k < b.size(); ++k) b.out(0, c)[k] = b.in(0, c)[k] + b.in(1, c)[k];
      }
    }
  };
  using passes = riffle::Passes<Gather, Apply>;

  explicit MyPlugin(const riffle::Values& v) : strength(v.number("strength")) {}
  double strength;
};

RIFFLE_PLUGIN(MyPlugin)
