// One dimension: the neighbours of a particle are a window of the sorted line. No cells; fast enough to be rebuilt at
// every step.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "host/neighbours/counting_sort.hpp"
#include "host/neighbours/workspace.hpp"

namespace riffle {

namespace {

constexpr std::int64_t line_particles_per_part = 4096;

void sort_sources(const ParticleView& particles, std::uint32_t sources, double factor, Line& line) {
  const auto all = static_cast<std::size_t>(particles.all);
  line.x.resize(all);
  line.particle.resize(all + 8);
  line.place.resize(all);
  const double* x = particles.x[0];
  std::size_t n = 0;
  for (std::size_t i = 0; i < all; ++i) {
    line.x[n] = x[i];
    line.particle[n] = static_cast<std::int32_t>(i);
    line.place[i] = -1;
    n += has_role(particles, sources, static_cast<std::int64_t>(i)) ? 1 : 0;
  }
  line.x.resize(n);
  line.particle.resize(n + 8);
  line.reach.resize(n);
  sort_along_line(line);
  for (std::size_t k = 0; k < n; ++k) {
    const std::int32_t i = line.particle[k];
    line.place[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(k);
    line.reach[k] = factor * smoothing_length(particles, i);
  }
}

// How many sources on either side each source reaches. Counting "is my m-th neighbour within reach?" for m = 1, 2, ...
// over a short stretch of the line has no branch that depends on the disorder, and vectorises: three times faster than
// moving two pointers.
void measure_windows(Line& line) {
  const auto n = static_cast<std::int64_t>(line.x.size());
  line.left.resize(line.x.size());
  line.right.resize(line.x.size());
  const double *x = line.x.data(), *reach = line.reach.data();
  constexpr std::int64_t stretch = 128;
  for_parts((n + stretch - 1) / stretch, parts_for(n), [&](int, std::int64_t from, std::int64_t to) {
    for (std::int64_t first = from * stretch; first < std::min(n, to * stretch); first += stretch) {
      const std::int64_t last = std::min(n, first + stretch);
      std::int64_t left[stretch] = {}, right[stretch] = {};
      std::int64_t any = 1;
      for (std::int64_t m = 1; m <= longest_segment + 1 && any != 0; ++m) {
        any = 0;
        for (std::int64_t k = first; k < std::min(last, n - m); ++k) {
          const std::int64_t within = x[k + m] - x[k] < reach[k] ? 1 : 0;
          right[k - first] += within;
          any |= within;
        }
        for (std::int64_t k = std::max(first, m); k < last; ++k) {
          const std::int64_t within = x[k] - x[k - m] < reach[k] ? 1 : 0;
          left[k - first] += within;
          any |= within;
        }
      }
      for (std::int64_t k = first; k < last; ++k) {
        line.left[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(left[k - first]);
        line.right[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(right[k - first]);
      }
    }
  });
}

// A source j is seen from x if x_j + reach_j > x when it is on the left, x_j - reach_j < x when it is on the right.
// from_left[k] is the largest of the former over j <= k and from_right[k] the smallest of the latter over j >= k: both
// are monotone, so the windows of sources that reach a target are found by two pointers again.
void measure_reaches(Line& line) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  const std::size_t n = line.x.size();
  line.from_left.resize(n);
  line.from_right.resize(n);
  const auto reach = [&](std::size_t k) { return line.reach[k] + rounding * (std::abs(line.x[k]) + line.reach[k]); };
  double left = -infinity, right = infinity;
  for (std::size_t k = 0; k < n; ++k) line.from_left[k] = left = std::max(left, line.x[k] + reach(k));
  for (std::size_t k = n; k-- > 0;) line.from_right[k] = right = std::min(right, line.x[k] - reach(k));
}

// First place k in [0, n) for which beyond(k) is true, n if none; beyond is monotone. Quick when near `guess`.
template <class Beyond>
std::int64_t hunt(std::int64_t guess, std::int64_t n, const Beyond& beyond) {
  int budget = 32;
  while (guess < n && !beyond(guess) && --budget > 0) ++guess;
  while (guess > 0 && beyond(guess - 1) && --budget > 0) --guess;
  if (budget > 0) return guess;
  std::int64_t low = 0, high = n;
  while (low < high) {
    const std::int64_t middle = (low + high) / 2;
    if (beyond(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

// All within the target's own reach.
class OwnReachSearch {
 public:
  OwnReachSearch(const ParticleView& particles, double factor, const Line& line)
      : particles_(particles), factor_(factor), line_(line) {}

  std::int64_t operator()(std::int64_t i, std::int32_t* out) {
    const std::int64_t self = line_.place[static_cast<std::size_t>(i)];
    if (self < 0) return search_from_outside(i, out);
    const std::int64_t left = line_.left[static_cast<std::size_t>(self)];
    const std::int64_t right = line_.right[static_cast<std::size_t>(self)];
    if (left + right > longest_segment) throw_too_many_neighbours(particles_, i);
    copy(self - left, left, out);
    copy(self + 1, right, out + left);
    return left + right;
  }

 private:
  // Eight at a time, past the end if need be: a copy of fixed size is two instructions.
  void copy(std::int64_t first, std::int64_t n, std::int32_t* out) const {
    const std::int32_t* particle = line_.particle.data() + first;
    for (std::int64_t k = 0; k < n; k += 8) std::memcpy(out + k, particle + k, 8 * sizeof(std::int32_t));
  }

  // The target is not a source itself, for instance a probe.
  std::int64_t search_from_outside(std::int64_t i, std::int32_t* out) {
    const auto n = static_cast<std::int64_t>(line_.x.size());
    const double* x = line_.x.data();
    const double at = particles_.x[0][i], own = factor_ * smoothing_length(particles_, i);
    low_ = hunt(low_, n, [=](std::int64_t k) { return at - x[k] < own; });
    high_ = hunt(high_, n, [=](std::int64_t k) { return x[k] - at >= own; });
    const std::int64_t count = std::max<std::int64_t>(0, high_ - low_);
    if (count > longest_segment) throw_too_many_neighbours(particles_, i);
    copy(low_, count, out);
    return count;
  }

  const ParticleView& particles_;
  double factor_;
  const Line& line_;
  std::int64_t low_ = 0, high_ = 0;  // window of the previous target
};

// All whose own reach, or the target's (`either`), covers the distance.
class TheirReachSearch {
 public:
  TheirReachSearch(const ParticleView& particles, double factor, bool either, const Line& line)
      : particles_(particles), factor_(factor), either_(either), line_(line) {}

  std::int64_t operator()(std::int64_t i, std::int32_t* out) {
    const auto n = static_cast<std::int64_t>(line_.x.size());
    const double *from_left = line_.from_left.data(), *from_right = line_.from_right.data();
    const double *x = line_.x.data(), *reach = line_.reach.data();
    const double at = particles_.x[0][i], own = either_ ? factor_ * smoothing_length(particles_, i) : 0;
    low_ = hunt(low_, n, [=](std::int64_t k) { return from_left[k] > at || at - x[k] < own; });
    high_ = hunt(high_, n, [=](std::int64_t k) { return from_right[k] >= at && x[k] - at >= own; });
    std::int64_t count = 0;
    for (std::int64_t k = low_; k < high_; ++k) {
      const std::int32_t j = line_.particle[static_cast<std::size_t>(k)];
      out[count] = j;
      count += std::abs(at - x[k]) < std::max(own, reach[k]) && j != i ? 1 : 0;
      if (count > longest_segment) throw_too_many_neighbours(particles_, i);
    }
    return count;
  }

 private:
  const ParticleView& particles_;
  double factor_;
  bool either_;
  const Line& line_;
  std::int64_t low_ = 0, high_ = 0;  // window of the previous target
};

}  // namespace

void search_line(const ParticleView& particles, double factor, const NeighbourRequest& request,
                 NeighbourWorkspace& work, NeighbourList& out) {
  require_searchable(particles);
  sort_sources(particles, request.sources, factor, work.line);
  if (uniform_reach(particles) || request.reach == Reach::gather) {
    measure_windows(work.line);
    collect(particles, request.targets, line_particles_per_part, OwnReachSearch(particles, factor, work.line),
            work.collect, out);
  } else {
    measure_reaches(work.line);
    const bool either = request.reach == Reach::either;
    collect(particles, request.targets, line_particles_per_part, TheirReachSearch(particles, factor, either, work.line),
            work.collect, out);
  }
}

}  // namespace riffle
