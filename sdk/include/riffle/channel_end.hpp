// An open end of a channel in one dimension: water inside, buffer particles beyond, and what crosses from one to the
// other. The boundary plugins inflow and outflow decide the state of the buffer; this puts it into practice.
//
//   end x_min:   b   b   b   b | w   w   w   w ...        b buffer, w water, | the end of the domain
//
// Buffer particles move with the imposed velocity. One that enters the domain becomes water, water that leaves it becomes
// buffer, and at the outer end particles are added or removed so that the last water particle never sees beyond them.
// The nearest one stands where it came to stand; those behind it are spaced as their volume asks, V / (h B), so that a
// summation finds the imposed depth, and V particles pass per V / Q seconds. Diwakar & Mohapatra (2023), fig. 1b.
// Every field that describes the water is set if it exists; velocities in this file count positive into the domain.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "riffle/abi.h"

namespace riffle {

struct FlowState {
  double depth = 0, velocity = 0;  // m; m/s, positive into the domain
};

class ChannelEnd {
 public:
  // What it remembers in riffle_editor.state: the depth that a summation finds on a regular lattice over the depth that
  // its volumes stand for (1 unless the kernel is too narrow for its support), 0 until it is known.
  static constexpr std::int32_t state_size = 1;

  ChannelEnd(bool low, std::uint32_t role, double gravity)
      : inward_(low ? 1.0 : -1.0), low_(low), role_(role), gravity_(gravity) {}

  void connect(const riffle_services& s) {
    x_ = low_ ? s.low[0] : s.high[0];
    middle_ = 0.5 * (s.low[0] + s.high[0]);
    s.width(s.context, 1, &x_, &width_, nullptr);
    s.bed(s.context, 1, &x_, nullptr, &bed_, nullptr, nullptr);
  }
  [[nodiscard]] double x() const { return x_; }
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double bed() const { return bed_; }
  [[nodiscard]] double wave_speed(double depth) const { return std::sqrt(gravity_ * depth); }
  // Momentum and pressure force per unit width over density and gravity: the larger one drives a jump.
  [[nodiscard]] double specific_force(double q, double depth) const {
    return q * q / (gravity_ * depth) + 0.5 * depth * depth;
  }
  [[nodiscard]] double value(const riffle_function* f, double time) const {
    double out = 0;
    f->evaluate(f->context, 1, &x_, nullptr, nullptr, time, &out);
    return out;
  }

  // The third water particle from the end: far enough from the buffer to show what the water itself does.
  [[nodiscard]] FlowState inside(const riffle_editor& e) const {
    const std::vector<std::int64_t> water = nearest_water(e);
    return water.empty() ? FlowState{} : state_of(e, water[std::min<std::size_t>(2, water.size() - 1)]);
  }

  // The same, extended to the end along the line through the third and the sixth particle, without which waves come back
  // with a part of their height; at a shock, where a line would lead astray, the third alone.
  [[nodiscard]] FlowState at_end(const riffle_editor& e) const {
    const std::vector<std::int64_t> water = nearest_water(e);
    if (water.size() < 6) return inside(e);
    const double* x = read(e, "position");
    const FlowState third = state_of(e, water[2]), sixth = state_of(e, water[5]);
    const double to_end = distance(x[water[2]]), extend = to_end / (distance(x[water[5]]) - to_end);
    const double dh = third.depth - sixth.depth, du = third.velocity - sixth.velocity;
    const bool smooth = std::abs(dh) < steepest * third.depth && std::abs(du) < steepest * wave_speed(third.depth);
    return smooth && extend < 2 ? FlowState{third.depth + extend * dh, third.velocity + extend * du} : third;
  }

  // Depths and discharges as a summation sees them are those of the manifest times this. Measured once, at the first
  // call after t = 0, where water lies on a regular lattice; 1 elsewhere.
  [[nodiscard]] double lattice_factor(const riffle_editor& e) const {
    double& known = e.state[0];
    if (e.dt == 0) return 1;
    if (known == 0) known = measure(e);
    return known;
  }

  // Makes the buffer what it shall be for the next step.
  void impose(const riffle_editor& e, FlowState state) const {
    std::vector<std::int64_t> water = nearest_water(e);
    if (water.empty()) return;
    const double* x = read(e, "position");
    std::vector<Particle> buffer = retag(e, x, water);
    const double *volume = read(e, "volume"), *reach = e.reach;
    const double* extent = fixed(e) ? read(e, "extent") : nullptr;
    const double per_volume = (e.dt == 0 ? 1.0 : e.state[0]) / (state.depth * width_);
    const auto length_of = [&](std::int64_t k) { return extent != nullptr ? extent[k] : volume[k] * per_volume; };
    double farthest = 0;  // that anybody sees
    for (const std::int64_t k : water) farthest = std::max(farthest, reach[k]);
    for (Particle& b : buffer) {
      farthest = std::max(farthest, reach[b.index]);
      b.length = length_of(b.index);
    }
    const std::int64_t like = buffer.empty() ? water.front() : buffer.back().index;
    const Particle added{0, 0, length_of(like), true};
    const double needed = 1.5 * farthest + added.length,  // within a step nobody moves by half of it
        nearest = distance(x[water.front()]);
    if (buffer.empty() && role_ == RIFFLE_OUTFLOW && nearest > needed) return;  // dry so far
    if (!(needed / added.length < most))
      throw std::runtime_error("more than 10000 buffer particles would be needed: the depth is too large");
    double before = buffer.empty() ? length_of(water.front()) : 0, at = buffer.empty() ? -nearest : 0;
    std::size_t k = 0;
    for (; k < buffer.size() || at < needed; ++k) {
      if (k == buffer.size()) buffer.push_back(added);
      Particle& b = buffer[k];
      at = before == 0 ? b.outward : std::max(0.0, at + 0.5 * (before + b.length));
      b.outward = at;
      before = b.length;
      if (at >= needed + 2 * b.length) break;  // two more than needed may stay
    }
    for (; buffer.size() > k + 1; buffer.pop_back()) e.remove(e.context, buffer.back().index);
    for (Particle& b : buffer) {
      if (b.is_new) b.index = e.add(e.context, role_, like);
    }
    write(e, buffer, state, water);
  }

 private:
  struct Particle {
    std::int64_t index = 0;
    double outward = 0, length = 0;  // distance from the end; what it takes of the channel
    bool is_new = false;
  };
  static constexpr std::size_t most = 10000, looked_at = 16;
  static constexpr double steepest = 0.2;  // change over three particles that is still taken for a smooth one

  [[nodiscard]] FlowState state_of(const riffle_editor& e, std::int64_t k) const {
    return {read(e, "depth")[k], inward_ * read(e, "velocity")[k]};
  }
  [[nodiscard]] double distance(double x) const { return inward_ * (x - x_); }  // positive inside
  // Particles that stand still while the water passes have a length of their own that nothing changes.
  static bool fixed(const riffle_editor& e) {
    return e.read(e.context, "extent", 0) != nullptr && e.read(e.context, "extent_rate", 0) == nullptr;
  }
  [[nodiscard]] bool mine(double x) const { return low_ ? x < middle_ : x >= middle_; }

  static const double* read(const riffle_editor& e, const char* name) {
    const double* values = e.read(e.context, name, 0);
    if (values == nullptr)
      throw std::runtime_error(std::string("there is no field \"") + name +
                               "\": open ends are for shallow-water equation sets");
    return values;
  }

  // The water particles nearest to the end, nearest first. Roles are grouped, and sorted by x but for the last step.
  [[nodiscard]] std::vector<std::int64_t> nearest_water(const riffle_editor& e) const {
    const auto all = std::lower_bound(e.role, e.role + e.count, RIFFLE_FLUID + 1u) - e.role;
    const auto n = std::min<std::int64_t>(all, looked_at);
    std::vector<std::int64_t> found;
    for (std::int64_t k = 0; k < n; ++k) found.push_back(low_ ? k : all - 1 - k);
    const double* x = read(e, "position");
    std::stable_sort(found.begin(), found.end(),
                     [&](std::int64_t a, std::int64_t b) { return distance(x[a]) < distance(x[b]); });
    return found;
  }

  // Who has crossed changes role. Returns the buffer, nearest first; `water` is what stays inside.
  std::vector<Particle> retag(const riffle_editor& e, const double* x, std::vector<std::int64_t>& water) const {
    std::vector<Particle> buffer;
    std::vector<std::int64_t> inside;
    for (const std::int64_t k : water) {
      if (distance(x[k]) >= 0) {
        inside.push_back(k);
        continue;
      }
      e.retag(e.context, k, role_);
      buffer.push_back({k, -distance(x[k])});
    }
    const auto begin = std::lower_bound(e.role, e.role + e.count, role_) - e.role;
    for (std::int64_t k = begin; k < e.count && e.role[k] == role_; ++k) {
      if (!mine(x[k])) continue;
      if (distance(x[k]) >= 0) {
        e.retag(e.context, k, RIFFLE_FLUID);
        inside.push_back(k);
      } else {
        buffer.push_back({k, -distance(x[k])});
      }
    }
    std::stable_sort(buffer.begin(), buffer.end(),
                     [](const Particle& a, const Particle& b) { return a.outward < b.outward; });
    if (!inside.empty()) water = inside;
    return buffer;
  }

  [[nodiscard]] double measure(const riffle_editor& e) const {
    const std::vector<std::int64_t> water = nearest_water(e);
    if (water.size() < looked_at || e.read(e.context, "extent", 0) != nullptr) return 1;
    const double *x = read(e, "position"), *depth = read(e, "depth"), *volume = read(e, "volume");
    const auto from = water[4], to = water[8];  // beyond the reach of the buffer
    const double spacing = std::abs(x[to] - x[from]) / 4;
    for (std::size_t k = 4; k < 8; ++k) {
      if (std::abs(std::abs(x[water[k + 1]] - x[water[k]]) / spacing - 1) > 1e-6) return 1;
    }
    return depth[water[6]] * spacing * width_ / volume[water[6]];
  }

  // Only what changes is written: the host computes anew what depends on it.
  static void set(const riffle_editor& e, const char* name, const std::vector<Particle>& buffer,
                  const std::vector<double>& values, double tolerance = 0) {
    const double* now = e.read(e.context, name, 0);
    if (now == nullptr) return;
    const auto differs = [&](std::size_t k) { return !(std::abs(now[buffer[k].index] - values[k]) <= tolerance); };
    bool any = false;
    for (std::size_t k = 0; k < buffer.size() && !any; ++k) any = differs(k);
    if (!any) return;
    double* to = e.write(e.context, name, 0);
    for (std::size_t k = 0; k < buffer.size(); ++k) to[buffer[k].index] = values[k];
  }

  void write(const riffle_editor& e, const std::vector<Particle>& buffer, FlowState state,
             const std::vector<std::int64_t>& water) const {
    const std::size_t n = buffer.size();
    const double *l = read(e, "smoothing_length"), *depth = read(e, "depth"), *volume = read(e, "volume");
    const auto each = [&](const auto& f) {
      std::vector<double> values(n);
      for (std::size_t k = 0; k < n; ++k) values[k] = f(buffer[k]);
      return values;
    };
    const auto all = [&](double value) { return std::vector<double>(n, value); };
    const std::int64_t near = water.front();
    // The support of the nearest water; where supports differ they follow V / h.
    const bool alike = std::all_of(water.begin(), water.end(), [&](std::int64_t k) { return l[k] == l[near]; });
    const auto lengths = each([&](const Particle& b) {
      return alike ? l[near] : l[near] * (volume[b.index] / volume[near]) * (depth[near] / state.depth);
    });
    const double u = inward_ * state.velocity;
    set(e, "position", buffer, each([&](const Particle& b) { return x_ - inward_ * b.outward; }), 1e-12 * l[near]);
    set(e, "smoothing_length", buffer, lengths, 1e-12 * l[near]);
    set(e, "velocity", buffer, all(u));
    set(e, "depth", buffer, all(state.depth));
    set(e, "wave_speed", buffer, all(wave_speed(state.depth)));
    if (e.read(e.context, "extent", 0) == nullptr) return;
    if (fixed(e)) set(e, "volume", buffer, each([&](const Particle& b) { return b.length * state.depth; }));
    volume = read(e, "volume");
    set(e, "extent", buffer, each([&](const Particle& b) { return b.length; }));
    set(e, "momentum", buffer, each([&](const Particle& b) { return volume[b.index] * u; }));
    if (!fixed(e)) set(e, "particle_velocity", buffer, all(u));
  }

  double inward_;
  bool low_;
  std::uint32_t role_;
  double gravity_, x_ = 0, middle_ = 0, width_ = 1, bed_ = 0;
};

}  // namespace riffle
