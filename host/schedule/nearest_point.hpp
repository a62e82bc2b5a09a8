// The nearest of a set of points, by a k-d tree.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace riffle {

class NearestPoint {
 public:
  using Point = std::array<double, 3>;  // m; the first `dim` count
  NearestPoint(int dim, std::vector<Point> points);
  // Squared distance (m2) from x to the nearest point; +infinity when there is none. Any thread.
  [[nodiscard]] double distance_squared(const Point& x) const;

 private:
  void sort(std::size_t first, std::size_t last, int axis);
  void search(const Point& x, std::size_t first, std::size_t last, int axis, double& best) const;

  int dim_;
  std::vector<Point> points_;  // the middle one of every range divides the rest along the range's axis
};

}  // namespace riffle
