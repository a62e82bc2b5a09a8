// Figures from errors and costs: orders of convergence, the Pareto front, cost at equal error, error at equal cost. All on
// logarithms, since both run over decades.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace riffle {

struct ErrorCost {
  double error = 0, cost = 0;  // above 0
};

// Slope of log(error) over log(spacing) by least squares; NaN with fewer than two usable pairs of different spacing.
double convergence_order(std::span<const double> spacing, std::span<const double> error);

// Turns of those points that no other beats in one without being worse in the other; from the cheapest on. Points with a
// value that is not finite never are among them.
std::vector<std::size_t> pareto_front(std::span<const ErrorCost> points);

// The least cost at which the line, given from the coarsest to the finest, has this error; straight between its points
// on logarithms. Nothing outside: no extrapolation.
std::optional<double> cost_at_error(std::span<const ErrorCost> line, double error);
std::optional<double> error_at_cost(std::span<const ErrorCost> line, double cost);

}  // namespace riffle
