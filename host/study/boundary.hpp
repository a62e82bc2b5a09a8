// Finding where a map changes its class without trying every point of its grid. First a few points all over; where two
// neighbours among them differ, bisection finds the step between them, and from there the boundary is followed over every
// third row and column, and narrowed to one cell wherever it crosses them. What was not tried gets the class of the
// nearest point that was, and is at most one cell off wherever the boundary bends no more sharply than three cells.
#pragma once

#include <functional>
#include <vector>

namespace riffle {

struct GridPoint {
  int x = 0, y = 0;
};

// Classes of points, in the order asked for. One call asks for points that may be tried at the same time; none comes twice.
using Classify = std::function<std::vector<int>(const std::vector<GridPoint>&)>;

struct TracedMap {
  int nx = 0, ny = 0;
  std::vector<int> of;      // class of every point, row by row from y = 0
  std::vector<char> tried;  // whether it was tried
  [[nodiscard]] std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * nx + x); }
  [[nodiscard]] int at(int x, int y) const { return of[index(x, y)]; }
  [[nodiscard]] int runs() const;
};

// `search`: points along each axis that are tried at first; as many as the longer axis has: all. A region that holds none of them, and to which no boundary
// from elsewhere leads, is not found.
TracedMap trace_map(int nx, int ny, int search, const Classify& classify);

}  // namespace riffle
