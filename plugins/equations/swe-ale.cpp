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
// so too); see riffle/shallow_faces.hpp. The bed's push on a particle is what its own side gains or loses on that way.
// Width: fluxes are multiplied by the width at the face, the mean of the two particles', and the walls push back with the
// pressure of either side, so that still water in a channel of any width stays still.
//
// Not in it: two dimensions. Fixed particles want equal spacing: where the lengths of neighbours differ, a uniform flow
// through them is kept only to first order. Lagrangian particles leak water at a tip on a dry bed.
#include <algorithm>
#include <cmath>
#include <riffle/limiters.hpp>
#include <riffle/sdk.hpp>
#include <riffle/shallow_faces.hpp>
#include <riffle/shallow_riemann.hpp>

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
constexpr riffle_field velocity_slope =
    riffle::vector_field("velocity_slope", "s-1", "gradient of the velocity by SPH, not renormalised");
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
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity"),
      riffle::inherited("smoothing_ratio", "1", "domain.smoothing_ratio", 0.5, 10,
                        "eta: smoothing length over the particle's length; 0.8 to 1.3, best 1"),
      riffle::real("reference_width", "m", 1, 0, 1e6, "width of the channel that volumes are counted for",
                   RIFFLE_ABOVE_MIN)};
  static constexpr riffle_field initial[] = {f::depth, f::velocity};
  static constexpr const riffle_field* conserved = &f::volume;
  static constexpr auto requires_integrator = "predictor-corrector";
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
        b.out(1)[k] = b.in(0)[k] * b.in(1)[k] * (b.has(3) ? b.in(3)[k] / s.reference_width : 1.0);
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
        RIFFLE_EACH(k, b) depth[k] = volume[k] * s.reference_width / (extent[k] * width[k]);
      } else {
        RIFFLE_EACH(k, b) depth[k] = volume[k] / extent[k];
      }
      RIFFLE_EACH(k, b) {
        const double h = depth[k];
        velocity[k] = h > s.dry_depth ? momentum[k] / volume[k] : 0.0;
        c[k] = std::sqrt(s.gravity * h);
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
      const bool bed = b.has(15), width = b.has(19);
      const riffle::ShallowPairs pairs{
          b.in(0), b.in(7),  b.in(8),  b.in(9),  b.in(10), bed ? b.in(15) : nullptr, bed ? b.in(16) : nullptr, b.in(5),
          b.in(6), b.in(11), b.in(12), b.in(13), b.in(14), bed ? b.in(17) : nullptr, bed ? b.in(18) : nullptr};
      riffle::with_limiter(s.limiter, [&](auto limiter) {
        riffle::ShallowFaces faces;
        for (std::int64_t first = 0; first < b.size(); first += faces.capacity) {
          const std::int64_t left = b.size() - first, n = left < faces.capacity ? left : faces.capacity;
          if (!bed) {
            riffle::reconstruct<false>(pairs, first, n, limiter, faces);
            width ? exchange<false, true>(s, b, first, n, faces) : exchange<false, false>(s, b, first, n, faces);
            continue;
          }
          riffle::reconstruct<true>(pairs, first, n, limiter, faces);
          s.keeps_head ? riffle::head_to_common_bed(s.gravity, n, faces) : riffle::still_water_to_common_bed(n, faces);
          width ? exchange<true, true>(s, b, first, n, faces) : exchange<true, false>(s, b, first, n, faces);
        }
      });
    }

    template <bool with_bed, bool with_width>
    static void exchange(const SweAle& s, const riffle::Block& b, std::int64_t first, std::int64_t n,
                         const riffle::ShallowFaces& faces) {
      const double *dx = b.in(0) + first, *gradient_i = b.in(1) + first, *gradient_j = b.in(2) + first;
      const double *extent_i = b.in(3) + first, *extent_j = b.in(4) + first, *factor_i = b.in(5) + first;
      const double *factor_j = b.in(6) + first, *h_i = b.in(7) + first, *u_i = b.in(9) + first, *u_j = b.in(10) + first;
      const double *width_i = with_width ? b.in(19) + first : h_i, *width_j = with_width ? b.in(20) + first : h_i;
      double *volume = b.out(0) + first, *momentum = b.out(1) + first;
      const auto &left = faces.left, &right = faces.right;
      const double *h_left = with_bed ? left.h_star : left.h, *u_left = with_bed ? left.u_star : left.u;
      const double *h_right = with_bed ? right.h_star : right.h, *u_right = with_bed ? right.u_star : right.u;
      const double g = s.gravity, dry = s.dry_depth, moving = s.moving ? 0.5 : 0.0;
      const double head = with_bed && s.keeps_head ? 1.0 : 0.0, per_width = 1 / s.reference_width;
#pragma omp simd
      for (std::int64_t k = 0; k < n; ++k) {
        const double w = moving * (u_i[k] + u_j[k]);
        const bool i_is_left = dx[k] < 0;
        const double own = i_is_left ? h_left[k] : h_right[k], still = with_bed || with_width ? own : 0.0;
        const auto flux = riffle::hll_flux(g, {h_left[k], u_left[k]}, {h_right[k], u_right[k]}, w, still, dry);
        const double by_i = factor_i[k] * gradient_i[k], by_j = factor_j[k] > 0 ? factor_j[k] * gradient_j[k] : by_i;
        double face = extent_i[k] * extent_j[k] * (by_i + by_j) * dx[k];
        double thrust = 0, bend = 0;  // of the way from the particle to the face, and at the face
        if (with_bed || with_width) {
          const double h = i_is_left ? left.h[k] : right.h[k], u = i_is_left ? left.u[k] : right.u[k];
          const double u_star = i_is_left ? u_left[k] : u_right[k];
          thrust = 0.5 * g * (h + h_i[k]) * faces.rise[k];
          bend = head * (h * u * (u - w) - own * u_star * (u_star - w));
        }
        if (with_width) {
          const double width = 0.5 * (width_i[k] + width_j[k]);  // of the face
          thrust *= 0.5 * (width_i[k] + width) / width;
          face *= width * per_width;
        }
        volume[k] = -face * flux.volume;
        momentum[k] = -face * (flux.momentum + bend + thrust);
      }
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
      const double through = s.moving ? 0.0 : 1.0;
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
      : gravity(v.number("gravity")),
        smoothing_ratio(v.number("smoothing_ratio")),
        dry_depth(v.number("dry_depth")),
        reference_width(v.number("reference_width")),
        limiter(riffle::limiter_of(v.word("limiter"))),
        moving(v.word("motion") == "lagrangian"),
        keeps_head(v.word("bed") == "energy") {}
  double gravity, smoothing_ratio, dry_depth, reference_width;
  riffle::Limiter limiter;
  bool moving, keeps_head;
};

RIFFLE_PLUGIN(SweAle)
