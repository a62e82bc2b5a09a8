// An open end of a flow in the vertical plane: buffer particles beyond a face of the domain, whose state a boundary plugin
// decides, and a floor of particles under them. What crosses the face changes role.
//
//   end x_min:   b  b  b  b | w  w  w  w ...       b buffer, w water, | the end of the domain
//                f  f  f  f | s  s  s  s ...       f floor of the buffer, s whatever wall the scene has
//
// What happens inside is measured next to the end: weights fall from the middle of the window to its edges, so that on a
// lattice the volume per length, the depth, is exact, and no mean jumps when a particle passes an edge. A particle may be half
// a spacing beyond the face before roles change, and then all that are beyond change theirs at once: each time costs new lists.
// The floor has the role of the buffer, no velocity, and the density of water at rest at its depth; it lies below the domain.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "riffle/abi.h"

namespace riffle {

// Means by height of the water inside, in rows of one spacing from the bed up.
struct EndProfile {
  double bottom = 0, row = 1, depth = 0;  // m
  std::vector<double> volume, velocity, eddy_viscosity;

  // Linear between the middles of the rows, constant beyond the last ones.
  [[nodiscard]] double at(const std::vector<double>& values, double z) const {
    if (values.empty()) return 0;
    const double place = std::clamp((z - bottom) / row - 0.5, 0.0, static_cast<double>(values.size() - 1));
    const auto k = std::min(static_cast<std::size_t>(place), values.size() - 1);
    const double part = place - static_cast<double>(k);
    return k + 1 < values.size() ? (1 - part) * values[k] + part * values[k + 1] : values[k];
  }
};

class OpenEnd {
 public:
  static constexpr double slack = 0.5;  // spacings that particles may be beyond the face

  OpenEnd(bool low, std::uint32_t role, double density)
      : inward_(low ? 1.0 : -1.0), low_(low), role_(role), density_(density) {}

  void connect(const riffle_services& s) {
    x_ = low_ ? s.low[0] : s.high[0];
    length_ = s.high[0] - s.low[0];
    bed_ = s.low[1];
  }
  [[nodiscard]] double x() const { return x_; }
  [[nodiscard]] double bed() const { return bed_; }
  [[nodiscard]] double inward() const { return inward_; }
  [[nodiscard]] double inside_by(double x) const { return inward_ * (x - x_); }  // m, negative beyond the end
  [[nodiscard]] double value(const riffle_function* f, double z, double time) const {
    double out = 0;
    f->evaluate(f->context, 1, &x_, nullptr, &z, time, &out);
    return out;
  }
  [[nodiscard]] static double spacing(const riffle_editor& e) { return std::sqrt(read(e, "cell_measure")[0]); }
  [[nodiscard]] static double reach(const riffle_editor& e) { return e.reach[0]; }
  // Of the buffer: nobody inside sees its end.
  [[nodiscard]] static double width(const riffle_editor& e) { return reach(e) + 2 * spacing(e); }

  [[nodiscard]] bool is_floor(double z) const { return z < bed_; }
  [[nodiscard]] bool is_buffer(const riffle_editor& e, std::int64_t k) const {
    return e.role[k] == role_ && !is_floor(read(e, "position", 1)[k]) && mine(e, k);
  }

  // Density of water at rest `below` its surface [m], by the state equation and the gravity of the equation set.
  [[nodiscard]] double density(const riffle_editor& e, double below) const {
    const double c0 = read(e, "wave_speed")[0], n = read(e, "state_exponent")[0];
    const double head = std::max(below, 0.0) * read(e, "normal_gravity")[0] / (c0 * c0);
    return n == 1 ? density_ * (1 + head) : density_ * std::pow(1 + n * head, 1 / n);
  }

  [[nodiscard]] EndProfile inside(const riffle_editor& e) const {
    EndProfile p;
    p.bottom = bed_;
    p.row = spacing(e);
    const double half = std::ceil(reach(e) / p.row - 1e-9) * p.row;
    if (length_ < 4 * half)
      throw std::invalid_argument("the domain of " + std::to_string(length_) + " m must be at least " +
                                  std::to_string(4 * half) +
                                  " m long, twice the window next to the end in which the flow is measured");
    const double *x = read(e, "position", 0), *z = read(e, "position", 1), *u = read(e, "velocity", 0);
    const double *m = read(e, "mass"), *rho = read(e, "density");
    const double *phi = e.read(e.context, "porosity", 0), *eddy = e.read(e.context, "eddy_viscosity", 0);
    const auto add = [&](std::size_t k, double v, std::int64_t i) {
      if (k >= p.volume.size())
        p.volume.resize(k + 1, 0), p.velocity.resize(k + 1, 0), p.eddy_viscosity.resize(k + 1, 0);
      p.volume[k] += v;
      p.velocity[k] += v * u[i];
      if (eddy != nullptr) p.eddy_viscosity[k] += v * eddy[i];
    };
    for (std::int64_t i = 0; i < e.count && e.role[i] == RIFFLE_FLUID; ++i) {
      const double off = std::abs(inside_by(x[i]) - half) / half;
      if (!(off < 1)) continue;
      const double v = m[i] / (rho[i] * (phi != nullptr ? phi[i] : 1.0)) * (1 - off) / half;
      p.depth += v;
      const double place = std::clamp((z[i] - bed_) / p.row - 0.5, 0.0, highest), part = place - std::floor(place);
      add(static_cast<std::size_t>(place), (1 - part) * v, i);
      if (part > 0) add(static_cast<std::size_t>(place) + 1, part * v, i);
    }
    for (std::size_t k = 0; k < p.volume.size(); ++k) {
      if (p.volume[k] > 1e-3 * p.row) {
        p.velocity[k] /= p.volume[k];
        p.eddy_viscosity[k] /= p.volume[k];
      } else {  // too little to tell; as below
        p.velocity[k] = k > 0 ? p.velocity[k - 1] : 0;
        p.eddy_viscosity[k] = k > 0 ? p.eddy_viscosity[k - 1] : 0;
      }
    }
    return p;
  }

  // A new particle of the buffer or its floor, like `like`, at a distance `out` beyond the end.
  std::int64_t add(const riffle_editor& e, std::int64_t like, double out, double z) const {
    const std::int64_t i = e.add(e.context, role_, like);
    e.write(e.context, "position", 0)[i] = x_ - inward_ * out;
    e.write(e.context, "position", 1)[i] = z;
    e.write(e.context, "velocity", 1)[i] = 0;
    return i;
  }
  // Returns the number of particles with it.
  std::int64_t add_floor(const riffle_editor& e) const {
    std::int64_t last = 0;
    const double l = spacing(e);
    const auto columns = static_cast<int>(std::ceil((width(e) + l) / l)),
               rows = static_cast<int>(std::ceil(reach(e) / l));
    for (int c = 0; c < columns; ++c) {
      for (int r = 0; r < rows; ++r) {
        last = add(e, 0, (c + 0.5) * l, bed_ - (r + 0.5) * l);
        e.write(e.context, "velocity", 0)[last] = 0;
        set(e, "eddy_viscosity", last, 0);
      }
    }
    return last + 1;
  }
  // Gives the floor the density of water at rest below `level`; `particles` includes those added in this call.
  void press_floor(const riffle_editor& e, double level, std::int64_t particles) const {
    const double l = spacing(e), *z = read(e, "position", 1);
    double *rho = e.write(e.context, "density", 0), *m = e.write(e.context, "mass", 0);
    for (std::int64_t k = 0; k < particles; ++k) {
      const bool added = k >= e.count;
      if (!is_floor(z[k]) || (!added && (e.role[k] != role_ || !mine(e, k)))) continue;
      rho[k] = density(e, level - z[k]);
      m[k] = rho[k] * l * l;
    }
  }
  // Water and buffer that have crossed change roles, once somebody is far enough beyond. True when they did.
  [[nodiscard]] bool due(const riffle_editor& e, std::uint32_t from, bool inwards) const {
    const double *x = read(e, "position", 0), *z = read(e, "position", 1), far = slack * spacing(e);
    for (std::int64_t k = 0; k < e.count; ++k) {
      if (e.role[k] != from || is_floor(z[k])) continue;
      if (from == role_ && !mine(e, k)) continue;
      if ((inwards ? inside_by(x[k]) : -inside_by(x[k])) > far) return true;
    }
    return false;
  }

  static const double* read(const riffle_editor& e, const char* name, int component = 0) {
    const double* values = e.read(e.context, name, component);
    if (values == nullptr)
      throw std::runtime_error(std::string("there is no field \"") + name + "\": this end is for wcsph");
    return values;
  }
  static void set(const riffle_editor& e, const char* name, std::int64_t i, double value) {
    if (e.read(e.context, name, 0) != nullptr) e.write(e.context, name, 0)[i] = value;
  }

 private:
  static constexpr double highest = 1e6;  // rows
  // Both ends may have buffers of one role. A particle of this end that is at the other one was taken there.
  [[nodiscard]] bool mine(const riffle_editor& e, std::int64_t k) const {
    return inside_by(read(e, "position", 0)[k]) < 0.5 * length_;
  }

  double inward_;
  bool low_;
  std::uint32_t role_;
  double density_, x_ = 0, length_ = 1, bed_ = 0;
};

}  // namespace riffle
