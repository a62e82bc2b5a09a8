// Simple polygons in the vertical plane: whether a point lies inside, how far it is from the outline, whether outlines cross.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace riffle {

using PlanePoint = std::array<double, 2>;  // x, z [m]

namespace polygon_detail {
// Twice the area of a, b, c: above 0 when they turn left.
inline double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
// The inner parts of the edges a-b and c-d meet in one point. Edges that touch or lie on each other do not.
inline bool cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d, double nothing) {
  const double ca = turn(c, d, a), cb = turn(c, d, b), ac = turn(a, b, c), ad = turn(a, b, d);
  return ((ca > nothing && cb < -nothing) || (ca < -nothing && cb > nothing)) &&
         ((ac > nothing && ad < -nothing) || (ac < -nothing && ad > nothing));
}
// `inverse`: 1 over the squared length of the edge, 0 for an edge without length.
inline double squared_distance_to_edge(const PlanePoint& p, const PlanePoint& a, const PlanePoint& b, double inverse) {
  const double ex = b[0] - a[0], ez = b[1] - a[1];
  const double along = ((p[0] - a[0]) * ex + (p[1] - a[1]) * ez) * inverse;
  const double s = std::clamp(along, 0.0, 1.0);
  const double dx = p[0] - a[0] - s * ex, dz = p[1] - a[1] - s * ez;
  return dx * dx + dz * dz;
}
}  // namespace polygon_detail

class Polygon {
 public:
  explicit Polygon(std::vector<PlanePoint> corners) : corners_(std::move(corners)) {
    PlanePoint low = corners_.front(), high = low;
    for (const auto& c : corners_) {
      for (std::size_t a = 0; a < 2; ++a) low[a] = std::min(low[a], c[a]), high[a] = std::max(high[a], c[a]);
    }
    low_ = low, high_ = high;
    for (std::size_t k = 0; k < edges(); ++k) {
      const double x = to(k)[0] - from(k)[0], z = to(k)[1] - from(k)[1], square = x * x + z * z;
      inverse_.push_back(square > 0 ? 1 / square : 0);
    }
    size_ = std::hypot(high[0] - low[0], high[1] - low[1]);
  }
  [[nodiscard]] std::size_t edges() const { return corners_.size(); }
  [[nodiscard]] const PlanePoint& from(std::size_t edge) const { return corners_[edge]; }
  [[nodiscard]] const PlanePoint& to(std::size_t edge) const { return corners_[(edge + 1) % corners_.size()]; }

  // Surely further from all of the polygon than `far`: outside of its box by so much.
  [[nodiscard]] bool beyond(const PlanePoint& p, double far) const {
    return p[0] < low_[0] - far || p[0] > high_[0] + far || p[1] < low_[1] - far || p[1] > high_[1] + far;
  }
  [[nodiscard]] double area() const {
    double twice = 0;
    for (std::size_t k = 0; k < edges(); ++k) twice += from(k)[0] * to(k)[1] - to(k)[0] * from(k)[1];
    return std::abs(twice) / 2;
  }
  [[nodiscard]] bool contains(const PlanePoint& p) const {
    bool inside = false;
    for (std::size_t k = 0; k < edges(); ++k) {
      const PlanePoint &a = from(k), &b = to(k);
      if ((a[1] > p[1]) == (b[1] > p[1])) continue;
      const bool left = (p[0] - a[0]) * (b[1] - a[1]) < (p[1] - a[1]) * (b[0] - a[0]);  // of an edge that rises
      if (left == (b[1] > a[1])) inside = !inside;
    }
    return inside;
  }
  // To the nearest edge for which `counts(edge)` holds; infinity when there is none.
  template <class Counts>
  [[nodiscard]] double distance(const PlanePoint& p, const Counts& counts) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < edges(); ++k) {
      if (counts(k)) least = std::min(least, polygon_detail::squared_distance_to_edge(p, from(k), to(k), inverse_[k]));
    }
    return std::sqrt(least);
  }
  [[nodiscard]] bool crosses_itself() const {
    for (std::size_t k = 0; k < edges(); ++k) {
      for (std::size_t m = k + 2; m < edges(); ++m) {
        if (polygon_detail::cross(from(k), to(k), from(m), to(m), nothing())) return true;
      }
    }
    return false;
  }
  // They share more than a part of their outlines.
  [[nodiscard]] bool overlaps(const Polygon& other) const {
    const double little = std::min(nothing(), other.nothing());
    for (std::size_t k = 0; k < edges(); ++k) {
      for (std::size_t m = 0; m < other.edges(); ++m) {
        if (polygon_detail::cross(from(k), to(k), other.from(m), other.to(m), little)) return true;
      }
    }
    return reaches_into(other) || other.reaches_into(*this);
  }

 private:
  [[nodiscard]] double nothing() const { return 1e-12 * size_ * size_; }
  // A corner, the middle of an edge, or a point within lies truly inside the other.
  [[nodiscard]] bool reaches_into(const Polygon& other) const {
    const auto inside = [&](const PlanePoint& p) {
      return other.contains(p) && other.distance(p, [](std::size_t) { return true; }) > 1e-9 * other.size_;
    };
    for (std::size_t k = 0; k < edges(); ++k) {
      const PlanePoint &a = from(k), &b = to(k);
      if (inside(a) || inside({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2})) return true;
      const PlanePoint& c = to((k + 1) % edges());  // of the triangle at b, where that is a part of this polygon
      const PlanePoint middle{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
      if (contains(middle) && inside(middle)) return true;
    }
    return false;
  }

  std::vector<PlanePoint> corners_;
  std::vector<double> inverse_;  // per edge, 1 over its squared length
  PlanePoint low_{}, high_{};
  double size_ = 0;
};

}  // namespace riffle
