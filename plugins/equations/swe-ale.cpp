// Shallow-water equations in one dimension as SPH-ALE: particles carry water through a flow of their own, and exchange
// volume and momentum by Riemann fluxes between them (Vila 1999).
//
//   dx_i/dt = w_i,  d omega_i/dt = omega_i div w,  w = u ("lagrangian") or 0 ("fixed")
//   dm_i/dt = - sum_j 2 omega_i omega_j F^h_ij A_ij
//   dp_i/dt = - sum_j 2 omega_i omega_j (F^p_ij - g h_i^2 / 2) A_ij     (the last term only where there is a bed)
//   A_ij    = (B_i W'(x_ij, l_i) + B_j W'(x_ij, l_j)) / 2,  1 / B_i = sum_j omega_j (x_j - x_i) W'(x_ij, l_i)
//
// omega is the length that a particle stands for, m = omega h its water, p = m u its momentum. Fluxes are HLL ones in the
// frame (w_i + w_j) / 2, between states that are reconstructed from the particles in level, velocity and bed with
// gradients by SPH and a slope limiter (MUSCL). The fluxes of a pair are the same for both, so mass and, on a flat bed,
// momentum are kept to round-off. The support follows the length, l_i = eta omega_i, but never loses the nearest
// neighbours: at least 0.7 eta times the distance to either of them.
//
// Bed: both states are brought to the higher of the two beds, either at rest ("hydrostatic", Audusse et al. 2004: water
// at rest stays so wherever the particles are) or along the flow with its head ("energy": steady flow over a step stays
// so too); see riffle/shallow_faces.hpp and riffle/shallow_exchange.hpp. The bed's push on a particle is what its own side gains or loses on that way.
// Width: fluxes are multiplied by the width at the face, the mean of the two particles', and the walls push back with the
// pressure of either side, so that still water in a channel of any width stays still.
//
// Not in it: two dimensions. Fixed particles want equal spacing: where the lengths of neighbours differ, a uniform flow
// through them is kept only to first order. Lagrangian particles leak water at a tip on a dry bed.
#include <algorithm>
#include <cmath>
#include <riffle/limiters.hpp>
#include <riffle/sdk.hpp>
#include <riffle/shallow_exchange.hpp>

namespace f = riffle::fields;

namespace {

constexpr riffle_field extent_rate =
    riffle::scalar_field("extent_rate", "md.s-1", "rate of change of extent", RIFFLE_ACCUMULATES);
constexpr riffle_field volume_rate =
    riffle::scalar_field("volume_rate", "m.md.s-1", "rate of change of volume", RIFFLE_ACCUMULATES);
constexpr riffle_field momentum_rate =
    riffle::vector_field("momentum_rate", "m2.md.s-2", "rate of change of momentum", RIFFLE_ACCUMULATES);
constexpr riffle_field gradient_measure =
    riffle::scalar_field("gradient_measure", "1", "1 / B: what a gradient by SPH makes of the slope 1");
constexpr riffle_field renormalisation =
    riffle::scalar_field("renormalisation", "1", "B: factor that makes gradients by SPH right for linear fields");
constexpr riffle_field level_slope =
    riffle::vector_field("level_slope", "1", "gradient of the water level by SPH, not renormalised");
constexpr riffle_field velocity_slope{sizeof(riffle_field),
                                      RIFFLE_TENSOR,
                                      0,
                                      0,
                                      "velocity_slope",
                                      "s-1",
                                      "gradient of the velocity by SPH, not renormalised"};
constexpr riffle_field bed_rise =
    riffle::vector_field("bed_rise", "1", "gradient of the bed level by SPH, not renormalised");
constexpr riffle_field left_spacing =
    riffle::scalar_field("left_spacing", "m", "distance to the neighbour on the left");
constexpr riffle_field right_spacing =
    riffle::scalar_field("right_spacing", "m", "distance to the neighbour on the right");

}  // namespace

struct SweAle {
  static constexpr auto id = "swe-ale", kind = "equations", version = "1.0.0";
  static constexpr auto summary = "Shallow water by Riemann fluxes between moving or fixed particles (SPH-ALE)";
  static constexpr auto source = "Vila (1999); Audusse et al. (2004) for beds; Toro (2001) for HLL";
  static constexpr auto leaves_out = "two dimensions; fixed particles of unequal length are less accurate";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::choice("motion", "lagrangian|fixed", "lagrangian",
                     "particles move with the water, or stand still, which is more accurate but for thin tips"),
      riffle::choice("bed", "energy|hydrostatic", "energy",
                     "what is kept over a jump of the bed: the head of the flow, or only water at rest"),
      riffle::choice("limiter", riffle::limiter_choices, "van-leer", "slope limiter of the reconstruction"),
      riffle::real("dry_depth", "m", 1e-8, 0, 1, "water below this depth has no velocity", RIFFLE_ABOVE_MIN),
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.5, 10,
                        "eta: smoothing length over the particle's length; 0.8 to 1.3, best 1"),
      riffle::real("reference_width", "m", 1, 0, 1e6, "width of the channel that volumes are counted for",
                   RIFFLE_ABOVE_MIN)};
  static constexpr riffle_field initial[] = {f::depth, f::velocity};
  static constexpr const riffle_field* conserved = &f::volume;
  static constexpr auto requires_integrator = "ssp-rk2|ssp-rk3|predictor-corrector";
  static constexpr riffle_evolved evolved[] = {
      riffle::evolved_field(f::volume, volume_rate), riffle::evolved_field(f::momentum, momentum_rate, &f::drag_rate),
      riffle::evolved_field(f::extent, extent_rate, nullptr, "motion=lagrangian"),
      riffle::evolved_field(f::position, f::particle_velocity, nullptr, "motion=lagrangian")};

  static constexpr riffle_refusal refuses[] = {
      {sizeof(riffle_refusal), 0, "viscosity", nullptr, "its HLL fluxes dissipate already; use none"}};

  struct Start {
    static constexpr auto pass_name = "initial volume and momentum";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure), riffle::at_i(f::depth),
                                            riffle::at_i(f::velocity, RIFFLE_OPTIONAL),
                                            riffle::at_i(f::channel_width, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::set(f::extent), riffle::set(f::volume), riffle::set(f::momentum)};
    static void run(const SweAle& s, const riffle::Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) {
        b.out(0)[k] = b.in(0)[k];
        b.out(1)[k] = b.in(0)[k] * b.in(1)[k] * (b.has(3) ? b.in(3)[k] / s.rules.reference_width : 1.0);
        b.out(2)[k] = b.has(2) ? b.out(1)[k] * b.in(2)[k] : 0.0;
      }
    }
  };

  struct StandStill {
    static constexpr auto pass_name = "fixed particles";
    static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
    static constexpr auto when = "motion=fixed";
    static constexpr riffle_read reads[] = {riffle::at_i(f::cell_measure)};
    static constexpr riffle_write writes[] = {riffle::set(f::particle_velocity), riffle::set(f::smoothing_length)};
    static void run(const SweAle& s, const riffle::Block& b) {
      for (std::int64_t k = 0; k < b.size(); ++k) {
        b.out(0)[k] = 0;
        b.out(1)[k] = s.support(b.in(0)[k], 0, 0);
      }
    }
  };

  struct State {
    static constexpr auto pass_name = "depth and velocity";
    static constexpr riffle_read reads[] = {riffle::at_i(f::volume), riffle::at_i(f::extent), riffle::at_i(f::momentum),
                                            riffle::at_i(f::channel_width, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::set(f::depth), riffle::set(f::velocity),
                                              riffle::set(f::wave_speed)};
    static void run(const SweAle& s, const riffle::Block& b) {
      const double *volume = b.in(0), *extent = b.in(1), *momentum = b.in(2);
      double *depth = b.out(0), *velocity = b.out(1), *c = b.out(2);
      if (b.has(3)) {
        const double* width = b.in(3);
        RIFFLE_EACH(k, b) depth[k] = volume[k] * s.rules.reference_width / (extent[k] * width[k]);
      } else {
        RIFFLE_EACH(k, b) depth[k] = volume[k] / extent[k];
      }
      RIFFLE_EACH(k, b) {
        const double h = depth[k];
        velocity[k] = h > s.rules.dry_depth ? momentum[k] / volume[k] : 0.0;
        c[k] = std::sqrt(s.rules.gravity * h);
      }
    }
  };

  struct Move {
    static constexpr auto pass_name = "particles move with the water";
    static constexpr auto when = "motion=lagrangian";
    static constexpr riffle_read reads[] = {riffle::at_i(f::velocity)};
    static constexpr riffle_write writes[] = {riffle::set(f::particle_velocity)};
    static void run(const SweAle&, const riffle::Block& b) {
      const double* u = b.in(0);
      double* w = b.out(0);
      RIFFLE_EACH(k, b) w[k] = u[k];
    }
  };

  struct Support {  // with the spacings of the evaluation before: they change little, and the list needs the support
    static constexpr auto pass_name = "support";
    static constexpr auto when = "motion=lagrangian";
    static constexpr riffle_read reads[] = {riffle::at_i(f::extent), riffle::at_i(left_spacing, RIFFLE_PREVIOUS),
                                            riffle::at_i(right_spacing, RIFFLE_PREVIOUS)};
    static constexpr riffle_write writes[] = {riffle::set(f::smoothing_length)};
    static void run(const SweAle& s, const riffle::Block& b) {
      const double *extent = b.in(0), *left = b.in(1), *right = b.in(2);
      double* l = b.out(0);
      RIFFLE_EACH(k, b) l[k] = s.support(extent[k], left[k], right[k]);
    }
  };

  struct Spacings {
    static constexpr auto pass_name = "distances to the neighbours";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr auto when = "motion=lagrangian";
    static constexpr riffle_read reads[] = {riffle::pair(f::separation)};
    static constexpr riffle_write writes[] = {riffle::least(left_spacing), riffle::least(right_spacing)};
    static void run(const SweAle&, const riffle::Block& b) {
      const double* dx = b.in(0);
      double *left = b.out(0), *right = b.out(1);
      RIFFLE_EACH(k, b) {
        left[k] = dx[k] > 0 ? dx[k] : riffle::infinity;
        right[k] = dx[k] > 0 ? riffle::infinity : -dx[k];
      }
    }
  };

  struct Slopes {
    static constexpr auto pass_name = "slopes";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::pair(f::separation),
                                            riffle::at_i(f::kernel_gradient),
                                            riffle::at_j(f::extent),
                                            riffle::at_i(f::depth),
                                            riffle::at_j(f::depth),
                                            riffle::difference(f::velocity),
                                            riffle::at_i(f::bed_level, RIFFLE_OPTIONAL),
                                            riffle::at_j(f::bed_level, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::sum(level_slope), riffle::sum(velocity_slope)};
    static void run(const SweAle&, const riffle::Block& b) {
      const double *dx = b.in(0), *gradient = b.in(1), *extent = b.in(2), *h_i = b.in(3), *h_j = b.in(4), *du = b.in(5);
      double *level = b.out(0), *velocity = b.out(1);
      if (b.has(6)) {
        const double *b_i = b.in(6), *b_j = b.in(7);
        RIFFLE_EACH(k, b) {  // water that does not reach up to the other's bed has no level there
          const double top_i = h_i[k] + b_i[k], top_j = h_j[k] + b_j[k];
          const double apart = top_i < b_j[k] || top_j < b_i[k] ? 0.0 : top_i - top_j;
          level[k] = -extent[k] * gradient[k] * dx[k] * apart;
        }
      } else {
        RIFFLE_EACH(k, b) level[k] = -extent[k] * gradient[k] * dx[k] * (h_i[k] - h_j[k]);
      }
      RIFFLE_EACH(k, b) velocity[k] = -extent[k] * gradient[k] * dx[k] * du[k];
    }
  };

  struct BedRise {
    static constexpr auto pass_name = "slope of the bed";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t pass_flags = RIFFLE_IF_PROVIDED;
    static constexpr riffle_read reads[] = {riffle::pair(f::separation), riffle::at_i(f::kernel_gradient),
                                            riffle::at_j(f::extent), riffle::difference(f::bed_level)};
    static constexpr riffle_write writes[] = {riffle::sum(bed_rise)};
    static void run(const SweAle&, const riffle::Block& b) {
      const double *dx = b.in(0), *gradient = b.in(1), *extent = b.in(2), *rise = b.in(3);
      double* slope = b.out(0);
      RIFFLE_EACH(k, b) slope[k] = -extent[k] * gradient[k] * dx[k] * rise[k];
    }
  };

  struct Measure {
    static constexpr auto pass_name = "measure of gradients";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr riffle_read reads[] = {riffle::pair(f::distance_squared), riffle::at_i(f::kernel_gradient),
                                            riffle::at_j(f::extent)};
    static constexpr riffle_write writes[] = {riffle::sum(gradient_measure)};
    static void run(const SweAle&, const riffle::Block& b) {
      const double *r2 = b.in(0), *gradient = b.in(1), *extent = b.in(2);
      double* measure = b.out(0);
      RIFFLE_EACH(k, b) measure[k] = -extent[k] * gradient[k] * r2[k];
    }
  };

  struct Renormalise {
    static constexpr auto pass_name = "renormalisation";
    static constexpr riffle_read reads[] = {riffle::at_i(gradient_measure)};
    static constexpr riffle_write writes[] = {riffle::set(renormalisation)};
    static void run(const SweAle&, const riffle::Block& b) {
      const double* measure = b.in(0);
      double* factor = b.out(0);
      RIFFLE_EACH(k, b) factor[k] = measure[k] > 0 ? 1 / measure[k] : 0.0;  // 0: alone
    }
  };

  // Buffers beyond an open end are what the boundary makes of them, all alike, and see nothing themselves.
  struct Buffers {
    static constexpr auto pass_name = "buffers are level";
    static constexpr std::uint32_t targets = RIFFLE_INFLOW | RIFFLE_OUTFLOW;
    static constexpr riffle_read reads[] = {riffle::at_i(f::depth)};
    static constexpr riffle_write writes[] = {riffle::set(level_slope), riffle::set(velocity_slope),
                                              riffle::set(bed_rise), riffle::set(renormalisation)};
    static void run(const SweAle&, const riffle::Block& b) {
      for (int k = 0; k < 4; ++k) std::fill_n(b.out(k), b.size(), 0.0);
    }
  };

  struct Stretch {
    static constexpr auto pass_name = "stretching";
    static constexpr auto when = "motion=lagrangian";
    static constexpr riffle_read reads[] = {riffle::at_i(f::extent), riffle::at_i(renormalisation),
                                            riffle::at_i(velocity_slope)};
    static constexpr riffle_write writes[] = {riffle::sum(extent_rate)};
    static void run(const SweAle&, const riffle::Block& b) {
      const double *extent = b.in(0), *factor = b.in(1), *slope = b.in(2);
      double* rate = b.out(0);
      RIFFLE_EACH(k, b) rate[k] += extent[k] * factor[k] * slope[k];
    }
  };

  struct Exchange {
    static constexpr auto pass_name = "exchange of volume and momentum";
    static constexpr auto pass_type = RIFFLE_PASS_PAIR;
    static constexpr std::uint32_t neighbours = RIFFLE_EITHER;
    static constexpr riffle_read reads[] = {riffle::pair(f::separation),
                                            riffle::at_i(f::kernel_gradient),
                                            riffle::at_j(f::kernel_gradient),
                                            riffle::at_i(f::extent),
                                            riffle::at_j(f::extent),
                                            riffle::at_i(renormalisation),
                                            riffle::at_j(renormalisation),
                                            riffle::at_i(f::depth),
                                            riffle::at_j(f::depth),
                                            riffle::at_i(f::velocity),
                                            riffle::at_j(f::velocity),
                                            riffle::at_i(level_slope),
                                            riffle::at_j(level_slope),
                                            riffle::at_i(velocity_slope),
                                            riffle::at_j(velocity_slope),
                                            riffle::at_i(f::bed_level, RIFFLE_OPTIONAL),
                                            riffle::at_j(f::bed_level, RIFFLE_OPTIONAL),
                                            riffle::at_i(bed_rise, RIFFLE_OPTIONAL),
                                            riffle::at_j(bed_rise, RIFFLE_OPTIONAL),
                                            riffle::at_i(f::channel_width, RIFFLE_OPTIONAL),
                                            riffle::at_j(f::channel_width, RIFFLE_OPTIONAL)};
    static constexpr riffle_write writes[] = {riffle::sum(volume_rate), riffle::sum(momentum_rate)};
    static void run(const SweAle& s, const riffle::Block& b) {
      const auto optional = [&](int k) { return b.has(k) ? b.in(k) : nullptr; };
      const riffle::ShallowPairs pairs{b.in(0),      b.in(7),      b.in(8),  b.in(9),      b.in(10),
                                       optional(15), optional(16), b.in(5),  b.in(6),      b.in(11),
                                       b.in(12),     b.in(13),     b.in(14), optional(17), optional(18)};
      const riffle::PairWeights weights{b.in(1), b.in(2), b.in(3), b.in(4), optional(19), optional(20)};
      riffle::with_limiter(s.limiter, [&](auto limiter) {
        riffle::ShallowFaces faces;
        for (std::int64_t first = 0; first < b.size(); first += faces.capacity) {
          const std::int64_t left = b.size() - first, n = left < faces.capacity ? left : faces.capacity;
          double *volume = b.out(0) + first, *momentum = b.out(1) + first;
          if (pairs.b_i != nullptr) {
            riffle::reconstruct<true>(pairs, first, n, limiter, faces);
            s.rules.keeps_head ? riffle::head_to_common_bed(s.rules.gravity, n, faces)
                               : riffle::still_water_to_common_bed(n, faces);
            riffle::exchange<true>(s.rules, pairs, weights, first, n, faces, volume, momentum);
          } else {
            riffle::reconstruct<false>(pairs, first, n, limiter, faces);
            riffle::exchange<false>(s.rules, pairs, weights, first, n, faces, volume, momentum);
          }
        }
      });
    }
  };
  using passes = riffle::Passes<Start, StandStill, State, Move, Support, Spacings, Slopes, BedRise, Measure,
                                Renormalise, Buffers, Stretch, Exchange>;

  struct Acoustic {
    static constexpr auto name = "acoustic";
    static constexpr riffle_read reads[] = {riffle::at_i(f::extent), riffle::at_i(f::velocity),
                                            riffle::at_i(f::wave_speed)};
    static double limit(const SweAle& s, const riffle::Block& b) {
      const double *extent = b.in(0), *u = b.in(1), *c = b.in(2);
      const double through = s.rules.moving ? 0.0 : 1.0;
      double least = riffle::infinity;
      RIFFLE_EACH_LEAST(k, b, least) {
        const double speed = c[k] + through * std::abs(u[k]);
        least = extent[k] < least * speed ? extent[k] / speed : least;
      }
      return least;
    }
  };
  using votes = riffle::Votes<Acoustic>;

  // Smoothing length of a particle of that length, with its neighbours that far away (0: not known). A hair less than eta
  // lengths: else round-off decides whether the next but one on a lattice, whose kernel is 0, is visited.
  [[nodiscard]] double support(double extent, double left, double right) const {
    const double l = smoothing_ratio * extent * (1 - 1e-9), least_left = 0.7 * smoothing_ratio * left;
    const double least_right = 0.7 * smoothing_ratio * right;
    const double wider = least_left > l && least_left < riffle::infinity ? least_left : l;
    return least_right > wider && least_right < riffle::infinity ? least_right : wider;
  }

  explicit SweAle(const riffle::Values& v)
      : rules{v.number("gravity"), v.number("dry_depth"), v.number("reference_width"), v.word("motion") == "lagrangian",
              v.word("bed") == "energy"},
        smoothing_ratio(v.number("smoothing_ratio")),
        limiter(riffle::limiter_of(v.word("limiter"))) {}
  riffle::ExchangeRules rules;
  double smoothing_ratio;
  riffle::Limiter limiter;
};

RIFFLE_PLUGIN(SweAle)
