#include "host/schedule/line_pairs.hpp"

#include <cmath>

namespace riffle {

namespace {

// Which pairs count, by one rule for the count and for the marks.
struct OwnReach {
  const double* li;
  double operator()(std::int64_t k, double r) const { return r < li[k] ? 1.0 : 0.0; }
};
struct TheirReach {
  const double *li, *lj;
  double own;  // 1: that of i counts, too
  double operator()(std::int64_t k, double r) const {
    const double mine = own * li[k];
    return r < (lj[k] > mine ? lj[k] : mine) ? 1.0 : 0.0;
  }
};

template <bool Separation, bool Squared, bool Approach, class Within>
double geometry(const LinePairs& p, Within counts) {
  const double *xi = p.xi, *xj = p.xj, *ui = p.ui, *uj = p.uj;
  double *dx = p.separation, *r = p.distance, *r2 = p.squared, *vr = p.approach, within = 0;
#pragma omp simd reduction(+ : within)
  for (std::int64_t k = 0; k < p.n; ++k) {
    const double d = xi[k] - xj[k], a = std::abs(d);
    r[k] = a;
    if (Separation) dx[k] = d;
    if (Squared) r2[k] = d * d;
    if (Approach) vr[k] = (ui[k] - uj[k]) * d;
    within += counts(k, a);
  }
  return within;
}

template <class Within>
double fill(const LinePairs& p, Within counts) {
  const int wanted =
      (p.separation != nullptr ? 1 : 0) + (p.squared != nullptr ? 2 : 0) + (p.approach != nullptr ? 4 : 0);
  double within = 0;
  switch (wanted) {
    case 0: within = geometry<false, false, false>(p, counts); break;
    case 1: within = geometry<true, false, false>(p, counts); break;
    case 2: within = geometry<false, true, false>(p, counts); break;
    case 3: within = geometry<true, true, false>(p, counts); break;
    case 4: within = geometry<false, false, true>(p, counts); break;
    case 5: within = geometry<true, false, true>(p, counts); break;
    case 6: within = geometry<false, true, true>(p, counts); break;
    default: within = geometry<true, true, true>(p, counts);
  }
  if (within != 0 && within != static_cast<double>(p.n)) {
    const double* r = p.distance;
    double* marks = p.counts;
#pragma omp simd
    for (std::int64_t k = 0; k < p.n; ++k) marks[k] = counts(k, r[k]);
  }
  return within;
}

}  // namespace

LineCount pairs_by_own_reach(const LinePairs& p) {
  const double within = fill(p, OwnReach{p.li});
  return {within, within != 0};  // sorted: nobody further is nearer
}

LineCount pairs_by_their_reach(const LinePairs& p, bool either) {
  const double within = fill(p, TheirReach{p.li, p.lj, either ? 1.0 : 0.0});
  const double *r = p.distance, *x = p.xi, *li = p.li, *edge = p.edge, side = p.side, own = either ? 1.0 : 0.0;
  double further = 0;
#pragma omp simd reduction(+ : further)
  for (std::int64_t k = 0; k < p.n; ++k) {
    further += (edge[k] < side * x[k] ? 1.0 : 0.0) + (r[k] < own * li[k] ? 1.0 : 0.0);
  }
  return {within, further != 0};
}

void add_pairs(std::int64_t n, bool all, const double* counts, const double* f, double* sum) {
  if (all) {
#pragma omp simd
    for (std::int64_t k = 0; k < n; ++k) sum[k] += f[k];
  } else {
#pragma omp simd
    for (std::int64_t k = 0; k < n; ++k) sum[k] += counts[k] != 0 ? f[k] : 0.0;
  }
}

}  // namespace riffle
