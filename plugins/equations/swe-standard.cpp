// Shallow-water equations in the standard SPH form of Diwakar & Mohapatra (2023), eqs 4, 5, 8 and 12.
//
//   h_i  = sum_j V_j W(x_ij, l_i)                                                        (5)
//   a_i  = -sum_j V_j (g + Pi_ij / h_ij) grad W(x_ij, l_i) - g grad b_i                  (4, 8)
//   grad b_i: of the bed averaged with the kernel (smoothed), at the particle (pointwise),
//             or sum_j b_j V_j / h_j grad W (particle-sum)                               (9, 10)
//   l_i  = l0 (constant) | l0 h0 / h_i (inverse-depth) | l0 h_i / h0 (depth: eq. 12 as printed)
//
// Put right against the print: Pi has the unit m2/s2 and must be divided by the pair-mean depth h_ij; eq. 12 is
// inverted (the support must grow where water thins, or particles lose their neighbours); the bed slope enters with a
// minus sign. Friction (eq. 11) is a drag plugin.
// Not in it: the grad-h terms of a variable support. With one, the gather form of eq. 8 does not conserve momentum, and
// shocks stand at the wrong place; use it on dry beds, where it follows the thin tip, and a constant support for shocks.
#include <cmath>
#include <riffle/sdk.hpp>

namespace f = riffle::fields;

struct SweStandard {
  static constexpr auto id = "swe-standard", kind = "equations", version = "1.0.0";
  static constexpr auto summary = "Shallow-water equations, summation depth, gather form";
  static constexpr auto source = "Diwakar & Mohapatra (2023) eqs 4, 5, 8, 12; Wang & Shen (1999)";
  static constexpr auto leaves_out =
      "grad-h terms: momentum is conserved with constant support only; non-hydrostatic pressure";
  static constexpr std::uint32_t dims = 1u << 1 | 1u << 2;

  static constexpr riffle_parameter parameters[] = {
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.5, 10,
                        "smoothing length over spacing at t = 0"),
      riffle::choice(
          "support", "constant|inverse-depth|depth", "constant",
          "law of the smoothing length: constant for shocks, inverse-depth for dry beds, depth is the paper's eq. 12"),
      riffle::choice("bed", "smoothed|pointwise|particle-sum", "smoothed",
                     "slope of the bed: as the summation depth sees it; at the particle; or the paper's eqs 9 and 10"),
      riffle::real("largest_support", "1", 1000, 1, 1e6, "bound on smoothing length over its initial value"),
      riffle::real("support_tolerance", "1", 1e-3, 1e-14, 1,
                   "relative change of the support at which the iteration stops"),
      riffle::integer("support_iterations", 1, 1, 100, "largest number of iterations of support and depth per step")};
  static constexpr riffle_field initial[] = {f::depth, f::velocity};
  static constexpr const riffle_field* conserved = &f::volume;
  static constexpr riffle_evolved evolved[] = {riffle::evolved_field(f::velocity, f::acceleration, &f::drag_rate),
                                               riffle::evolved_field(f::position, f::velocity)};

  // l0 h0 or l0 / h0: what the support laws need to know of t = 0.
  static constexpr riffle_field support_constant =
      riffle::scalar_field("support_constant", "m2", "smoothing length times depth at t = 0");
  static constexpr riffle_field initial_support =
      riffle::scalar_field("initial_support", "m", "smoothing length at t = 0");
  static constexpr riffle_field support_change =
      riffle::scalar_field("support_change", "1", "relative change of the smoothing length in the last iteration");
  static constexpr riffle_iteration iterations[] = {
      {sizeof(riffle_iteration), 0, "support", &support_change, "support_tolerance", "support_iterations"}};

  struct Start {
    static constexpr auto pass_name = "initial volume and support";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure), riffle::at_i(f::depth)};
    static constexpr riffle_write writes[] = {riffle::set(f::volume), riffle::set(f::smoothing_length),
                                              riffle::set(initial_support), riffle::set(support_constant)};
    static void run(const SweStandard& s, const riffle::Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) {
        const double spacing = b.dim() == 1 ? b.in(0)[k] : std::sqrt(b.in(0)[k]);
        const double l = s.smoothing_ratio * spacing;
        b.out(0)[k] = b.in(1)[k] * b.in(0)[k];
        b.out(1)[k] = l;
        b.out(2)[k] = l;
        b.out(3)[k] = l * b.in(1)[k];
      }
    }
  };

  struct Depth {
    static constexpr auto pass_name = "depth";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_WITH_SELF;
    static constexpr auto iteration = "support";
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::at_i(f::kernel, RIFFLE_PREVIOUS)};
    static constexpr riffle_write writes[] = {riffle::sum(f::depth)};
    static void run(const SweStandard&, const riffle::Block& b) {
      const double *volume = b.in(0), *w = b.in(1);
      double* depth = b.out(0);
      RIFFLE_EACH(k, b) depth[k] = volume[k] * w[k];
    }
  };

  struct Support {
    static constexpr auto pass_name = "support";
    static constexpr auto iteration = "support";
    static constexpr auto when = "support=inverse-depth|depth";
    static constexpr riffle_read reads[] = {riffle::at_i(f::depth), riffle::at_i(support_constant),
                                            riffle::at_i(initial_support),
                                            riffle::at_i(f::smoothing_length, RIFFLE_PREVIOUS)};
    static constexpr riffle_write writes[] = {riffle::set(f::smoothing_length), riffle::set(support_change)};
    static void run(const SweStandard& s, const riffle::Block& b) {
      const double *depth = b.in(0), *constant = b.in(1), *l0 = b.in(2), *before = b.in(3);
      double *l = b.out(0), *change = b.out(1);
      for (std::int64_t k = 0; k < b.size(); ++k) {
        const double previous = before[k];
        const double law = s.inverse ? constant[k] / depth[k] : l0[k] * l0[k] * depth[k] / constant[k];
        const double bounded = law < s.largest_support * l0[k] ? law : s.largest_support * l0[k];
        l[k] = bounded;
        change[k] = bounded / previous - 1;
      }
    }
  };

  struct WaveSpeed {
    static constexpr auto pass_name = "wave speed";
    static constexpr riffle_read reads[] = {riffle::at_i(f::depth)};
    static constexpr riffle_write writes[] = {riffle::set(f::wave_speed)};
    static void run(const SweStandard& s, const riffle::Block& b) {
      const double* depth = b.in(0);
      double* c = b.out(0);
      RIFFLE_EACH(k, b) c[k] = std::sqrt(s.gravity * depth[k]);
    }
  };

  struct Momentum {
    static constexpr auto pass_name = "momentum";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::at_i(f::kernel_gradient),
                                            riffle::pair(f::separation),
                                            riffle::pair(f::viscous_pressure, RIFFLE_OPTIONAL), riffle::mean(f::depth)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const SweStandard& s, const riffle::Block& b) {
      const double *volume = b.in(0), *gradient = b.in(1), *depth = b.in(4);
      const double g = s.gravity;
      for (int c = 0; c < b.dim(); ++c) {
        const double* dx = b.in(2, c);
        double* a = b.out(0, c);
        if (b.has(3)) {
          const double* viscous = b.in(3);
          RIFFLE_EACH(k, b) a[k] = -volume[k] * (g + viscous[k] / depth[k]) * gradient[k] * dx[k];
        } else {
          RIFFLE_EACH(k, b) a[k] = -volume[k] * g * gradient[k] * dx[k];
        }
      }
    }
  };

  // Balanced only when the depth sees the same bed: a slope taken at the particle sets a lake over a step in motion.
  static void slide(const SweStandard& s, const riffle::Block& b) {
    for (int c = 0; c < b.dim(); ++c) {
      const double* slope = b.in(0, c);
      double* a = b.out(0, c);
      RIFFLE_EACH(k, b) a[k] -= s.gravity * slope[k];
    }
  }
  struct SmoothedSlope {
    static constexpr auto pass_name = "smoothed bed slope";
    static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
    static constexpr auto when = "bed=smoothed";
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothed_bed_slope)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const SweStandard& s, const riffle::Block& b) { slide(s, b); }
  };
  struct PointwiseSlope {
    static constexpr auto pass_name = "bed slope at the particle";
    static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
    static constexpr auto when = "bed=pointwise";
    static constexpr riffle_read reads[] = {riffle::at_i(f::bed_slope)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const SweStandard& s, const riffle::Block& b) { slide(s, b); }
  };
  struct SummedSlope {  // eqs 9 and 10: V_j / h_j is the length that particle j takes of the bed
    static constexpr auto pass_name = "bed slope as a sum over particles";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
    static constexpr auto when = "bed=particle-sum";
    static constexpr riffle_read reads[] = {riffle::at_j(f::volume), riffle::at_j(f::depth), riffle::at_j(f::bed_level),
                                            riffle::at_i(f::kernel_gradient), riffle::pair(f::separation)};
    static constexpr riffle_write writes[] = {riffle::sum(f::acceleration)};
    static void run(const SweStandard& s, const riffle::Block& b) {
      const double *volume = b.in(0), *depth = b.in(1), *bed = b.in(2), *gradient = b.in(3), g = s.gravity;
      for (int c = 0; c < b.dim(); ++c) {
        const double* dx = b.in(4, c);
        double* a = b.out(0, c);
        RIFFLE_EACH(k, b) a[k] = -g * bed[k] * volume[k] / depth[k] * gradient[k] * dx[k];
      }
    }
  };
  using passes = riffle::Passes<Start, Depth, Support, WaveSpeed, Momentum, SmoothedSlope, PointwiseSlope, SummedSlope>;

  struct Acoustic {  // eq. 16
    static constexpr auto name = "acoustic";
    static constexpr riffle_read reads[] = {riffle::at_i(f::smoothing_length), riffle::at_i(f::velocity),
                                            riffle::at_i(f::wave_speed)};
    static double limit(const SweStandard&, const riffle::Block& b) {
      const double *l = b.in(0), *u = b.in(1), *v = b.dim() == 2 ? b.in(1, 1) : b.in(1), *c = b.in(2);
      const double second = b.dim() == 2 ? 1.0 : 0.0;
      double least = riffle::infinity;
      RIFFLE_EACH_LEAST(k, b, least) {
        const double dt = l[k] / (std::sqrt(u[k] * u[k] + second * v[k] * v[k]) + c[k]);
        least = dt < least ? dt : least;
      }
      return least;
    }
  };
  using votes = riffle::Votes<Acoustic>;

  explicit SweStandard(const riffle::Values& v)
      : gravity(v.number("gravity")),
        smoothing_ratio(v.number("smoothing_ratio")),
        largest_support(v.number("largest_support")),
        inverse(v.word("support") == "inverse-depth") {}
  double gravity, smoothing_ratio, largest_support;
  bool inverse;
};

RIFFLE_PLUGIN(SweStandard)
