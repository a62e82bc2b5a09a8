// riffle/shallow_exchange.hpp: what two shallow-water particles exchange through the face between them (SPH-ALE, Vila 1999).
//
//   dm_i/dt = - sum_j 2 omega_i omega_j F^h A_ij,   dp_i/dt = - sum_j 2 omega_i omega_j (F^p - C_i) A_ij
//   A_ij = (B_i W'(x_ij, l_i) + B_j W'(x_ij, l_j)) / 2
//
// Without bed and varying width C = 0, and the sums of m and p are kept to round-off. Otherwise C_i = g h_i^2 / 2, and with
// * for the states at the common bed and P = g h^2 / 2
//
//   F^p - C_i = [F^p* - P*] + [h u (u - w) - h* u* (u* - w)] + g/2 (h + h_i) ((h + b) - (h_i + b_i))
//
// all but F of the side of i; the second bracket is there when the head is kept. In still water each term is 0 by itself.
// With a width, F and the second bracket are multiplied by that of the face, the mean of the pair's, and the last term by
// the mean of particle and face: d(B P) - P dB, the push of the walls included.
#pragma once

#include "riffle/shallow_faces.hpp"
#include "riffle/shallow_riemann.hpp"

namespace riffle {

struct ExchangeRules {
  double gravity, dry_depth, reference_width;
  bool moving, keeps_head;  // faces move with the mean velocity of their particles; head_to_common_bed was used
};

// Arrays over pairs: what the weight of a face is made of.
struct PairWeights {
  const double *gradient_i, *gradient_j;  // (dW/dr) / r, with the smoothing length of either
  const double *extent_i, *extent_j;      // omega
  const double *width_i, *width_j;        // of the channel; null where it is the same everywhere
};

// Contributions to dm_i/dt and dp_i/dt of the pairs [first, first + n), whose faces are given.
template <bool with_bed, bool with_width>
void exchange_through(const ExchangeRules& rules, const ShallowPairs& p, const PairWeights& weights, std::int64_t first,
                      std::int64_t n, const ShallowFaces& faces, double* volume, double* momentum) {
  const double *dx = p.dx + first, *h_i = p.h_i + first, *u_i = p.u_i + first, *u_j = p.u_j + first;
  const double *factor_i = p.factor_i + first, *factor_j = p.factor_j + first;
  const double *gradient_i = weights.gradient_i + first, *gradient_j = weights.gradient_j + first;
  const double *extent_i = weights.extent_i + first, *extent_j = weights.extent_j + first;
  const double* width_i = with_width ? weights.width_i + first : h_i;
  const double* width_j = with_width ? weights.width_j + first : h_i;
  const auto &left = faces.left, &right = faces.right;
  const double *h_left = with_bed ? left.h_star : left.h, *u_left = with_bed ? left.u_star : left.u;
  const double *h_right = with_bed ? right.h_star : right.h, *u_right = with_bed ? right.u_star : right.u;
  const double g = rules.gravity, dry = rules.dry_depth, moving = rules.moving ? 0.5 : 0.0;
  const double head = with_bed && rules.keeps_head ? 1.0 : 0.0, per_width = 1 / rules.reference_width;
#pragma omp simd
  for (std::int64_t k = 0; k < n; ++k) {
    const double w = moving * (u_i[k] + u_j[k]);
    const bool i_is_left = dx[k] < 0;
    const double own = i_is_left ? h_left[k] : h_right[k], still = with_bed || with_width ? own : 0.0;
    const auto flux = hll_flux(g, {h_left[k], u_left[k]}, {h_right[k], u_right[k]}, w, still, dry);
    // a neighbour without a factor sees nothing itself (a buffer): its half is taken as that of i
    const double by_i = factor_i[k] * gradient_i[k], by_j = factor_j[k] > 0 ? factor_j[k] * gradient_j[k] : by_i;
    double face = extent_i[k] * extent_j[k] * (by_i + by_j) * dx[k];
    double at_face = 0, within = 0;
    if (with_bed || with_width) {
      const double h = i_is_left ? left.h[k] : right.h[k], u = i_is_left ? left.u[k] : right.u[k];
      const double u_star = i_is_left ? u_left[k] : u_right[k];
      at_face = head * (h * u * (u - w) - own * u_star * (u_star - w));
      within = 0.5 * g * (h + h_i[k]) * faces.rise[k];
    }
    if (with_width) {
      const double width = 0.5 * (width_i[k] + width_j[k]);
      within *= 0.5 * (width_i[k] + width) / width;
      face *= width * per_width;
    }
    volume[k] = -face * flux.volume;
    momentum[k] = -face * (flux.momentum + at_face + within);
  }
}

template <bool with_bed>
void exchange(const ExchangeRules& rules, const ShallowPairs& p, const PairWeights& weights, std::int64_t first,
              std::int64_t n, const ShallowFaces& faces, double* volume, double* momentum) {
  if (weights.width_i != nullptr)
    exchange_through<with_bed, true>(rules, p, weights, first, n, faces, volume, momentum);
  else
    exchange_through<with_bed, false>(rules, p, weights, first, n, faces, volume, momentum);
}

}  // namespace riffle
