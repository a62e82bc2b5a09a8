#include "host/schedule/nearest_point.hpp"

#include <algorithm>
#include <limits>

namespace riffle {

NearestPoint::NearestPoint(int dim, std::vector<Point> points) : dim_(dim), points_(std::move(points)) {
  sort(0, points_.size(), 0);
}

void NearestPoint::sort(std::size_t first, std::size_t last, int axis) {
  if (last - first < 2) return;
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [this](std::size_t k) { return points_.begin() + static_cast<std::ptrdiff_t>(k); };
  const auto a = static_cast<std::size_t>(axis);
  std::nth_element(at(first), at(middle), at(last), [a](const Point& p, const Point& q) { return p[a] < q[a]; });
  sort(first, middle, (axis + 1) % dim_);
  sort(middle + 1, last, (axis + 1) % dim_);
}

void NearestPoint::search(const Point& x, std::size_t first, std::size_t last, int axis, double& best) const {
  if (first == last) return;
  const std::size_t middle = first + (last - first) / 2;
  const Point& p = points_[middle];
  double squared = 0;
  for (std::size_t c = 0; c < static_cast<std::size_t>(dim_); ++c) squared += (x[c] - p[c]) * (x[c] - p[c]);
  best = std::min(best, squared);
  const double beyond = x[static_cast<std::size_t>(axis)] - p[static_cast<std::size_t>(axis)];
  const int next = (axis + 1) % dim_;
  const auto side = [&](bool low) {
    if (low)
      search(x, first, middle, next, best);
    else
      search(x, middle + 1, last, next, best);
  };
  side(beyond < 0);
  if (beyond * beyond < best) side(beyond >= 0);
}

double NearestPoint::distance_squared(const Point& x) const {
  double best = std::numeric_limits<double>::infinity();
  search(x, 0, points_.size(), 0, best);
  return best;
}

}  // namespace riffle
