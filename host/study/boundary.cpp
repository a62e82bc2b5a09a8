#include "host/study/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>
#include <utility>

namespace riffle {
namespace {

constexpr int stride = 3;

// Indices of an axis on which the boundary is followed: every third, and the last.
std::vector<int> track_of(int n) {
  std::vector<int> track;
  for (int k = 0; k < n - 1; k += stride) track.push_back(k);
  track.push_back(n - 1);
  return track;
}

// Places in a track of so many members that are looked at first, ends included.
std::vector<int> first_of(int members, int search) {
  std::set<int> places;
  const int count = std::clamp(search, 2, std::max(members, 2));
  for (int k = 0; k < count; ++k) places.insert(static_cast<int>(std::lround(double(k) * (members - 1) / (count - 1))));
  return {places.begin(), places.end()};
}

using Pair = std::pair<GridPoint, GridPoint>;  // two points on one row or column
using Cell = std::pair<int, int>;              // places of its lower corner in the two tracks

class Tracer {
 public:
  Tracer(int nx, int ny, int search, const Classify& classify)
      : classify_(classify), track_x_(track_of(nx)), track_y_(track_of(ny)), search_(search) {
    map_.nx = nx;
    map_.ny = ny;
    map_.of.assign(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny), 0);
    map_.tried.assign(map_.of.size(), 0);
  }

  TracedMap trace() {
    if (search_ >= std::max(map_.nx, map_.ny)) {
      attempt_all();
      return std::move(map_);
    }
    look_around();
    follow();
    narrow();
    fill();
    return std::move(map_);
  }

 private:
  [[nodiscard]] GridPoint at(int i, int j) const {
    return {track_x_[static_cast<std::size_t>(i)], track_y_[static_cast<std::size_t>(j)]};
  }
  [[nodiscard]] int of(const GridPoint& p) const { return map_.at(p.x, p.y); }

  void attempt(const std::vector<GridPoint>& wanted) {
    std::vector<GridPoint> fresh;
    for (const GridPoint& p : wanted) {
      char& tried = map_.tried[map_.index(p.x, p.y)];
      if (tried == 0) fresh.push_back(p);
      tried = 1;
    }
    if (fresh.empty()) return;
    const std::vector<int> classes = classify_(fresh);
    for (std::size_t k = 0; k < fresh.size(); ++k) map_.of[map_.index(fresh[k].x, fresh[k].y)] = classes[k];
  }

  void attempt_all() {
    std::vector<GridPoint> points;
    for (int y = 0; y < map_.ny; ++y) {
      for (int x = 0; x < map_.nx; ++x) points.push_back({x, y});
    }
    attempt(points);
  }

  // The coarse grid, and bisection along its lines down to neighbours on the tracks, whose cells are the first to follow.
  void look_around() {
    const std::vector<int> is = first_of(static_cast<int>(track_x_.size()), search_);
    const std::vector<int> js = first_of(static_cast<int>(track_y_.size()), search_);
    std::vector<GridPoint> grid;
    for (const int j : js) {
      for (const int i : is) grid.push_back(at(i, j));
    }
    attempt(grid);
    struct Step {
      bool along_x;
      int low, high, across;
    };
    std::vector<Step> steps;
    for (const int j : js) {
      for (std::size_t k = 1; k < is.size(); ++k) steps.push_back({true, is[k - 1], is[k], j});
    }
    for (const int i : is) {
      for (std::size_t k = 1; k < js.size(); ++k) steps.push_back({false, js[k - 1], js[k], i});
    }
    const auto point = [&](const Step& s, int k) { return s.along_x ? at(k, s.across) : at(s.across, k); };
    while (!steps.empty()) {
      std::vector<Step> halves;
      std::vector<GridPoint> middles;
      for (const Step& s : steps) {
        if (of(point(s, s.low)) == of(point(s, s.high))) continue;
        if (s.high - s.low == 1) {
          for (const int beside : {s.across - 1, s.across}) s.along_x ? visit(s.low, beside) : visit(beside, s.low);
          continue;
        }
        const int middle = (s.low + s.high) / 2;
        middles.push_back(point(s, middle));
        halves.push_back({s.along_x, s.low, middle, s.across});
        halves.push_back({s.along_x, middle, s.high, s.across});
      }
      attempt(middles);
      steps = std::move(halves);
    }
  }

  void visit(int i, int j) {
    const bool inside =
        i >= 0 && j >= 0 && i + 1 < static_cast<int>(track_x_.size()) && j + 1 < static_cast<int>(track_y_.size());
    if (inside && cells_.insert({i, j}).second) next_.emplace_back(i, j);
  }

  // From cell to cell through the sides that the boundary crosses.
  void follow() {
    while (!next_.empty()) {
      const std::vector<Cell> wave = std::exchange(next_, {});
      std::vector<GridPoint> corners;
      for (const auto& [i, j] : wave) {
        for (const GridPoint& p : {at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)}) corners.push_back(p);
      }
      attempt(corners);
      for (const auto& [i, j] : wave) {
        const int a = of(at(i, j)), b = of(at(i + 1, j)), c = of(at(i, j + 1)), d = of(at(i + 1, j + 1));
        if (a != b) visit(i, j - 1);
        if (c != d) visit(i, j + 1);
        if (a != c) visit(i - 1, j);
        if (b != d) visit(i + 1, j);
      }
    }
  }

  void narrow() {
    std::vector<Pair> pairs;
    for (const auto& [i, j] : cells_) {
      const GridPoint a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
      for (const Pair& side : {Pair{a, b}, Pair{c, d}, Pair{a, c}, Pair{b, d}}) pairs.push_back(side);
    }
    while (!pairs.empty()) {
      std::vector<GridPoint> middles;
      std::vector<Pair> wide;
      for (const auto& [p, q] : pairs) {
        if (of(p) == of(q) || std::max(q.x - p.x, q.y - p.y) < 2) continue;
        middles.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2});
        wide.emplace_back(p, q);
      }
      attempt(middles);
      pairs.clear();
      for (std::size_t k = 0; k < wide.size(); ++k) {
        if (of(middles[k]) == of(wide[k].first)) {
          pairs.emplace_back(middles[k], wide[k].second);
        } else {
          pairs.emplace_back(wide[k].first, middles[k]);
        }
      }
    }
  }

  void fill() {
    const TracedMap known = map_;
    for (int y = 0; y < map_.ny; ++y) {
      for (int x = 0; x < map_.nx; ++x) {
        int least = std::numeric_limits<int>::max();
        for (int v = 0; v < map_.ny; ++v) {
          if ((v - y) * (v - y) >= least) continue;
          for (int u = 0; u < map_.nx; ++u) {
            const int distance = (u - x) * (u - x) + (v - y) * (v - y);
            if (known.tried[known.index(u, v)] == 0 || distance >= least) continue;
            least = distance;
            map_.of[map_.index(x, y)] = known.at(u, v);
          }
        }
      }
    }
  }

  const Classify& classify_;
  const std::vector<int> track_x_, track_y_;
  const int search_;
  TracedMap map_;
  std::set<Cell> cells_;
  std::vector<Cell> next_;
};

}  // namespace

int TracedMap::runs() const {
  return static_cast<int>(std::count(tried.begin(), tried.end(), 1));
}

TracedMap trace_map(int nx, int ny, int search, const Classify& classify) {
  return Tracer(nx, ny, search, classify).trace();
}

}  // namespace riffle
