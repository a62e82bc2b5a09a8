#include "host/neighbours/verlet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "host/neighbours/counting_sort.hpp"
#include "host/neighbours/view_checks.hpp"

namespace riffle {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Moved {
  double furthest2 = 0;           // square of the largest displacement, m2
  double least_slack = infinity;  // smallest (1 + s) kappa l(then) - kappa l(now) - d, m
  double not_finite = 0;          // stays 0 while all numbers are finite

  void add(const Moved& other) {
    furthest2 = std::max(furthest2, other.furthest2);
    least_slack = std::min(least_slack, other.least_slack);
    not_finite += other.not_finite;
  }
};

// Of particles [first, last). `then` and `now` hold (1 + s) kappa l and kappa l when l is uniform. Eight lanes by hand:
// compilers do not agree on vectorising largest and smallest of doubles.
template <int dim, bool variable>
Moved measure(const double* const* x_now, const double* const* x_then, const double* l_now, const double* l_then,
              double now, double then, std::int64_t first, std::int64_t last) {
  constexpr std::int64_t lanes = 8;
  double furthest2[lanes] = {}, least_slack[lanes], not_finite[lanes] = {};
  std::fill(least_slack, least_slack + lanes, infinity);
  const auto add = [&](std::int64_t i, std::int64_t lane) {
    double d2 = 0;
    for (int d = 0; d < dim; ++d) d2 += (x_now[d][i] - x_then[d][i]) * (x_now[d][i] - x_then[d][i]);
    const double slack = (variable ? then * l_then[i] - now * l_now[i] : then - now) - std::sqrt(d2);
    furthest2[lane] = d2 > furthest2[lane] ? d2 : furthest2[lane];
    least_slack[lane] = slack < least_slack[lane] ? slack : least_slack[lane];
    not_finite[lane] += slack - slack;  // NaN unless finite; comparisons alone would pass over NaN
  };
  std::int64_t i = first;
  for (; i + lanes <= last; i += lanes) {
    for (std::int64_t lane = 0; lane < lanes; ++lane) add(i + lane, lane);
  }
  for (; i < last; ++i) add(i, 0);
  Moved moved;
  for (std::int64_t lane = 0; lane < lanes; ++lane) moved.add({furthest2[lane], least_slack[lane], not_finite[lane]});
  return moved;
}

}  // namespace

void VerletCheck::remember(const ParticleView& particles, double kappa, double skin, const NeighbourRequest& request) {
  remembered_ = true;
  owned_ = particles.owned;
  kappa_ = kappa;
  skin_ = skin;
  request_ = request;
  uniform_l_ = particles.uniform_l;
  for (int d = 0; d < particles.dim; ++d) x_[d].assign(particles.x[d], particles.x[d] + owned_);
  l_.clear();
  if (!uniform_reach(particles)) l_.assign(particles.l, particles.l + owned_);
}

double VerletCheck::margin(const ParticleView& now) const {
  if (!remembered_ || now.owned != owned_ || l_.empty() != (uniform_reach(now) || owned_ == 0)) return -infinity;
  std::uint32_t counts = request_.targets | request_.sources;
  if (request_.reach == Reach::gather) counts = request_.targets;
  if (request_.reach == Reach::scatter) counts = request_.sources;
  const double factor_then = (1 + skin_) * kappa_ * (l_.empty() ? uniform_l_ : 1);
  const double factor_now = kappa_ * (l_.empty() ? now.uniform_l : 1);
  const double* const then[3] = {x_[0].data(), x_[1].data(), x_[2].data()};
  const auto of_range = [&](std::int64_t first, std::int64_t last) {
    const auto of_dim = [&](auto dim) {
      constexpr int d = decltype(dim)::value;
      return l_.empty() ? measure<d, false>(now.x, then, nullptr, nullptr, factor_now, factor_then, first, last)
                        : measure<d, true>(now.x, then, now.l, l_.data(), factor_now, factor_then, first, last);
    };
    if (now.dim == 1) return of_dim(std::integral_constant<int, 1>());
    if (now.dim == 2) return of_dim(std::integral_constant<int, 2>());
    return of_dim(std::integral_constant<int, 3>());
  };

  const int parts = parts_for(owned_);
  std::vector<Moved> found(static_cast<std::size_t>(parts));
  for_parts(owned_, parts, [&](int part, std::int64_t from, std::int64_t to) {
    Moved moved;
    for (std::int64_t first = from, last = from; first < to; first = last) {  // a run of equal role
      while (last < to && (now.role == nullptr || now.role[last] == now.role[first])) ++last;
      const bool support_counts = has_role(now, counts, first);
      if (!support_counts && !has_role(now, request_.targets | request_.sources, first)) continue;
      Moved run = of_range(first, last);
      if (!support_counts) run.least_slack = infinity;
      moved.add(run);
    }
    found[static_cast<std::size_t>(part)] = moved;
  });
  Moved all;
  for (const Moved& moved : found) all.add(moved);
  return all.not_finite == 0 ? all.least_slack - std::sqrt(all.furthest2) : -infinity;
}

}  // namespace riffle
