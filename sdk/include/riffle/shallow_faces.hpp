// riffle/shallow_faces.hpp: both sides of the faces between pairs of shallow-water particles, reconstructed from the
// particles and brought to a common bed, so that a Riemann solver can do the rest.
//
// A face lies between a particle on its left and one on its right. Level, velocity and bed of each side are those of the
// particle plus half a limited difference, phi(2 slope dx - d, d) / 2 with d the difference across the face (MUSCL):
// where particles are equally spaced 2 slope dx - d is the difference on the particle's other side.
//
// Where the bed jumps both sides are brought to the higher bed b* = max(b_L, b_R),
//   as still water   h* = max(0, h + b - b*), u* = u                             (Audusse et al. 2004)
//   with their head  h* + u*^2 / 2g = h + b - b* + u^2 / 2g, h* u* = h u, sub- or supercritical as before. Where the
//                    head does not carry the flow over b*, the critical flow that it does carry, as over a weir.
// Everything is done for a chunk of faces at a time, in arrays that stay in the first-level cache.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace riffle {

// Arrays over pairs (i, j): what the reconstruction reads. Slopes are without the factor of their particle.
struct ShallowPairs {
  const double* dx;                                                             // x_i - x_j
  const double *h_i, *h_j;                                                      // depth
  const double *u_i, *u_j;                                                      // velocity
  const double *b_i, *b_j;                                                      // level of the bed; null without one
  const double *factor_i, *factor_j;                                            // times a slope below: the gradient
  const double *level_i, *level_j, *velocity_i, *velocity_j, *rise_i, *rise_j;  // slopes of level, velocity and bed
};

struct ShallowFaces {
  static constexpr std::int64_t capacity = 64;
  struct Side {
    alignas(64) double h[capacity], u[capacity], b[capacity];
    alignas(64) double h_star[capacity], u_star[capacity];  // at the common bed
  };
  Side left, right;
  alignas(64) double rise[capacity];  // level of the side of i less the level of particle i
};

inline double bounded(double value, double least, double most) {
  const double up = value > least ? value : least;
  return up < most ? up : most;
}

// Faces of the pairs [first, first + n).
template <bool with_bed, class Limiter>
void reconstruct(const ShallowPairs& p, std::int64_t first, std::int64_t n, Limiter limiter, ShallowFaces& out) {
  const double *dx = p.dx + first, *h_i = p.h_i + first, *h_j = p.h_j + first, *u_i = p.u_i + first;
  const double *u_j = p.u_j + first, *factor_i = p.factor_i + first, *factor_j = p.factor_j + first;
  const double *level_i = p.level_i + first, *level_j = p.level_j + first;
  const double *velocity_i = p.velocity_i + first, *velocity_j = p.velocity_j + first;
  const double *b_i = with_bed ? p.b_i + first : h_i, *b_j = with_bed ? p.b_j + first : h_j;
  const double *rise_i = with_bed ? p.rise_i + first : h_i, *rise_j = with_bed ? p.rise_j + first : h_j;
#pragma omp simd
  for (std::int64_t k = 0; k < n; ++k) {
    const double twice_i = -2 * dx[k] * factor_i[k], twice_j = -2 * dx[k] * factor_j[k];  // from i to j
    const double bed_i = with_bed ? b_i[k] : 0.0, bed_j = with_bed ? b_j[k] : 0.0;
    const double top_i = h_i[k] + bed_i, top_j = h_j[k] + bed_j;
    const double d_level = top_j - top_i, d_u = u_j[k] - u_i[k], d_bed = bed_j - bed_i;
    const double up_i = top_i < bed_j ? 0.0 : 0.5 * limiter(twice_i * level_i[k] - d_level, d_level);
    const double up_j = top_j < bed_i ? 0.0 : 0.5 * limiter(twice_j * level_j[k] - d_level, d_level);
    const double faster_i = 0.5 * limiter(twice_i * velocity_i[k] - d_u, d_u);
    const double faster_j = 0.5 * limiter(twice_j * velocity_j[k] - d_u, d_u);
    const double bend_i = with_bed ? 0.5 * limiter(twice_i * rise_i[k] - d_bed, d_bed) : 0.0;
    const double bend_j = with_bed ? 0.5 * limiter(twice_j * rise_j[k] - d_bed, d_bed) : 0.0;
    const double higher_i = bounded(bend_i, up_i - h_i[k], up_i + h_i[k]);
    const double higher_j = bounded(bend_j, up_j - h_j[k], up_j + h_j[k]);
    const double at_i = h_i[k] + (up_i - higher_i), at_j = h_j[k] - (up_j - higher_j);
    const double face_i = at_i > 0 ? at_i : 0.0, face_j = at_j > 0 ? at_j : 0.0;
    const double speed_i = face_i > 0 ? u_i[k] + faster_i : 0.0, speed_j = face_j > 0 ? u_j[k] - faster_j : 0.0;
    const bool i_is_left = dx[k] < 0;
    out.left.h[k] = i_is_left ? face_i : face_j;
    out.right.h[k] = i_is_left ? face_j : face_i;
    out.left.u[k] = i_is_left ? speed_i : speed_j;
    out.right.u[k] = i_is_left ? speed_j : speed_i;
    out.rise[k] = up_i;
    if (with_bed) {
      out.left.b[k] = i_is_left ? bed_i + higher_i : bed_j - higher_j;
      out.right.b[k] = i_is_left ? bed_j - higher_j : bed_i + higher_i;
    }
  }
}

inline void still_water_to_common_bed(std::int64_t n, ShallowFaces& faces) {
  const double *b_left = faces.left.b, *b_right = faces.right.b;
  for (ShallowFaces::Side* side : {&faces.left, &faces.right}) {
#pragma omp simd
    for (std::int64_t k = 0; k < n; ++k) {
      const double highest = b_left[k] > b_right[k] ? b_left[k] : b_right[k];
      const double h = side->h[k] - (highest - side->b[k]);
      side->h_star[k] = h > 0 ? h : 0.0;
      side->u_star[k] = side->u[k];
    }
  }
}

// h* is the root of p(h) = h^3 - e h^2 + q^2 / 2g, with e the head above the common bed. From e downwards Newton meets the
// subcritical root, from |q| / sqrt(2 g e) upwards the supercritical one, with p > 0 all the way. Each face stops by
// itself, so that its last bits do not depend on the others.
inline void head_to_common_bed(double g, std::int64_t n, ShallowFaces& faces) {
  constexpr int most_iterations = 50;  // 4 to 6 are usual; near the critical depth the error only halves each time
  const double *b_left = faces.left.b, *b_right = faces.right.b;
  alignas(64) double head[ShallowFaces::capacity], flow[ShallowFaces::capacity];
  alignas(64) double carried[ShallowFaces::capacity], searching[ShallowFaces::capacity];
  for (ShallowFaces::Side* side : {&faces.left, &faces.right}) {
    double left_over = 0;
#pragma omp simd reduction(+ : left_over)
    for (std::int64_t k = 0; k < n; ++k) {
      const double h = side->h[k], u = side->u[k], q = h * u, q2 = q * q / g;
      const double highest = b_left[k] > b_right[k] ? b_left[k] : b_right[k], step = highest - side->b[k];
      const double e = h - step + 0.5 * u * u / g, above = e > 0 ? e : 0.0;
      const double critical = 2 * above / 3, start = h * h * h > q2 ? e : std::sqrt(0.5 * q2 / (e > 0 ? e : 1.0));
      const bool enough = h > 0 && above * above * above > 3.375 * q2;
      carried[k] = step > 0 && enough ? 1.0 : 0.0;
      side->h_star[k] = step > 0 ? (enough ? start : critical) : h;
      side->u_star[k] = step > 0 ? std::copysign(std::sqrt(g * critical), u) : u;
      head[k] = e;
      flow[k] = q2;
      searching[k] = carried[k];
      left_over += carried[k];
    }
    if (left_over == 0) continue;
    for (int iteration = 0; iteration < most_iterations && left_over != 0; ++iteration) {
      left_over = 0;
#pragma omp simd reduction(+ : left_over)
      for (std::int64_t k = 0; k < n; ++k) {
        const double h = side->h_star[k], square = h * h, slope = square * h - flow[k];
        const double p = square * (h - head[k]) + 0.5 * flow[k];
        const double change = p > 0 && slope != 0 && searching[k] != 0 ? h * p / slope : 0.0;
        side->h_star[k] = h - change;
        searching[k] = std::abs(change) > 1e-9 * h ? 1.0 : 0.0;
        left_over += searching[k];
      }
    }
#pragma omp simd
    for (std::int64_t k = 0; k < n; ++k) {
      const double u = side->h[k] * side->u[k] / side->h_star[k];
      side->u_star[k] = carried[k] != 0 ? u : side->u_star[k];
    }
  }
}

}  // namespace riffle
