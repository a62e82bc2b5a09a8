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

#include "riffle/sdk.hpp"

// Parameters of boundaries that are such ends: which end, and what the equation set says of pressure.
#define RIFFLE_OPEN_END_PARAMETERS(which)                                                                            \
  riffle::choice("end", "x_min|x_max", which, "which end of the domain"),                                            \
      riffle::inherited("gravity", "m.s-2", "fluid.gravity", 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN),  \
      riffle::inherited("density", "kg.m-3", "fluid.density", 0, 1e5, "reference density rho0", RIFFLE_ABOVE_MIN),   \
      riffle::real("bed_slope", "1", 0, -0.999, 0.999, "S0 of the equations", 0, "equations.bed_slope"),             \
      riffle_parameter {                                                                                             \
    sizeof(riffle_parameter), RIFFLE_CHOICE, 0, 0, "state", "1", "state equation", "linear|tait", "equations.state", \
        0, 0, 0, "linear"                                                                                            \
  }

namespace riffle {

// Means of the water inside, by rows of one spacing from the bed up: the rows that hold any, with the mean height of what they
// hold. Means at the middles of rows instead would spread the profile a little each time the buffer takes it.
struct EndProfile {
  double depth = 0;  // m: volume of the water per length
  std::vector<double> z, velocity, eddy_viscosity;

  // Linear between the rows, constant beyond the lowest and the highest.
  [[nodiscard]] double at(const std::vector<double>& values, double level) const {
    if (z.empty()) return 0;
    const auto k = static_cast<std::size_t>(std::upper_bound(z.begin(), z.end(), level) - z.begin());
    if (k == 0) return values.front();
    if (k == z.size()) return values.back();
    const double part = (level - z[k - 1]) / (z[k] - z[k - 1]);
    return (1 - part) * values[k - 1] + part * values[k];
  }
};

class OpenEnd {
 public:
  static constexpr double slack = 0.5;  // spacings that particles may be beyond the face

  OpenEnd(const Values& v, std::uint32_t role)
      : low_(v.word("end") == "x_min"),
        inward_(low_ ? 1.0 : -1.0),
        role_(role),
        density_(v.number("density")),
        gravity_(v.number("gravity") * std::sqrt(1 - v.number("bed_slope") * v.number("bed_slope"))),
        exponent_(v.word("state") == "tait" ? 7 : 1) {}

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
    const double c0 = read(e, "wave_speed")[0], head = std::max(below, 0.0) * gravity_ / (c0 * c0);
    return exponent_ == 1 ? density_ * (1 + head) : density_ * std::pow(1 + exponent_ * head, 1 / exponent_);
  }

  // Next to the end, or as far from it.
  [[nodiscard]] EndProfile inside(const riffle_editor& e, double distance = 0) const {
    EndProfile p;
    const double row = spacing(e), half = std::ceil(reach(e) / row - 1e-9) * row;
    if (length_ < std::max(4 * half, distance + 2 * half))
      throw std::invalid_argument("the domain of " + std::to_string(length_) + " m must be at least " +
                                  std::to_string(std::max(4 * half, distance + 2 * half)) +
                                  " m long for the window in which the flow next to the end is measured");
    const double *x = read(e, "position", 0), *z = read(e, "position", 1), *u = read(e, "velocity", 0);
    const double *m = read(e, "mass"), *rho = read(e, "density");
    const double *phi = e.read(e.context, "porosity", 0), *eddy = e.read(e.context, "eddy_viscosity", 0);
    struct Sum {
      double volume = 0, z = 0, u = 0, eddy = 0;
    };
    std::vector<Sum> sums;
    for (std::int64_t i = 0; i < e.count && e.role[i] == RIFFLE_FLUID; ++i) {
      const double off = std::abs(inside_by(x[i]) - distance - half) / half;
      if (!(off < 1)) continue;
      const double v = m[i] / (rho[i] * (phi != nullptr ? phi[i] : 1.0)) * (1 - off) / half;
      p.depth += v;
      const auto k = static_cast<std::size_t>(std::clamp((z[i] - bed_) / row, 0.0, highest));
      if (k >= sums.size()) sums.resize(k + 1);
      sums[k].volume += v;
      sums[k].z += v * z[i];
      sums[k].u += v * u[i];
      sums[k].eddy += eddy != nullptr ? v * eddy[i] : 0;
    }
    for (const Sum& sum : sums) {
      if (sum.volume < least * row) continue;
      p.z.push_back(sum.z / sum.volume);
      p.velocity.push_back(sum.u / sum.volume);
      p.eddy_viscosity.push_back(sum.eddy / sum.volume);
    }
    return p;
  }

  // Level of the water about x by the pressure of its upper half, z + P / (rho0 g): what is left in pores or gaps below does
  // not count, as it would in a volume per length.
  [[nodiscard]] double head_at(const riffle_editor& e, double at) const {
    const double half = 4 * std::ceil(reach(e) / spacing(e)) * spacing(e), c0 = read(e, "wave_speed")[0];
    const double *x = read(e, "position", 0), *z = read(e, "position", 1), *rho = read(e, "density");
    double highest_z = bed_, weights = 0, sum = 0;
    const auto near = [&](std::int64_t i) { return 1 - std::abs(x[i] - at) / half; };
    for (std::int64_t i = 0; i < e.count && e.role[i] == RIFFLE_FLUID; ++i) {
      if (near(i) > 0) highest_z = std::max(highest_z, z[i]);
    }
    for (std::int64_t i = 0; i < e.count && e.role[i] == RIFFLE_FLUID; ++i) {
      if (!(near(i) > 0) || z[i] < 0.5 * (bed_ + highest_z)) continue;
      const double pressure = c0 * c0 / exponent_ * (std::pow(rho[i] / density_, exponent_) - 1);  // over rho0
      weights += near(i);
      sum += near(i) * (z[i] + pressure / gravity_);
    }
    return weights > 0 ? sum / weights : bed_;
  }

  // The water nearest to the end at a height: what new particles there are like, their porosity above all.
  [[nodiscard]] std::int64_t nearest(const riffle_editor& e, double level) const {
    const double *x = read(e, "position", 0), *z = read(e, "position", 1);
    std::int64_t found = 0;
    for (std::int64_t k = 1; k < e.count && e.role[k] == RIFFLE_FLUID; ++k) {
      if (std::hypot(inside_by(x[k]), z[k] - level) < std::hypot(inside_by(x[found]), z[found] - level)) found = k;
    }
    return found;
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
    const std::int64_t like = nearest(e, bed_);
    std::int64_t last = 0;
    const double l = spacing(e);
    const auto columns = static_cast<int>(std::ceil((width(e) + l) / l)),
               rows = static_cast<int>(std::ceil(reach(e) / l));
    for (int c = 0; c < columns; ++c) {
      for (int r = 0; r < rows; ++r) {
        last = add(e, like, (c + 0.5) * l, bed_ - (r + 0.5) * l);
        e.write(e.context, "velocity", 0)[last] = 0;
        set(e, "eddy_viscosity", last, 0);
      }
    }
    return last + 1;
  }
  // Gives the floor the density of water at rest below `level`; `particles` includes those added in this call.
  void press_floor(const riffle_editor& e, double level, std::int64_t particles) const {
    const double l = spacing(e), *z = read(e, "position", 1), *phi = e.read(e.context, "porosity", 0);
    double *rho = e.write(e.context, "density", 0), *m = e.write(e.context, "mass", 0);
    for (std::int64_t k = 0; k < particles; ++k) {
      const bool added = k >= e.count;
      if (!is_floor(z[k]) || (!added && (e.role[k] != role_ || !mine(e, k)))) continue;
      rho[k] = density(e, level - z[k]);
      m[k] = rho[k] * l * l * (phi != nullptr ? phi[k] : 1.0);  // its role is that of water
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
  static constexpr double highest = 1e6, least = 0.1;  // rows; share of a row that is one
  // Both ends may have buffers of one role. A particle of this end that is at the other one was taken there.
  [[nodiscard]] bool mine(const riffle_editor& e, std::int64_t k) const {
    return inside_by(read(e, "position", 0)[k]) < 0.5 * length_;
  }

  bool low_;
  double inward_;
  std::uint32_t role_;
  double density_, gravity_, exponent_, x_ = 0, length_ = 1, bed_ = 0;
};

}  // namespace riffle
