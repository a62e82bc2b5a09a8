// Opposite faces of the domain are one: what leaves through the one enters through the other.
//
// Particles within reach of a face have an image a domain length further on, made anew with each neighbour list. They are
// taken back over the face only when some particle has gone beyond it by a twentieth of its reach, and then all at once:
// each move between the faces costs a new list, so positions may lie a little outside in between.
// Not in it: periods along oblique directions; a shear between the faces.
#include <algorithm>
#include <array>
#include <cmath>
#include <riffle/sdk.hpp>
#include <riffle/services.hpp>
#include <string>
#include <vector>

struct Periodic {
  static constexpr auto id = "periodic", kind = "boundary", version = "1.0.0";
  static constexpr auto summary = "Opposite faces of the domain are one";
  static constexpr auto source = "Allen & Tildesley (1987), section 1.5";
  static constexpr auto leaves_out = "oblique periods";
  static constexpr riffle_parameter parameters[] = {
      riffle::boolean("x", true, "period along x: the length of the domain"),
      riffle::boolean("y", false, "period along y (three dimensions)"),
      riffle::boolean("z", false, "period along z (two and three dimensions)")};

  explicit Periodic(const riffle::Values& v) {
    const int dim = v.dim(), axis_of[] = {0, dim == 3 ? 1 : -1, dim >= 2 ? dim - 1 : -1};
    for (int a = 0; a < 3; ++a) {
      const std::string name(1, "xyz"[a]);
      if (!v.flag(name.c_str())) continue;
      if (axis_of[a] < 0)
        throw std::invalid_argument(name + " = true, but there is no " + name + " in " + std::to_string(dim) +
                                    (dim == 1 ? " dimension" : " dimensions"));
      axes.push_back(axis_of[a]);
    }
    if (axes.empty()) throw std::invalid_argument("no axis is periodic: set x = true, or leave the plugin out");
  }
  void connect(const riffle_services& s) {
    services = &s;
    for (const int axis : axes) {
      if (!(s.high[axis] > s.low[axis])) throw std::invalid_argument("the domain has no length along a periodic axis");
    }
  }

  void begin(const riffle_editor& e) const {
    if (e.count == 0) return;
    const double reach = *std::max_element(e.reach, e.reach + e.count);
    const double spacing = riffle::particle_spacing(services, e.read(e.context, "cell_measure", 0)[0], e.dim);
    for (const int axis : axes) {
      const double period = services->high[axis] - services->low[axis];
      if (period < 2 * reach)
        throw std::invalid_argument("the period of " + std::to_string(period) +
                                    " m must be at least twice the reach of the particles, " + std::to_string(reach) +
                                    " m");
      const double cells = period / spacing;
      if (std::abs(cells - std::round(cells)) > 1e-6 * cells)
        throw std::invalid_argument("the period of " + std::to_string(period) +
                                    " m must be a multiple of the particle spacing, and is " + std::to_string(cells) +
                                    " of it");
    }
  }

  void edit(const riffle_editor& e) const {
    if (e.count == 0) return;
    for (const int axis : axes) {
      const double *x = e.read(e.context, "position", axis), low = services->low[axis], high = services->high[axis];
      const double slack = 0.05 * e.reach[0], below = low - slack, above = high + slack;
      std::int64_t far = 0;
#pragma omp simd reduction(+ : far)
      for (std::int64_t k = 0; k < e.count; ++k) far += x[k] < below || x[k] > above ? 1 : 0;
      if (far == 0) continue;
      double* moved = e.write(e.context, "position", axis);
      for (std::int64_t k = 0; k < e.count; ++k) {
        if (e.role[k] == RIFFLE_WALL || e.role[k] == RIFFLE_PROBE) continue;
        if (moved[k] < low) moved[k] += high - low;
        if (moved[k] >= high) moved[k] -= high - low;
      }
    }
  }

  void images(const riffle_editor& e) const {
    double zone = 0;
    for (std::int64_t k = 0; k < e.count; ++k) zone = std::max(zone, e.reach[k]);
    zone *= 1.1;  // the slack on either side
    struct Copy {
      std::int64_t index;
      std::array<double, 3> x;
    };
    std::vector<Copy> made;  // images so far: those of one axis are copied along the next, for corners
    for (const int axis : axes) {
      const auto a = static_cast<std::size_t>(axis);
      const double low = services->low[axis], high = services->high[axis];
      std::vector<Copy> near;
      const auto consider = [&](const Copy& copy) {
        if (copy.x[a] - low < zone || high - copy.x[a] < zone) near.push_back(copy);
      };
      const double* along = e.read(e.context, "position", axis);
      for (std::int64_t k = 0; k < e.count; ++k) {
        if (e.role[k] == RIFFLE_PROBE || (along[k] - low >= zone && high - along[k] >= zone)) continue;
        Copy particle{k, {}};
        for (int c = 0; c < e.dim; ++c) particle.x[static_cast<std::size_t>(c)] = e.read(e.context, "position", c)[k];
        near.push_back(particle);
      }
      const std::size_t before = made.size();
      for (std::size_t m = 0; m < before; ++m) consider(made[m]);
      for (const Copy& from : near) {
        for (const double period : {high - low, low - high}) {
          const double distance = period > 0 ? from.x[a] - low : high - from.x[a];
          if (!(distance < zone)) continue;
          double by[3] = {0, 0, 0};
          by[axis] = period;
          Copy image = from;
          image.x[a] += period;
          image.index = e.image(e.context, from.index, RIFFLE_SHIFT, axis, by);
          made.push_back(image);
        }
      }
    }
  }

  std::vector<int> axes;
  const riffle_services* services = nullptr;
};

RIFFLE_PLUGIN(Periodic)
