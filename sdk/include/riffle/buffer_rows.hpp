// The buffer of an inflow in the vertical plane as rows of particles that share the depth evenly: riffle/open_end.hpp.
//
// All particles of a row move alike and stand a spacing apart, so that the row of depth dz and velocity u brings u dz per
// second. A row is known again by the level of its particles.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "riffle/open_end.hpp"

namespace riffle {

class BufferRows {
 public:
  // Those that are there; the depth and the number of rows with which they were written.
  BufferRows(const OpenEnd& end, const riffle_editor& e, double depth, double rows)
      : end_(end), depth_(depth), members_(static_cast<std::size_t>(rows)), count_(e.count) {
    const double* z = OpenEnd::read(e, "position", 1);
    for (std::int64_t k = 0; k < e.count; ++k) {
      if (!end.is_buffer(e, k)) continue;
      const auto row = static_cast<std::size_t>(std::max(0.0, (z[k] - end.bed()) / height()));
      members_[std::min(row, members_.size() - 1)].push_back(k);
    }
  }
  [[nodiscard]] double depth() const { return depth_; }
  [[nodiscard]] std::size_t size() const { return members_.size(); }
  [[nodiscard]] double level() const { return end_.bed() + depth_; }
  [[nodiscard]] std::int64_t particles() const { return count_; }  // those that were added included
  [[nodiscard]] bool empty() const {
    return std::all_of(members_.begin(), members_.end(), [](const auto& row) { return row.empty(); });
  }
  [[nodiscard]] double height() const { return depth_ / static_cast<double>(members_.size()); }
  [[nodiscard]] double middle(std::size_t k) const { return end_.bed() + (static_cast<double>(k) + 0.5) * height(); }
  // Share of the row that is water, as a height: phi dz.
  [[nodiscard]] double open_height(const riffle_editor& e, std::size_t k) const {
    const double* phi = e.read(e.context, "porosity", 0);
    return height() * (phi != nullptr && !members_[k].empty() ? phi[members_[k].front()] : 1.0);
  }

  // Rows over the width of the buffer, of particles like the water inside.
  void fill(const riffle_editor& e) {
    for (std::size_t k = 0; k < members_.size(); ++k) extend(e, k, end_.nearest(e, middle(k)));
  }

  // Particles that have entered become water, and others follow them; water that has left is taken out.
  void pass_on(const riffle_editor& e) {
    const double *x = OpenEnd::read(e, "position", 0), l = OpenEnd::spacing(e);
    bool due = false;
    for (const auto& row : members_) {
      double outermost = -infinite;
      for (const std::int64_t k : row) {
        due = due || end_.inside_by(x[k]) > OpenEnd::slack * l;
        outermost = std::max(outermost, -end_.inside_by(x[k]));
      }
      due = due || outermost < OpenEnd::reach(e) + 0.5 * l;
    }
    for (std::int64_t k = 0; k < e.count && e.role[k] == RIFFLE_FLUID; ++k) {
      if (end_.inside_by(x[k]) < -OpenEnd::slack * l) e.remove(e.context, k);
    }
    if (!due) return;
    for (std::size_t r = 0; r < members_.size(); ++r) {
      std::vector<std::int64_t> left;
      std::int64_t last = -1;
      for (const std::int64_t k : members_[r]) {
        if (last < 0 || end_.inside_by(x[k]) < end_.inside_by(x[last])) last = k;
        if (end_.inside_by(x[k]) < 0)
          left.push_back(k);
        else
          e.retag(e.context, k, RIFFLE_FLUID);
      }
      members_[r] = left;
      if (last >= 0) extend(e, r, last);
      x = OpenEnd::read(e, "position", 0);
    }
  }

  // The depth, and as many rows as it has spacings.
  void become(const riffle_editor& e, double depth) {
    depth_ = depth;
    const double rows = depth / OpenEnd::spacing(e);
    while (rows > static_cast<double>(members_.size()) + change) {
      std::vector<std::int64_t> top;
      for (const std::int64_t k : members_.back()) {
        const double out = -end_.inside_by(OpenEnd::read(e, "position", 0)[k]);
        top.push_back(added(end_.add(e, k, out, end_.bed() + depth)));
      }
      members_.push_back(top);
    }
    while (members_.size() > 1 && rows < static_cast<double>(members_.size()) - change) {
      for (const std::int64_t k : members_.back()) e.remove(e.context, k);
      members_.pop_back();
    }
  }

  // Of the rows as they are; positive into the domain.
  [[nodiscard]] std::vector<double> velocities(const riffle_editor& e, double inward) const {
    const double* u = OpenEnd::read(e, "velocity", 0);
    std::vector<double> out(members_.size(), 0);
    for (std::size_t k = 0; k < out.size(); ++k) {
      if (!members_[k].empty()) out[k] = inward * u[members_[k].front()];
    }
    return out;
  }

  // Places, velocities, the density of water at rest and what goes with it. `u` positive into the domain.
  void write(const riffle_editor& e, const std::vector<double>& u, const EndProfile& inside) const {
    const double l = OpenEnd::spacing(e);
    double *z = e.write(e.context, "position", 1), *along = e.write(e.context, "velocity", 0);
    double *up = e.write(e.context, "velocity", 1), *rho = e.write(e.context, "density", 0);
    double* mass = e.write(e.context, "mass", 0);
    double* eddy =
        e.read(e.context, "eddy_viscosity", 0) != nullptr ? e.write(e.context, "eddy_viscosity", 0) : nullptr;
    for (std::size_t r = 0; r < members_.size(); ++r) {
      const double here = middle(r), density = end_.density(e, level() - here), open = open_height(e, r);
      for (const std::int64_t k : members_[r]) {
        z[k] = here;
        along[k] = end_.inward() * u[r];
        up[k] = 0;
        rho[k] = density;
        mass[k] = density * open * l;
        if (eddy != nullptr) eddy[k] = inside.at(inside.eddy_viscosity, here);
      }
    }
  }

 private:
  static constexpr double infinite = 1e300, change = 0.75;  // spacings before a row comes or goes
  void extend(const riffle_editor& e, std::size_t row, std::int64_t like) {
    const double l = OpenEnd::spacing(e), width = OpenEnd::width(e);
    double out = members_[row].empty() ? -0.5 * l : -infinite;
    for (const std::int64_t k : members_[row]) out = std::max(out, -end_.inside_by(OpenEnd::read(e, "position", 0)[k]));
    while (out < width) {
      out += l;
      members_[row].push_back(added(end_.add(e, like, out, middle(row))));
    }
  }
  std::int64_t added(std::int64_t k) {
    count_ = std::max(count_, k + 1);
    return k;
  }

  const OpenEnd& end_;
  double depth_;
  std::vector<std::vector<std::int64_t>> members_;
  std::int64_t count_;
};

}  // namespace riffle
