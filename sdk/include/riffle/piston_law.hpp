// Motions of a piston that makes a solitary wave of height H in water of depth h0, running away from it. The piston starts at
// X = 0 at t = 0, at rest but for what is cut off of the wave's tail.
//
//   serre     the water moves with the piston: dX/dt = c eta / (h0 + eta), eta = H sech^2(k (c (t - t0) - X')), with the wave
//             of the Serre equations, k = sqrt(3 H) / (2 h0 sqrt(h0 + H)), c = sqrt(g (h0 + H)): exact for those
//   goring    the same with the first-order k = sqrt(3 H / (4 h0^3))                                    Goring (1978)
//   explicit  X = S/2 [tanh 7.6 (t/T - 1/2) + tanh 3.8],  S = 4 sqrt(H h0 / 3),
//             T = 2 (3.8 + H/h0) / (k c)                                           Kazemi (2017) eqs 5.9, 5.10
//
// X' = X - X(t0). The first two are implicit: with theta = c (t - t0) - X' they read
//   h0 theta + (H / k) tanh(k theta) = c h0 (t - t0),   X' = (H / (k h0)) tanh(k theta)
// whose left side grows with theta, so that Newton's method finds it from anywhere. The explicit law leaves X' out of the
// argument: its largest speed is S 3.8 / T, by a third more than c H / (h0 + H), and the wave sheds a trough. Use it to
// repeat what was made with it, and serre for waves that shall keep their shape.
// At the end the piston has displaced S h0 = 2 H / k, the volume of the wave.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace riffle {

class PistonLaw {
 public:
  enum Kind { serre, goring, explicit_law };
  // Metres and m/s2. `reach` is k theta at the start of the implicit laws: sech^2(4.5) is 5e-4.
  PistonLaw(Kind kind, double depth, double height, double gravity, double reach = 4.5)
      : kind_(kind), h0_(depth), height_(height), reach_(kind == explicit_law ? 3.8 : reach) {
    if (!(depth > 0 && height > 0 && gravity > 0 && reach > 0)) {
      throw std::invalid_argument("a solitary wave needs a depth, a height and a gravity above 0");
    }
    k_ = kind == serre ? std::sqrt(3 * height) / (2 * depth * std::sqrt(depth + height))
                       : std::sqrt(3 * height / (4 * depth * depth * depth));
    c_ = std::sqrt(gravity * (depth + height));
  }

  [[nodiscard]] double wave_number() const { return k_; }  // 1/m
  [[nodiscard]] double speed() const { return c_; }        // m/s, of the wave
  [[nodiscard]] double stroke() const { return 2 * height_ / (k_ * h0_); }
  // From t = 0 until the piston has as little way to go as it had gone before.
  [[nodiscard]] double duration() const {
    const double rest = kind_ == explicit_law ? 1 : std::tanh(reach_);
    return 2 / (k_ * c_) * (reach_ + height_ / h0_ * rest);
  }
  [[nodiscard]] double displacement(double time) const {
    return 0.5 * stroke() * (std::tanh(phase(time)) + std::tanh(reach_));
  }
  [[nodiscard]] double velocity(double time) const {
    const double sech = 1 / std::cosh(std::min(std::abs(phase(time)), 300.0));
    if (kind_ == explicit_law) return 0.5 * stroke() * sech * sech * 2 * reach_ / duration();
    const double eta = height_ * sech * sech;
    return c_ * eta / (h0_ + eta);
  }

 private:
  // k theta
  [[nodiscard]] double phase(double time) const {
    const double half = duration() / 2, share = height_ / h0_;
    if (kind_ == explicit_law) return reach_ * (time - half) / half;
    const double wanted = k_ * c_ * (time - half);
    double p = wanted / (1 + (std::abs(wanted) < 1 ? share : 0));
    for (int i = 0; i < 50; ++i) {
      const double t = std::tanh(p), step = (p + share * t - wanted) / (1 + share * (1 - t * t));
      p -= step;
      if (std::abs(step) <= 1e-15 * (1 + std::abs(p))) break;
    }
    return p;
  }

  Kind kind_;
  double h0_, height_, reach_, k_ = 0, c_ = 0;
};

}  // namespace riffle
