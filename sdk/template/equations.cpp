// What the equation set is, in one line; author (year), equations. This one is the shallow-water equations on a
// horizontal bed with a constant smoothing length:
//
//   h_i = sum_j V_j W_ij,   du_i/dt = -sum_j V_j (g + viscous_pressure_ij / h_ij) grad W_ij,   dx_i/dt = u_i
//
// Nothing says in which order the passes run: that follows from what they read and write. `riffle explain case.toml`
// shows what the host makes of it.
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;  // what there is to read and write: riffle/fields.h

struct MyPlugin {
  static constexpr auto id = "my-plugin", kind = "equations", version = "0.1.0";
  static constexpr auto summary = "One line for `riffle list`";
  static constexpr auto source = "Author (year), equations";
  static constexpr auto leaves_out = "what the model does not contain, and where it fails; here: bed slope";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;  // scenes in one and two dimensions

  static constexpr riffle_parameter parameters[] = {
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.5, 10, "smoothing length over spacing")};

  static constexpr riffle_field initial[] = {f::depth, f::velocity};  // what [initial] of a manifest gives
  static constexpr const riffle_field* conserved = &f::volume;        // what the ledger counts
  static constexpr riffle_evolved evolved[] = {riffle::evolved_field(f::velocity, f::acceleration, &f::drag_rate),
                                               riffle::evolved_field(f::position, f::velocity)};

  struct Start {
    static constexpr auto pass_name = "volume and smoothing length";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure), riffle::at_i(f::depth)};
    static constexpr riffle_write writes[] = {riffle::set(f::volume), riffle::set(f::smoothing_length)};
    static void run(const MyPlugin& p, const riffle::Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) {
        const double cell = b.in(0)[k], spacing = b.dim() == 1 ? cell : std::sqrt(cell);
        b.out(0)[k] = b.in(1)[k] * cell;
        b.out(1)[k] = p.smoothing_ratio * spacing;
      }
    }
  };

  struct Depth {
    static constexpr auto pass_name = "depth";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_WITH_SELF;  // the pair of a particle with itself counts
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::at_i(f::kernel)};
    static constexpr riffle_write writes[] = {riffle::sum(f::depth)};
    static void run(const MyPlugin&, const riffle::Block& b) {
      const double *volume = b.in(0), *w = b.in(1);
      double* depth = b.out(0);
      RIFFLE_EACH(k, b) depth[k] = volume[k] * w[k];
    }
  };

  struct WaveSpeed {
    static constexpr auto pass_name = "wave speed";
    static constexpr riffle_read reads[] = {riffle::at_i(f::depth)};
    static constexpr riffle_write writes[] = {riffle::set(f::wave_speed)};
    static void run(const MyPlugin& p, const riffle::Block& b) {
      const double* depth = b.in(0);
      double* c = b.out(0);
      RIFFLE_EACH(k, b) c[k] = std::sqrt(p.gravity * depth[k]);
    }
  };

  struct Momentum {
    static constexpr auto pass_name = "momentum";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::at_i(f::kernel_gradient),
                                            riffle::pair(f::separation), riffle::mean(f::depth),
                                            riffle::pair(f::viscous_pressure, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const MyPlugin& p, const riffle::Block& b) {
      const double *volume = b.in(0), *gradient = b.in(1), *depth = b.in(3);
      const double g = p.gravity;
      for (int c = 0; c < b.dim(); ++c) {
        const double* dx = b.in(2, c);
        double* a = b.out(0, c);
        if (b.has(4)) {  // somebody gives a viscosity
          const double* viscous = b.in(4);
          RIFFLE_EACH(k, b) a[k] = -volume[k] * (g + viscous[k] / depth[k]) * gradient[k] * dx[k];
        } else {
          RIFFLE_EACH(k, b) a[k] = -volume[k] * g * gradient[k] * dx[k];
        }
      }
    }
  };
  using passes = riffle::Passes<Start, Depth, WaveSpeed, Momentum>;

  struct Acoustic {  // the largest stable step, before it is multiplied by time.cfl
    static constexpr auto name = "acoustic";
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::velocity),
                                            riffle::at_i(f::wave_speed)};
    static double limit(const MyPlugin&, const riffle::Block& b) {
      double least = riffle::infinity;
      for (std::int64_t k = 0; k < b.size(); ++k) {
        double u2 = 0;
        for (int c = 0; c < b.dim(); ++c) u2 += b.in(1, c)[k] * b.in(1, c)[k];
        least = std::fmin(least, b.in(0)[k] / (std::sqrt(u2) + b.in(2)[k]));
      }
      return least;
    }
  };
  using votes = riffle::Votes<Acoustic>;

  explicit MyPlugin(const riffle::Values& v)
      : gravity(v.number("gravity")), smoothing_ratio(v.number("smoothing_ratio")) {}
  double gravity, smoothing_ratio;
};

RIFFLE_PLUGIN(MyPlugin)
