#include "host/particles/water.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "host/particles/placement.hpp"

namespace riffle {
namespace {

void require_finite(const char* name, const double* values, std::int64_t n, const double* x, const double* y,
                    const double* z) {
  const double* const bad = std::find_if_not(values, values + n, [](double v) { return std::isfinite(v); });
  if (bad == values + n) return;
  const auto k = bad - values;
  std::ostringstream text;
  text << "initial." << name << " must be finite at t = 0, got " << *bad << " at x = " << x[k];
  if (y != nullptr) text << ", y = " << y[k];
  if (z != nullptr) text << ", z = " << z[k];
  throw PlacementError(text.str());
}

// The first double of (a, b] that is no longer like a, given that b is not.
template <class LikeA>
double first_unlike(double a, double b, const LikeA& like_a) {
  while (true) {
    const double middle = a + (b - a) / 2;
    if (!(middle > a && middle < b)) return b;
    (like_a(middle) ? a : b) = middle;
  }
}

// Where the depth jumps between a and b; NaN when it is continuous there as far as one can tell. A continuous function
// loses its difference as the interval shrinks (a square root: by 1/8 in six halvings), a jump does not.
double jump_between(const Water& water, double a, double b, double at_a, double at_b) {
  const double difference = std::abs(at_b - at_a);
  for (int halving = 0;; ++halving) {
    const double middle = a + (b - a) / 2;
    if (!(middle > a && middle < b)) return b;
    const double at_middle = water.depth(middle);
    if (std::abs(at_middle - at_a) > std::abs(at_b - at_middle)) {
      b = middle;
      at_b = at_middle;
    } else {
      a = middle;
      at_a = at_middle;
    }
    if (halving >= 5 && std::abs(at_b - at_a) < 0.5 * difference) return std::nan("");
  }
}

}  // namespace

Water::Water(const Case& scene) {
  const auto found = scene.initial.find("depth");
  if (found != scene.initial.end() && !found->second.empty()) depth_ = &found->second.front();
  if (scene.placement.inside.valid()) inside_ = &scene.placement.inside;
}

void Water::depth(std::int64_t n, const double* x, const double* y, const double* z, double* out) const {
  std::fill(out, out + n, 1.0);
  if (depth_ != nullptr) {
    depth_->evaluate(n, x, y, z, 0, out);
    require_finite("depth", out, n, x, y, z);
    for (std::int64_t k = 0; k < n; ++k) out[k] = std::max(out[k], 0.0);
  }
  if (inside_ == nullptr) return;
  std::vector<double> inside(static_cast<std::size_t>(n));
  inside_->evaluate(n, x, y, z, 0, inside.data());
  require_finite("inside", inside.data(), n, x, y, z);
  for (std::int64_t k = 0; k < n; ++k) {
    if (!(inside[static_cast<std::size_t>(k)] > 0)) out[k] = 0;
  }
}

double Water::depth(double x, double y, double z) const {
  double out = 0;
  depth(1, &x, &y, &z, &out);
  return out;
}

std::string Water::why_dry() const {
  if (depth_ != nullptr && inside_ != nullptr) return "initial.depth and initial.inside are nowhere both above 0";
  if (depth_ != nullptr) return "initial.depth is nowhere above 0 in the domain";
  return "initial.inside is nowhere above 0 in the domain";
}

std::vector<Stretch> stretches_of(const Water& water, double low, double high, std::int64_t samples) {
  std::vector<double> x{low};
  for (std::int64_t k = 0; k < samples; ++k) {
    x.push_back(low + (high - low) * ((static_cast<double>(k) + 0.5) / static_cast<double>(samples)));
  }
  x.push_back(std::nextafter(high, low));  // what holds from `high` on is no longer in the domain
  std::vector<double> depth(x.size());
  water.depth(static_cast<std::int64_t>(x.size()), x.data(), nullptr, nullptr, depth.data());
  // Below this, a difference is round-off of the function's own arithmetic.
  const double negligible = 1e-9 * *std::max_element(depth.begin(), depth.end());

  std::vector<Stretch> stretches;
  bool open = depth[0] > 0;
  if (open) stretches.push_back({low, high, {}});
  for (std::size_t k = 1; k < x.size(); ++k) {
    const double a = x[k - 1], b = x[k];
    const bool wet = depth[k] > 0;
    if (wet != open) {
      const double edge = first_unlike(a, b, [&](double at) { return (water.depth(at) > 0) == open; });
      if (wet) {
        stretches.push_back({edge, high, {}});
      } else {
        stretches.back().end = edge;
      }
      open = wet;
    } else if (wet && std::abs(depth[k] - depth[k - 1]) > negligible) {
      const double jump = jump_between(water, a, b, depth[k - 1], depth[k]);
      if (!std::isnan(jump)) {
        stretches.back().end = jump;
        stretches.push_back({jump, high, {}});
      }
    }
    if (open && k + 1 < x.size() && b > stretches.back().begin) stretches.back().inner.push_back(b);
  }
  return stretches;
}

}  // namespace riffle
