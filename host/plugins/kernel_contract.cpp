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

  void check_integrals() {
    // A kernel may be put together of pieces that meet anywhere. Where they meet within an interval, quadrature is only
    // accurate in the limit of small intervals, so a mistake counts when finer intervals find it too.
    std::vector<std::string> mistakes;
    for (const int intervals : {60, 600, 6000}) {
      mistakes = integral_mistakes(intervals);
      if (mistakes.empty() || !problems_.empty()) return;
    }
    for (const std::string& mistake : mistakes) fail(mistake);
  }

  std::vector<double> knots(int intervals) const {
    std::vector<double> q;
    for (int k = 0; k < intervals; ++k) q.push_back(kernel_.support * k / intervals);
    for (int k = 1; 0.25 * k < kernel_.support; ++k) q.push_back(0.25 * k);
    // The last one lies just inside, so that a kernel that is cut off instead of ending smoothly has its own value there.
    q.push_back(kernel_.support * (1 - 1e-11));
    std::sort(q.begin(), q.end());
    q.erase(std::unique(q.begin(), q.end(), [](double a, double b) { return b - a < 1e-9; }), q.end());
    q.back() = kernel_.support * (1 - 1e-11);
    return q;
  }

  std::vector<std::string> integral_mistakes(int intervals) {
    const std::vector<double> q = knots(intervals);
    std::vector<double> ends, points, weights;
    for (const double x : q) ends.push_back(x * length);
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double half = 0.5 * (ends[k + 1] - ends[k]), middle = 0.5 * (ends[k + 1] + ends[k]);
      for (std::size_t g = 0; g < gauss_x.size(); ++g) {
        points.push_back(middle + half * gauss_x[g]);
        weights.push_back(half * gauss_w[g]);
      }
    }
    const Values at_ends = evaluate(ends, length), inside = evaluate(points, length);
    std::vector<std::string> mistakes;
    check_values(at_ends, inside, points, mistakes);
    if (mistakes.empty()) check_norm(inside[w], points, weights, mistakes);
    if (mistakes.empty()) check_derivatives(at_ends, inside, ends, points, weights, mistakes);
    return mistakes;
  }

  void check_values(const Values& at_ends, const Values& inside, const std::vector<double>& points,
                    std::vector<std::string>& mistakes) {
    for (std::size_t b = 0; b < inside.size(); ++b) {
      const auto finite = [](double x) { return std::isfinite(x); };
      if (!std::all_of(inside[b].begin(), inside[b].end(), finite) ||
          !std::all_of(at_ends[b].begin(), at_ends[b].end(), finite)) {
        mistakes.push_back(fmt::format("{} is not finite everywhere in its support", output_names[b]));
        return;
      }
    }
    const auto worst = std::max_element(inside[f].begin(), inside[f].end());
    if (*worst > 0) {
      mistakes.push_back(fmt::format("F = (dW/dr)/r is positive at r = {:.4g} l",
                                     points[static_cast<std::size_t>(worst - inside[f].begin())] / length));
    } else if (at_ends[f].front() > 0) {
      mistakes.push_back("F = (dW/dr)/r is positive at r = 0");
    }
    if (at_ends[w].front() <= 0) mistakes.push_back(fmt::format("W(0) is {}, not positive", at_ends[w].front()));
    if (std::abs(at_ends[w].back()) > 1e-3 * at_ends[w].front()) {
      mistakes.push_back(
          fmt::format("W jumps to 0 at its support, from {:.2g} of W(0)", at_ends[w].back() / at_ends[w].front()));
    }
  }

  void check_norm(const std::vector<double>& values, const std::vector<double>& points,
                  const std::vector<double>& weights, std::vector<std::string>& mistakes) {
    const double surface = dim_ == 1 ? 2 : (dim_ == 2 ? 2 : 4) * std::numbers::pi;  // of the unit ball
    double integral = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      integral += weights[k] * surface * std::pow(points[k], dim_ - 1) * values[k];
    }
    if (std::abs(integral - kernel_.integral) > tolerance * kernel_.integral) {
      mistakes.push_back(
          fmt::format("its integral over space is {:.12g}, but it says {:.12g}", integral, kernel_.integral));
    }
  }

  // Each derivative against W and F alone, so that a mistake is found where it is. With W_r = r F, and W = l^-d w(r/l)
  // so that l W_l = -(d W + r W_r) and l^2 W_ll = d (d+1) W + 2 (d+1) r W_r + r^2 W_rr:
  //   [W] = int W_r,  [W_r] = int W_rr,  [W_l] = int W_rl,  int l^2 W_ll = int (d (d+1) W + 2 d r W_r) + [r^2 W_r].
  void check_derivatives(const Values& at_ends, const Values& inside, const std::vector<double>& ends,
                         const std::vector<double>& points, const std::vector<double>& weights,
                         std::vector<std::string>& mistakes) {
    const std::size_t n = points.size();
    std::vector<double> slope(n), ll(n), end_slope, end_l, end_ll;
    for (std::size_t k = 0; k < n; ++k) {
      slope[k] = points[k] * inside[f][k];
      if (gives(w_ll)) {
        ll[k] = length * length * inside[w_ll][k] - dim_ * ((dim_ + 1) * inside[w][k] + 2 * points[k] * slope[k]);
      }
    }
    for (std::size_t k = 0; k < ends.size(); ++k) {
      end_slope.push_back(ends[k] * at_ends[f][k]);
      end_l.push_back(-(dim_ * at_ends[w][k] + ends[k] * end_slope[k]) / length);
      end_ll.push_back(ends[k] * ends[k] * end_slope[k]);
    }
    check_increments(f, at_ends[w], slope, ends, weights, mistakes);
    if (gives(w_l)) check_scaling(at_ends[w_l], end_l, ends, mistakes);
    if (gives(w_rr)) check_increments(w_rr, end_slope, inside[w_rr], ends, weights, mistakes);
    if (gives(w_rl)) check_increments(w_rl, end_l, inside[w_rl], ends, weights, mistakes);
    if (gives(w_ll)) check_increments(w_ll, end_ll, ll, ends, weights, mistakes);
  }

  // The integral of `rate` over each interval is the increment of `quantity`.
  void check_increments(Output output, const std::vector<double>& quantity, const std::vector<double>& rate,
                        const std::vector<double>& ends, const std::vector<double>& weights,
                        std::vector<std::string>& mistakes) {
    double largest = 0;
    for (const double value : quantity) largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      double integral = 0;
      for (std::size_t g = 0; g < gauss_x.size(); ++g) {
        const std::size_t p = gauss_x.size() * k + g;
        integral += weights[p] * rate[p];
      }
      const double error = std::abs(integral - (quantity[k + 1] - quantity[k]));
      if (error <= tolerance * largest) continue;
      mistakes.push_back(
          fmt::format("{} does not fit W: between r = {:.4g} l and {:.4g} l its integral is off by {:.2g} "
                      "of the largest value",
                      output_names[output], ends[k] / length, ends[k + 1] / length, error / largest));
      return;
    }
  }

  void check_scaling(const std::vector<double>& values, const std::vector<double>& expected,
                     const std::vector<double>& ends, std::vector<std::string>& mistakes) {
    double largest = 0;
    for (const double value : expected) largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (std::abs(values[k] - expected[k]) <= tolerance * largest) continue;
      mistakes.push_back(fmt::format("dW/dl does not fit W: at r = {:.4g} l it is {:.6g} instead of {:.6g}",
                                     ends[k] / length, values[k], expected[k]));
      return;
    }
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
