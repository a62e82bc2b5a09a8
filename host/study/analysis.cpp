#include "host/study/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace riffle {
namespace {

bool usable(double value) {
  return std::isfinite(value) && value > 0;
}

// y at x on the line through two points, on logarithms.
double between(double x, double x0, double y0, double x1, double y1) {
  if (x0 == x1) return std::min(y0, y1);
  const double share = (std::log(x) - std::log(x0)) / (std::log(x1) - std::log(x0));
  return std::exp(std::log(y0) + share * (std::log(y1) - std::log(y0)));
}

// The smallest y at which the polyline (x, y) has this x.
std::optional<double> least_at(std::span<const ErrorCost> line, double wanted, double ErrorCost::*x,
                               double ErrorCost::*y) {
  std::optional<double> least;
  const auto take = [&](double value) { least = least ? std::min(*least, value) : value; };
  const ErrorCost* before = nullptr;
  for (const ErrorCost& point : line) {
    if (!usable(point.error) || !usable(point.cost)) continue;
    if (point.*x == wanted) take(point.*y);
    if (before != nullptr && std::min(before->*x, point.*x) < wanted && wanted < std::max(before->*x, point.*x)) {
      take(between(wanted, before->*x, before->*y, point.*x, point.*y));
    }
    before = &point;
  }
  return least;
}

}  // namespace

double convergence_order(std::span<const double> spacing, std::span<const double> error) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < std::min(spacing.size(), error.size()); ++k) {
    if (!usable(spacing[k]) || !usable(error[k])) continue;
    const double x = std::log(spacing[k]), y = std::log(error[k]);
    n += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  const double spread = n * sxx - sx * sx;
  if (n < 2 || !(spread > 1e-12 * n * sxx)) return std::numeric_limits<double>::quiet_NaN();
  return (n * sxy - sx * sy) / spread;
}

std::vector<std::size_t> pareto_front(std::span<const ErrorCost> points) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (std::isfinite(points[k].error) && std::isfinite(points[k].cost)) order.push_back(k);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (points[a].cost != points[b].cost) return points[a].cost < points[b].cost;
    return points[a].error != points[b].error ? points[a].error < points[b].error : a < b;
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t k : order) {
    if (!(points[k].error < least)) continue;
    least = points[k].error;
    front.push_back(k);
  }
  return front;
}

std::optional<double> cost_at_error(std::span<const ErrorCost> line, double error) {
  return least_at(line, error, &ErrorCost::error, &ErrorCost::cost);
}

std::optional<double> error_at_cost(std::span<const ErrorCost> line, double cost) {
  return least_at(line, cost, &ErrorCost::cost, &ErrorCost::error);
}

}  // namespace riffle
