// Layers of fixed particles behind the faces of a domain and inside solids, for boundaries that make walls of particles.
//
// They stand on the lattice of the water, continued: rows at half a spacing behind a face. A face that has no wall is left
// open, so that a periodic or an open boundary may stand there; corners between two walls are filled.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <riffle/sdk.hpp>
#include <riffle/services.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace riffle {

struct WallFaces {
  std::array<bool, 3> low{}, high{};       // by axis of the scene: x | x z | x y z
  int layers = 0;                          // 0: as many as the support needs
  const riffle_function* solid = nullptr;  // above 0 inside a solid; null: none

  WallFaces() = default;
  explicit WallFaces(const Values& v)
      : layers(static_cast<int>(v.number("layers"))), solid(v.given("solid") ? v.function("solid") : nullptr) {
    const int dim = v.dim(), axis_of[] = {0, dim == 3 ? 1 : -1, dim - 1};
    for (int a = 0; a < 3; ++a) {
      for (const bool lower : {true, false}) {
        const std::string face = std::string(1, "xyz"[a]) + (lower ? "_min" : "_max");
        if (!v.flag(face.c_str())) continue;
        if (axis_of[a] < 0) throw std::invalid_argument(face + " = true, but there is no y in 2 dimensions");
        (lower ? low : high)[static_cast<std::size_t>(axis_of[a])] = true;
      }
    }
  }
};

// Parameters of boundaries that make such walls, to begin their lists with.
#define RIFFLE_WALL_FACE_PARAMETERS                                                                                 \
  riffle::boolean("x_min", false, "the face at the smallest x is a wall"),                                          \
      riffle::boolean("x_max", false, "the face at the largest x is a wall"),                                       \
      riffle::boolean("y_min", false, "the face at the smallest y is a wall (three dimensions)"),                   \
      riffle::boolean("y_max", false, "the face at the largest y is a wall (three dimensions)"),                    \
      riffle::boolean("z_min", true, "the face at the smallest z is a wall"),                                       \
      riffle::boolean("z_max", false, "the face at the largest z is a wall"),                                       \
      riffle::integer("layers", 0, 0, 20, "rows of wall particles; 0: as many as the support of the kernel needs"), \
      riffle::function("solid", "1", 0, "above 0 inside a solid, whose surface is a wall too")

// Where wall particles of a scene stand. Spacing and reach come from the water that is there.
class WallLayers {
 public:
  WallLayers(const WallFaces& faces, const riffle_services& services, double spacing, double reach)
      : faces_(faces), dim_(services.dim), spacing_(spacing) {
    // Lists see a skin of a tenth of the support beyond it.
    layers_ =
        faces.layers > 0 ? faces.layers : std::max(1, static_cast<int>(std::ceil(reach / 1.1 / spacing - 0.5 - 1e-6)));
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim_); ++a) {
      low_[a] = services.low[a];
      cells_[a] = static_cast<std::int64_t>(std::llround((services.high[a] - services.low[a]) / spacing));
    }
  }

  [[nodiscard]] int layers() const { return layers_; }

  [[nodiscard]] std::vector<std::array<double, 3>> places() const {
    std::array<std::int64_t, 3> first{}, last{1, 1, 1}, k{};
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim_); ++a) {
      first[a] = faces_.low[a] ? -layers_ : 0;
      last[a] = cells_[a] + (faces_.high[a] ? layers_ : 0);
    }
    std::vector<std::array<double, 3>> all;
    for (k[0] = first[0]; k[0] < last[0]; ++k[0]) {
      for (k[1] = first[1]; k[1] < last[1]; ++k[1]) {
        for (k[2] = first[2]; k[2] < last[2]; ++k[2]) {
          if (is_wall(k)) all.push_back(middle(k));
        }
      }
    }
    return all;
  }

 private:
  [[nodiscard]] std::array<double, 3> middle(const std::array<std::int64_t, 3>& k) const {
    std::array<double, 3> x{};
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim_); ++a)
      x[a] = low_[a] + (static_cast<double>(k[a]) + 0.5) * spacing_;
    return x;
  }
  [[nodiscard]] bool outside(const std::array<std::int64_t, 3>& k) const {
    for (std::size_t a = 0; a < static_cast<std::size_t>(dim_); ++a) {
      if (k[a] < 0 || k[a] >= cells_[a]) return true;
    }
    return false;
  }
  [[nodiscard]] bool in_solid(const std::array<std::int64_t, 3>& k) const {
    if (faces_.solid == nullptr) return false;
    const std::array<double, 3> x = middle(k);
    const double y = dim_ == 3 ? x[1] : 0, z = x[static_cast<std::size_t>(dim_ - 1)];
    double value = 0;
    faces_.solid->evaluate(faces_.solid->context, 1, &x[0], &y, &z, 0, &value);
    return value > 0;
  }
  // Behind a face; or in a solid, within `layers` cells of a place that is in none.
  [[nodiscard]] bool is_wall(const std::array<std::int64_t, 3>& k) const {
    if (outside(k)) return true;
    if (!in_solid(k)) return false;
    std::array<std::int64_t, 3> n = k;
    const std::int64_t far = layers_, across = dim_ == 3 ? far : 0, up = far;
    for (n[0] = k[0] - far; n[0] <= k[0] + far; ++n[0]) {
      for (std::int64_t b = -across; b <= across; ++b) {
        for (std::int64_t c = -up; c <= up; ++c) {
          if (dim_ == 3) n[1] = k[1] + b;
          n[static_cast<std::size_t>(dim_ - 1)] = k[static_cast<std::size_t>(dim_ - 1)] + c;
          if (!outside(n) && !in_solid(n)) return true;
        }
      }
    }
    return false;
  }

  WallFaces faces_;
  int dim_, layers_ = 0;
  double spacing_;
  std::array<double, 3> low_{};
  std::array<std::int64_t, 3> cells_{1, 1, 1};
};

// Of the lattice that walls continue [m].
inline double wall_spacing(const riffle_editor& e, const riffle_services& services) {
  return particle_spacing(&services, e.read(e.context, "cell_measure", 0)[0], e.dim);
}

// Adds particles of `role` at the places. Each is like the water nearest to it, with the density of water at rest there,
// so that nothing starts at t = 0. Returns the index of the first.
inline std::int64_t add_wall_particles(const riffle_editor& e, std::uint32_t role,
                                       const std::vector<std::array<double, 3>>& places, double gravity,
                                       double spacing = 0) {
  const std::int64_t water = e.count;
  if (water == 0) throw std::invalid_argument("walls of particles need water to be like, and there is none");
  const int up = e.dim - 1;
  // The nearest water by cells of the lattice; scenes have one spacing.
  if (!(spacing > 0)) spacing = std::pow(e.read(e.context, "cell_measure", 0)[0], 1.0 / e.dim);
  std::vector<std::int64_t> like(places.size());
  {
    std::array<const double*, 3> x{};
    for (int c = 0; c < e.dim; ++c) x[static_cast<std::size_t>(c)] = e.read(e.context, "position", c);
    std::vector<std::int64_t> order(static_cast<std::size_t>(water));
    for (std::int64_t i = 0; i < water; ++i) order[static_cast<std::size_t>(i)] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) { return x[0][a] < x[0][b]; });
    for (std::size_t p = 0; p < places.size(); ++p) {
      const auto distance2 = [&](std::int64_t i) {
        double d2 = 0;
        for (int c = 0; c < e.dim; ++c) {
          const double d = x[static_cast<std::size_t>(c)][i] - places[p][static_cast<std::size_t>(c)];
          d2 += d * d;
        }
        return d2;
      };
      const auto at = std::lower_bound(order.begin(), order.end(), places[p][0],
                                       [&](std::int64_t i, double value) { return x[0][i] < value; });
      double best = infinity;
      std::int64_t found = order.front();
      const auto look = [&](std::int64_t i) {
        const double along = x[0][i] - places[p][0], d2 = distance2(i);
        if (d2 < best) best = d2, found = i;
        return along * along <= best;
      };
      for (auto k = at; k != order.end() && look(*k); ++k) {
      }
      for (auto k = at; k != order.begin() && look(*(k - 1)); --k) {
      }
      like[p] = found;
    }
  }
  std::int64_t first = -1;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const std::int64_t i = e.add(e.context, role, like[p]);
    if (first < 0) first = i;
    const double z = e.read(e.context, "position", up)[like[p]], rho = e.read(e.context, "density", 0)[like[p]];
    const double c0 = e.read(e.context, "wave_speed", 0)[like[p]];
    for (int c = 0; c < e.dim; ++c) {
      e.write(e.context, "position", c)[i] = places[p][static_cast<std::size_t>(c)];
      e.write(e.context, "velocity", c)[i] = 0;
    }
    const double deeper = rho + rho * gravity * (z - places[p][static_cast<std::size_t>(up)]) / (c0 * c0);
    e.write(e.context, "density", 0)[i] = deeper;
    e.write(e.context, "mass", 0)[i] = deeper * std::pow(spacing, e.dim);
  }
  return first;
}

}  // namespace riffle
