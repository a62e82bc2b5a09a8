// Dam break over a step of the bed, the dam standing on the step: water at rest, h_l upstream of it and h_r on it (the
// deeper level sends a rarefaction back, a shock runs into the shallower one, and a jump of the depth stands at the step):
//
//   u_1 = 2 (sqrt(g h_l) - sqrt(g h_1)),   u_2 = (h_2 - h_r) sqrt(g/2 (h_2 + h_r) / (h_2 h_r)),   h_1 u_1 = h_2 u_2
//
// and one relation across the step of height z, about which the literature is of two minds:
//   head      h_1 + u_1^2/2g = h_2 + u_2^2/2g + z                 Alcrudo & Benkhaldoun (2001); what SWASHES prints
//   momentum  h_1 u_1^2 + g h_1^2/2 = h_2 u_2^2 + g h_2^2/2 + g z (h_1 - z/2)        Bernetti, Titarev & Toro (2008)
//             (z > 0; for a step down the hydrostatic thrust on its face is that of the downstream side)
// They differ by 0.2 to 0.9 % in depth: name the one that a scheme is to be compared with.
// Errors are relative to h in depth and to sqrt(g h) in velocity, after eq. 17 of Diwakar & Mohapatra (2023).
// Not in it: flow that is critical at the step or dry beside it (refused), friction, the ends of the channel.
#include <algorithm>
#include <cmath>
#include <riffle/open_channel.hpp>
#include <riffle/sdk.hpp>
#include <sstream>

namespace f = riffle::fields;
namespace oc = riffle::open_channel;

struct RiemannOverStep {
  static constexpr auto id = "riemann-over-step", kind = "reference", version = "1.0.0";
  static constexpr auto summary = "Exact dam break over a step of the bed";
  static constexpr auto source =
      "Alcrudo & Benkhaldoun (2001); Bernetti, Titarev & Toro (2008) for the momentum relation; SWASHES 1.05";
  static constexpr auto leaves_out =
      "flow that becomes critical at the step; a dry bed; friction; the ends of the channel";
  static constexpr std::uint32_t dims = 1u << 1;
  static constexpr riffle_parameter parameters[] = {
      riffle::required_real("dam_position", "m", -1e6, 1e6,
                            "x of the dam and of the step; the bed is that of the scene"),
      riffle::required_real("depth_left", "m", 0, 1e4, "depth at rest where x < dam_position", RIFFLE_ABOVE_MIN),
      riffle::required_real("depth_right", "m", 0, 1e4, "depth at rest where x > dam_position", RIFFLE_ABOVE_MIN),
      riffle::choice("conserves", "head|momentum", "head", "what is equal on both sides of the step"),
      riffle::real("gravity", "m.s-2", 9.81, 0, 1000, "acceleration of gravity", RIFFLE_ABOVE_MIN, "fluid.gravity")};
  static constexpr const riffle_field* gives[] = {&f::depth, &f::velocity};

  explicit RiemannOverStep(const riffle::Values& v)
      : x_dam(v.number("dam_position")),
        left(v.number("depth_left")),
        right(v.number("depth_right")),
        g(v.number("gravity")),
        by_head(v.word("conserves") == "head") {}

  void connect(const riffle_services& s) {
    const double x[] = {std::nextafter(x_dam, -1e300), x_dam};
    double level[2] = {0, 0}, slope[2] = {0, 0};
    s.bed(s.context, 2, x, nullptr, level, slope, nullptr);
    solve(level[1] - level[0]);
  }

  void solve(double rise) {
    direction = left >= right + rise ? 1 : -1;
    z = direction * rise;
    deep = direction > 0 ? left : right;  // the side with the higher level
    shallow = direction > 0 ? right : left;
    if (deep <= std::max(z, 0.0)) refuse("the water does not reach over the step");
    double low = 4 * deep / 9, high = deep;  // of h_1: the discharge grows from 0 to its maximum
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      if (!(middle > low && middle < high)) break;
      (beyond(middle) ? low : high) = middle;
    }
    if (low == 4 * deep / 9 || !downstream(low) || !downstream(high))
      refuse("the flow would become critical at the step");
    h1 = high;
    u1 = 2 * (std::sqrt(g * deep) - std::sqrt(g * h1));
    h2 = h2_found;
    u2 = h1 * u1 / h2;
    shock = h2 > shallow ? h2 * u2 / (h2 - shallow) : std::sqrt(g * shallow);
  }

  // The subcritical depth behind the step for the depth h in front of it, into h2_found; false where there is none.
  bool downstream(double h) {
    const double u = 2 * (std::sqrt(g * deep) - std::sqrt(g * h)), q = h * u, hc = oc::critical_depth(q, g);
    if (by_head) {
      const double energy = h + u * u / (2 * g) - z;
      h2_found = q > 0 ? oc::depth_of_energy(energy, q, g, false) : energy;
      return energy > 1.5 * hc;
    }
    // g z (h_1 - z/2) acts on a step up; on a step down of height -z the face sees the downstream depth
    const double momentum = h * u * u + g * h * h / 2;
    const auto excess = [&](double d) {
      return q * q / d + g * d * d / 2 + (z > 0 ? g * z * (h - z / 2) : g * z * (d + z / 2)) - momentum;
    };
    double low = std::max(hc, -z), high = deep + std::abs(z);
    if (excess(low) > 0) return false;
    for (int i = 0; i < 200 && low < high; ++i) {
      const double middle = (low + high) / 2;
      if (!(middle > low && middle < high)) break;
      (excess(middle) < 0 ? low : high) = middle;
    }
    h2_found = high;
    return true;
  }
  // Whether h_1 lies below the solution: the discharge would be more than the shock can take.
  bool beyond(double h) {
    const double q = 2 * h * (std::sqrt(g * deep) - std::sqrt(g * h));
    if (!downstream(h)) return true;
    const double d = h2_found;
    if (d <= shallow) return true;
    return q / d > (d - shallow) * std::sqrt(g / 2 * (d + shallow) / (d * shallow));
  }
  [[noreturn]] void refuse(const char* why) const {
    std::ostringstream text;
    text << "riemann-over-step has no answer for depths of " << left << " m and " << right << " m here: " << why;
    throw std::invalid_argument(text.str());
  }

  void exact(const riffle_points& points, double* const* values, double* const* scales, std::uint8_t* defined) const {
    const double c = std::sqrt(g * deep), t = points.time, tail = u1 - std::sqrt(g * h1);
    for (std::int64_t k = 0; k < points.n; ++k) {
      const double x = direction * (points.x[0][k] - x_dam);
      double h = shallow, u = 0;
      if (x < -c * t) {
        h = deep;
      } else if (x < tail * t) {
        h = (2 * c - x / t) * (2 * c - x / t) / (9 * g);
        u = 2 * (c + x / t) / 3;
      } else if (x < 0) {
        h = h1, u = u1;
      } else if (x < shock * t) {
        h = h2, u = u2;
      }
      values[0][k] = h;
      values[1][k] = direction * u;
      scales[0][k] = h;
      scales[1][k] = std::sqrt(g * h);
      defined[k] = h2 > 0 ? 1 : 0;
    }
  }
  double x_dam, left, right, g;
  bool by_head;
  double direction = 1, z = 0, deep = 1, shallow = 1, h1 = 0, u1 = 0, h2 = 0, u2 = 0, h2_found = 0, shock = 0;
};

RIFFLE_PLUGIN(RiemannOverStep)
