#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "host/plugins/call.hpp"
#include "host/plugins/contracts.hpp"

namespace riffle {
namespace {

constexpr double tolerance = 1e-10;  // of the largest value; quadrature and rounding stay below 1e-12
constexpr double length = 0.5;       // smoothing length of most checks: q = r / l is exact
constexpr std::array<const char*, RIFFLE_KERNEL_OUTPUTS> output_names{"W",       "F",           "dW/dl",
                                                                      "d2W/dr2", "d2W/(dr dl)", "d2W/dl2"};
enum Output { w, f, w_l, w_rr, w_rl, w_ll };

// Gauss-Legendre with 5 points on [-1, 1], exact to degree 9.
constexpr std::array<double, 5> gauss_x{-0.90617984593866399280, -0.53846931010568309104, 0, 0.53846931010568309104,
                                        0.90617984593866399280};
constexpr std::array<double, 5> gauss_w{0.23692688505618908751, 0.47862867049936646804, 0.56888888888888888889,
                                        0.47862867049936646804, 0.23692688505618908751};

using Values = std::array<std::vector<double>, RIFFLE_KERNEL_OUTPUTS>;

// What is integrated, one per output; W itself over space.
using Integrals = std::array<double, RIFFLE_KERNEL_OUTPUTS>;
constexpr Output over_space = w;

class KernelCheck {
 public:
  explicit KernelCheck(const PluginInstance& instance) : instance_(instance), dim_(instance.dim()) {
    kernel_.size = sizeof kernel_;
    riffle_error error = no_error();
    const auto status = call_plugin(error, [&] {
      may_throw(instance.table().kernel)(instance.self(), &kernel_);
      return RIFFLE_OK;
    });
    if (status != RIFFLE_OK) fail(message_of(error));
  }

  std::vector<std::string> run() {
    if (problems_.empty()) check_claims();
    if (problems_.empty()) check_support();
    if (problems_.empty()) check_form();
    if (problems_.empty()) check_integrals();
    return std::move(problems_);
  }

 private:
  void fail(const std::string& what) { problems_.push_back(fmt::format("{}: {}", instance_.name(), what)); }
  [[nodiscard]] bool gives(int output) const { return (kernel_.provides >> static_cast<unsigned>(output) & 1U) != 0; }

  // All outputs that the kernel provides, at distances r with smoothing length l.
  Values evaluate(std::vector<double> r, double l) {
    const std::size_t n = r.size();
    r.resize((n + 7) / 8 * 8, 0.0);
    const std::vector<double> inverse_l(r.size(), 1 / l);
    Values values;
    std::array<double*, RIFFLE_KERNEL_OUTPUTS> out{};
    for (std::size_t b = 0; b < out.size(); ++b) {
      if (!gives(static_cast<int>(b))) continue;
      values[b].assign(r.size(), std::nan(""));
      out[b] = values[b].data();
    }
    riffle_error error = no_error();
    const auto status = call_plugin(error, [&] {
      return may_throw(instance_.table().evaluate_kernel)(instance_.self(), static_cast<std::int64_t>(r.size()),
                                                          r.data(), inverse_l.data(), kernel_.provides, out.data());
    });
    if (status != RIFFLE_OK) fail("fails to evaluate: " + message_of(error));
    for (auto& column : values) column.resize(std::min(n, column.size()));
    return values;
  }

  void check_claims() {
    if (!gives(w) || !gives(f) || kernel_.provides >> RIFFLE_KERNEL_OUTPUTS != 0) {
      fail(fmt::format("provides outputs {:#x}; W and F are needed, and there are {} in all", kernel_.provides,
                       RIFFLE_KERNEL_OUTPUTS));
    }
    if (!std::isfinite(kernel_.support) || kernel_.support <= 0 || kernel_.support > 100) {
      fail(fmt::format("its support of {} smoothing lengths is not in (0, 100]", kernel_.support));
    }
    if (!std::isfinite(kernel_.integral) || kernel_.integral <= 0) {
      fail(fmt::format("says that its integral over space is {}", kernel_.integral));
    }
  }

  // Lists with a skin hold pairs beyond the support, their padding some very far: all of them must count for nothing.
  void check_support() {
    std::vector<double> q;
    for (const double factor : {1.0, 1 + 1e-12, 1.001, 1.05, 1.1, 1.5, 2.0, 10.0, 1e3, 1e6}) {
      q.push_back(kernel_.support * factor);
    }
    std::vector<double> r = q;
    for (double& x : r) x *= length;
    const Values values = evaluate(r, length);
    for (int b = 0; b < RIFFLE_KERNEL_OUTPUTS; ++b) {
      const auto& column = values[static_cast<std::size_t>(b)];
      for (std::size_t k = 0; k < column.size(); ++k) {
        if (column[k] == 0) continue;
        fail(fmt::format("{} is {:.3g} at r = {:.6g} l; from its support of {} l on it must be exactly 0",
                         output_names[static_cast<std::size_t>(b)], column[k], q[k], kernel_.support));
        return;
      }
    }
  }

  // Only two lengths enter, so W must be l^-d w(r / l).
  void check_form() {
    constexpr double other = 1.3 * length;
    std::vector<double> r, r_other;
    for (int k = 0; k < 64; ++k) {
      r.push_back(kernel_.support * length * k / 64);
      r_other.push_back(r.back() * other / length);
    }
    const Values first = evaluate(r, length), second = evaluate(r_other, other);
    for (std::size_t k = 0; k < r.size(); ++k) {
      const double expected = first[w][k] * std::pow(length / other, dim_);
      if (std::abs(second[w][k] - expected) <= tolerance * std::abs(first[w][0])) continue;
      fail(fmt::format(
          "W is not of the form l^-d w(r / l): at r = {:.4g} l it is {:.6g} for l = {} and {:.6g} for l = {}",
          r[k] / length, first[w][k], length, second[w][k], other));
      return;
    }
  }

  // Each derivative is held against W and F alone, so that a mistake is found where it is. With W_r = r F, and
  // W = l^-d w(r/l), hence l W_l = -(d W + r W_r) and l^2 W_ll = d (d+1) W + 2 (d+1) r W_r + r^2 W_rr:
  //   [W] = int W_r,  [W_r] = int W_rr,  [W_l] = int W_rl,  [r^2 W_r] = int (l^2 W_ll - d (d+1) W - 2 d r W_r).
  void check_integrals() {
    const std::vector<double> r = knots();
    const Values at = evaluate(r, length);
    if (!finite(at)) return;
    if (at[w].front() <= 0) return fail(fmt::format("W(0) is {:.6g}, not positive", at[w].front()));
    if (at[f].front() > 0) return fail("F = (dW/dr)/r is positive at r = 0");
    if (std::abs(at[w].back()) > 1e-3 * at[w].front()) {
      return fail(fmt::format("W jumps to 0 at its support, from {:.2g} of W(0)", at[w].back() / at[w].front()));
    }
    const std::vector<Integrals> integrals = integrate(r);
    if (!problems_.empty()) return;

    double norm = 0;
    for (const Integrals& interval : integrals) norm += interval[over_space];
    if (std::abs(norm - kernel_.integral) > tolerance * kernel_.integral) {
      return fail(fmt::format("its integral over space is {:.12g}, but it says {:.12g}", norm, kernel_.integral));
    }
    std::vector<double> slope, w_over_l, curvature_moment;
    for (std::size_t k = 0; k < r.size(); ++k) {
      slope.push_back(r[k] * at[f][k]);
      w_over_l.push_back(-(dim_ * at[w][k] + r[k] * slope[k]) / length);
      curvature_moment.push_back(r[k] * r[k] * slope[k]);
    }
    check_increments(f, at[w], r, integrals);
    if (gives(w_l)) check_values(w_l, at[w_l], w_over_l, r);
    if (gives(w_rr)) check_increments(w_rr, slope, r, integrals);
    if (gives(w_rl)) check_increments(w_rl, w_over_l, r, integrals);
    if (gives(w_ll)) check_increments(w_ll, curvature_moment, r, integrals);
  }

  // From 0 to just inside the support, so that a kernel that is cut off instead of ending smoothly has its own value
  // there.
  [[nodiscard]] std::vector<double> knots() const {
    constexpr int intervals = 60;  // divisible by 2, 3, 4, 5, 6: pieces usually meet at a multiple of l or of kappa l
    std::vector<double> r;
    for (int k = 0; k <= intervals; ++k) r.push_back(length * kernel_.support * k / intervals);
    r.back() *= 1 - 1e-11;
    return r;
  }

  bool finite(const Values& values) {
    for (std::size_t b = 0; b < values.size(); ++b) {
      if (std::all_of(values[b].begin(), values[b].end(), [](double x) { return std::isfinite(x); })) continue;
      fail(fmt::format("{} is not finite everywhere in its support", output_names[b]));
      return false;
    }
    return true;
  }

  struct Interval {
    std::size_t base;  // the interval between knots that it is a part of
    double begin, end;
    Integrals whole;  // by one application of the quadrature
  };

  // Adaptive quadrature over each interval between knots: halved wherever the halves do not confirm the whole, because
  // pieces of a kernel may meet anywhere and quadrature across a kink is poor.
  std::vector<Integrals> integrate(const std::vector<double>& r) {
    std::vector<Integrals> sums(r.size() - 1, Integrals{});
    std::vector<Interval> open;
    for (std::size_t k = 0; k + 1 < r.size(); ++k) open.push_back({k, r[k], r[k + 1], {}});
    apply_quadrature(open);
    Integrals scale{};
    for (const Interval& interval : open) {
      for (std::size_t m = 0; m < scale.size(); ++m) scale[m] += std::abs(interval.whole[m]);
    }
    constexpr int deepest = 40;  // halvings; the parts are then as short as the spacing of doubles
    for (int depth = 0; !open.empty() && problems_.empty(); ++depth) {
      std::vector<Interval> halves;
      for (const Interval& interval : open) {
        const double middle = 0.5 * (interval.begin + interval.end);
        halves.push_back({interval.base, interval.begin, middle, {}});
        halves.push_back({interval.base, middle, interval.end, {}});
      }
      apply_quadrature(halves);
      std::vector<Interval> next;
      for (std::size_t k = 0; k < open.size(); ++k) {
        const Interval &left = halves[2 * k], &right = halves[2 * k + 1];
        bool confirmed = true;
        for (std::size_t m = 0; m < scale.size(); ++m) {
          confirmed = confirmed && std::abs(left.whole[m] + right.whole[m] - open[k].whole[m]) <= 1e-13 * scale[m];
        }
        if (confirmed || depth == deepest) {
          for (std::size_t m = 0; m < scale.size(); ++m) sums[open[k].base][m] += left.whole[m] + right.whole[m];
        } else {
          next.push_back(left);
          next.push_back(right);
        }
      }
      open = std::move(next);
    }
    return sums;
  }

  void apply_quadrature(std::vector<Interval>& intervals) {
    std::vector<double> r;
    for (const Interval& interval : intervals) {
      const double half = 0.5 * (interval.end - interval.begin), middle = 0.5 * (interval.end + interval.begin);
      for (const double x : gauss_x) r.push_back(middle + half * x);
    }
    const Values at = evaluate(r, length);
    if (!finite(at)) return;
    const double surface = dim_ == 1 ? 2 : (dim_ == 2 ? 2 : 4) * std::numbers::pi;  // of the unit ball
    for (std::size_t p = 0; p < r.size(); ++p) {
      if (at[f][p] > 0) return fail(fmt::format("F = (dW/dr)/r is positive at r = {:.4g} l", r[p] / length));
      Interval& interval = intervals[p / gauss_x.size()];
      const double weight = 0.5 * (interval.end - interval.begin) * gauss_w[p % gauss_x.size()];
      const double slope = r[p] * at[f][p];
      interval.whole[over_space] += weight * surface * std::pow(r[p], dim_ - 1) * at[w][p];
      interval.whole[f] += weight * slope;
      if (gives(w_rr)) interval.whole[w_rr] += weight * at[w_rr][p];
      if (gives(w_rl)) interval.whole[w_rl] += weight * at[w_rl][p];
      if (!gives(w_ll)) continue;
      const double rest = dim_ * ((dim_ + 1) * at[w][p] + 2 * r[p] * slope);
      interval.whole[w_ll] += weight * (length * length * at[w_ll][p] - rest);
    }
  }

  // `quantity` at each knot is its value at the support less the integral of `output` from there on.
  void check_increments(Output output, const std::vector<double>& quantity, const std::vector<double>& r,
                        const std::vector<Integrals>& integrals) {
    std::vector<double> expected = quantity;
    for (std::size_t k = quantity.size() - 1; k-- > 0;) expected[k] = expected[k + 1] - integrals[k][output];
    const double largest = largest_of(quantity);
    for (std::size_t k = quantity.size() - 1; k-- > 0;) {
      const double error = std::abs(expected[k] - quantity[k]);
      if (error <= tolerance * largest) continue;
      return fail(fmt::format("{} does not fit W: its integral from r = {:.4g} l on is off by {:.2g} of the largest",
                              output_names[output], r[k] / length, error / largest));
    }
  }

  void check_values(Output output, const std::vector<double>& values, const std::vector<double>& expected,
                    const std::vector<double>& r) {
    const double largest = largest_of(expected);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (std::abs(values[k] - expected[k]) <= tolerance * largest) continue;
      return fail(fmt::format("{} does not fit W: at r = {:.4g} l it is {:.6g} instead of {:.6g}", output_names[output],
                              r[k] / length, values[k], expected[k]));
    }
  }

  static double largest_of(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
  }

  const PluginInstance& instance_;
  int dim_;
  riffle_kernel kernel_{};
  std::vector<std::string> problems_;
};

}  // namespace

std::vector<std::string> kernel_problems(const PluginInstance& instance) {
  return KernelCheck(instance).run();
}

}  // namespace riffle
