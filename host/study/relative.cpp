#include "host/study/relative.hpp"

#include <algorithm>
#include <cmath>

namespace riffle {
namespace {

bool has(const PointResult& point, std::size_t error) {
  return point.counts() && std::isfinite(point.errors[error]) && std::isfinite(point.cost);
}

std::optional<double> ratio(const std::optional<double>& value, double to) {
  if (!value || !(to > 0)) return std::nullopt;
  return *value / to;
}

}  // namespace

std::vector<ErrorCost> error_cost_of(const ResultLine& line, std::size_t error) {
  std::vector<ErrorCost> pairs;
  for (const PointResult* point : line.points) {
    if (has(*point, error)) pairs.push_back({point->errors[error], point->cost});
  }
  return pairs;
}

double order_of(const ResultLine& line, std::size_t error) {
  std::vector<double> spacings, errors;
  for (const PointResult* point : line.points) {
    if (!has(*point, error)) continue;
    spacings.push_back(point->spacing);
    errors.push_back(point->errors[error]);
  }
  return convergence_order(spacings, errors);
}

std::vector<Relative> relative_to(const ResultLine& baseline, const ResultLine& line, std::size_t error) {
  std::vector<Relative> all;
  const std::vector<ErrorCost> pairs = error_cost_of(line, error);
  for (const PointResult* point : baseline.points) {
    if (!has(*point, error)) continue;
    all.push_back({point, ratio(cost_at_error(pairs, point->errors[error]), point->cost),
                   ratio(error_at_cost(pairs, point->cost), point->errors[error])});
  }
  return all;
}

std::vector<const PointResult*> front_of(const StudyResults& results, const std::string& case_name, std::size_t error) {
  std::vector<const PointResult*> points, front;
  std::vector<ErrorCost> pairs;
  for (const PointResult& point : results.points) {
    if (point.point.case_name != case_name || !has(point, error)) continue;
    points.push_back(&point);
    pairs.push_back({point.errors[error], point.cost});
  }
  for (const std::size_t k : pareto_front(pairs)) front.push_back(points[k]);
  return front;
}

std::vector<std::string> cases_of(const StudyResults& results) {
  std::vector<std::string> names;
  for (const PointResult& point : results.points) {
    if (std::find(names.begin(), names.end(), point.point.case_name) == names.end())
      names.push_back(point.point.case_name);
  }
  return names;
}

}  // namespace riffle
