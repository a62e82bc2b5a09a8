// Steady flow along a channel of given bed b(x) and width B(x), with friction, controls and hydraulic jumps.
//
//   dH/dx = -S_f(h),   H = b + h + q^2 / (2 g h^2),   q = Q / B         (Chow 1959, eq. 9-2 and chapter 15)
//
// marched for the head H, not for the depth: without friction H is constant and the depth algebra, exact to round-off;
// over a step H is continuous (the step conserves head); a narrowing needs no term of its own. Two passes:
//   upstream   with the subcritical depth from the downstream end; where H cannot carry Q at all, it is raised to what
//              the section needs at least, b + 3/2 h_c: a control (a crest, a throat, a free fall)
//   downstream with the supercritical depth from an inlet or from each control, as long as its momentum is the larger one
// and a jump where the momentum functions q^2/h + g h^2/2 of the two are equal. This is how backwater programs treat mixed
// regimes. A supercritical flow that has the head to pass the next control does so, even where the water that the control
// could hold back would have the larger momentum: of two steady states (Baines & Whitehead 2003) it is the one without
// a jump. What it leaves out: curved streamlines at crests, and the length of a jump.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "riffle/open_channel.hpp"

namespace riffle {

class SteadyChannel {
 public:
  struct Data {
    double discharge = 0, gravity = 9.81;       // m3/s along +x, above 0
    double depth_upstream = 0;                  // m: of a supercritical inflow; 0: none
    double depth_downstream = 0;                // m: of a subcritical outflow; 0: falls freely (critical)
    double roughness = 0, friction_factor = 0;  // Manning's n [s/m^(1/3)], Darcy's f [1]: both may act
    double low = 0, high = 1;                   // m: ends of the channel
    int intervals = 20000;
    std::function<double(double)> bed, width;  // b [m], B [m] above 0
  };
  struct State {
    double depth = 0, velocity = 0;
    bool supercritical = false;
  };

  // Throws std::invalid_argument with one sentence when the ends ask for a flow that cannot be.
  explicit SteadyChannel(Data data) : d_(std::move(data)) {
    place_nodes();
    march_upstream();
    march_downstream();
  }

  // x inside [low, high]; beyond, the state of the nearer end.
  [[nodiscard]] State at(double x) const {
    const double inside = std::clamp(x, d_.low, d_.high);
    const std::size_t k = interval(inside);
    const bool fast = supercritical(inside, k);
    const double depth = depth_at(inside, k, fast);
    return {depth, unit_discharge(inside) / depth, fast};
  }
  // Places of jumps, and of controls where a supercritical flow begins, in order of x.
  [[nodiscard]] const std::vector<double>& jumps() const { return jumps_; }
  [[nodiscard]] const std::vector<double>& controls() const { return controls_; }

 private:
  [[nodiscard]] double unit_discharge(double x) const { return d_.discharge / d_.width(x); }
  [[nodiscard]] double critical_head(double x) const {
    return d_.bed(x) + 1.5 * open_channel::critical_depth(unit_discharge(x), d_.gravity);
  }
  [[nodiscard]] double depth(double x, double head, bool fast) const {
    return open_channel::depth_of_energy(head - d_.bed(x), unit_discharge(x), d_.gravity, fast);
  }
  [[nodiscard]] double friction_slope(double x, double head, bool fast) const {
    if (d_.roughness == 0 && d_.friction_factor == 0) return 0;
    const double h = depth(x, head, fast), u = unit_discharge(x) / h;
    return u * u * (d_.roughness * d_.roughness / (h * std::cbrt(h)) + d_.friction_factor / (8 * d_.gravity * h));
  }
  // The head at `to` from that at `from`: Runge and Kutta's midpoint rule, second order.
  [[nodiscard]] double step(double from, double to, double head, bool fast) const {
    const double half = (to - from) / 2, middle = head - half * friction_slope(from, head, fast);
    return head - 2 * half * friction_slope(from + half, middle, fast);
  }

  // Equal intervals, and besides each highest place of b + 3/2 h_c itself, so that a crest is not missed by half an
  // interval: the head of a frictionless flow hangs on it.
  void place_nodes() {
    const auto n = static_cast<std::size_t>(d_.intervals);
    std::vector<double> even(n + 1), need(n + 1);
    for (std::size_t k = 0; k <= n; ++k) {
      even[k] = d_.low + (d_.high - d_.low) * static_cast<double>(k) / static_cast<double>(n);
      need[k] = critical_head(even[k]);
    }
    for (std::size_t k = 0; k <= n; ++k) {
      const bool crest = k > 0 && k < n && need[k] > need[k - 1] && need[k] >= need[k + 1];
      const double top = crest ? highest(even[k - 1], even[k + 1]) : even[k];
      if (crest && top < even[k]) x_.push_back(top);
      x_.push_back(even[k]);
      if (crest && top > even[k]) x_.push_back(top);
    }
  }
  [[nodiscard]] double highest(double a, double b) const {  // golden section
    constexpr double ratio = 0.6180339887498949;
    double c = b - ratio * (b - a), e = a + ratio * (b - a);
    for (int i = 0; i < 60; ++i) {
      if (critical_head(c) >= critical_head(e)) {
        b = e, e = c, c = b - ratio * (b - a);
      } else {
        a = c, c = e, e = a + ratio * (b - a);
      }
    }
    return (a + b) / 2;
  }

  void march_upstream() {
    const std::size_t n = x_.size();
    slow_.resize(n);
    control_.assign(n, 0);
    const double end = d_.high, q = unit_discharge(end), hc = open_channel::critical_depth(q, d_.gravity);
    if (d_.depth_downstream > 0 && d_.depth_downstream < hc) {
      throw std::invalid_argument(
          "depth_downstream is below the critical depth there, and a supercritical outflow "
          "takes its depth from upstream; leave it out");
    }
    double head = critical_head(end);
    if (d_.depth_downstream > 0) head = d_.bed(end) + open_channel::specific_energy(d_.depth_downstream, q, d_.gravity);
    for (std::size_t k = n; k-- > 0;) {
      if (k + 1 < n) head = step(x_[k + 1], x_[k], head, false);
      const double need = critical_head(x_[k]);
      control_[k] = head <= need ? 1 : 0;
      head = std::max(head, need);
      slow_[k] = head;
    }
  }

  void march_downstream() {
    const std::size_t n = x_.size();
    fast_.assign(n, 0);
    regime_.assign(n, 0);
    bool running = false;
    double head = 0;
    std::size_t passes = 0;  // up to this node the supercritical flow needs no comparison
    const double q = unit_discharge(d_.low), hc = open_channel::critical_depth(q, d_.gravity);
    if (d_.depth_upstream > 0) {
      if (!(d_.depth_upstream < hc)) {
        throw std::invalid_argument(
            "depth_upstream is not below the critical depth there, and a subcritical inflow "
            "takes its depth from downstream; give depth_downstream");
      }
      head = d_.bed(d_.low) + open_channel::specific_energy(d_.depth_upstream, q, d_.gravity);
      running = true;
    }
    for (std::size_t k = 0; k < n; ++k) {
      if (k > 0 && running) head = step(x_[k - 1], x_[k], head, true);
      const bool before = running;
      if (running && k >= passes && excess(x_[k], head, slow_[k]) < 0) {
        passes = beyond_next_control(k, head);
        running = passes > k;
      }
      running = running && !(head < critical_head(x_[k]));
      if (before && !running) {
        if (k == 0) throw std::invalid_argument("the supercritical inflow is drowned by the water downstream");
        fast_[k] = std::max(head, critical_head(x_[k]));
        jumps_.push_back(jump_between(k - 1));
      }
      if (!running && control_[k] != 0 && k + 1 < n) {
        head = slow_[k];
        running = true;
        controls_.push_back(x_[k]);
      }
      if (running) fast_[k] = head;
      regime_[k] = running ? 1 : 0;
    }
  }

  // The node behind the next control, when a supercritical flow of that head at node k gets there; else k.
  [[nodiscard]] std::size_t beyond_next_control(std::size_t k, double head) const {
    for (std::size_t j = k; j < x_.size(); ++j) {
      if (j > k) head = step(x_[j - 1], x_[j], head, true);
      if (head < critical_head(x_[j])) return k;
      if (control_[j] != 0) return j + 1;
    }
    return d_.depth_downstream > 0 ? k : x_.size();  // a free fall holds nothing back
  }
  // Momentum of the supercritical flow beyond that of the subcritical one.
  [[nodiscard]] double excess(double x, double fast_head, double slow_head) const {
    const double q = unit_discharge(x);
    const double fast = open_channel::momentum_function(depth(x, fast_head, true), q, d_.gravity);
    const double slow = open_channel::momentum_function(depth(x, slow_head, false), q, d_.gravity);
    return fast - slow + 1e-13 * slow;  // where both are critical they are equal, to round-off
  }
  [[nodiscard]] double jump_between(std::size_t k) const {
    double a = x_[k], b = x_[k + 1];
    for (int i = 0; i < 60; ++i) {
      const double middle = (a + b) / 2;
      (excess(middle, head_at(middle, k, true), head_at(middle, k, false)) > 0 ? a : b) = middle;
    }
    return (a + b) / 2;
  }

  [[nodiscard]] std::size_t interval(double x) const {
    const auto above = std::upper_bound(x_.begin(), x_.end(), x) - x_.begin();
    return static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(x_.size()) - 2));
  }
  [[nodiscard]] double head_at(double x, std::size_t k, bool fast) const {
    const std::vector<double>& head = fast ? fast_ : slow_;
    return head[k] + (head[k + 1] - head[k]) * (x - x_[k]) / (x_[k + 1] - x_[k]);
  }
  [[nodiscard]] double depth_at(double x, std::size_t k, bool fast) const {
    return depth(x, head_at(x, k, fast), fast);
  }
  [[nodiscard]] bool supercritical(double x, std::size_t k) const {
    if (regime_[k] != 0 && regime_[k + 1] != 0) return true;
    if (regime_[k] == 0) return false;
    const auto jump = std::lower_bound(jumps_.begin(), jumps_.end(), x_[k]);
    return jump == jumps_.end() || x < *jump;
  }

  Data d_;
  std::vector<double> x_, slow_, fast_;  // nodes; heads of both flows there
  std::vector<std::uint8_t> control_, regime_;
  std::vector<double> jumps_, controls_;
};

}  // namespace riffle
