#include "host/manifest/function_kinds.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace riffle {
namespace {

double coordinate(std::size_t axis, std::int64_t k, const double* x, const double* y, const double* z, double t) {
  const std::array<const double*, 3> all{x, y, z};
  if (axis == 3) return t;
  return all[axis] != nullptr ? all[axis][k] : 0.0;
}

class ConstantFunction final : public Function::Implementation {
 public:
  explicit ConstantFunction(double value) : value_(value) {}
  void evaluate(std::int64_t n, const double*, const double*, const double*, double, double* out) const override {
    std::fill(out, out + n, value_);
  }

 private:
  double value_;
};

class PiecewiseFunction final : public Function::Implementation {
 public:
  PiecewiseFunction(std::size_t axis, std::vector<double> breaks, std::vector<Function> values)
      : axis_(axis), breaks_(std::move(breaks)), values_(std::move(values)) {}
  void evaluate(std::int64_t n, const double* x, const double* y, const double* z, double t,
                double* out) const override {
    for (std::int64_t k = 0; k < n; ++k) {
      const double at = coordinate(axis_, k, x, y, z, t);
      const auto piece = std::upper_bound(breaks_.begin(), breaks_.end(), at) - breaks_.begin();
      values_[static_cast<std::size_t>(piece)].evaluate(1, x != nullptr ? x + k : nullptr,
                                                        y != nullptr ? y + k : nullptr, z != nullptr ? z + k : nullptr,
                                                        t, out + k);
    }
  }

 private:
  std::size_t axis_;
  std::vector<double> breaks_;
  std::vector<Function> values_;
};

class TableFunction final : public Function::Implementation {
 public:
  TableFunction(std::size_t axis, std::vector<double> at, std::vector<double> values, bool undefined_outside)
      : axis_(axis), at_(std::move(at)), values_(std::move(values)), undefined_outside_(undefined_outside) {}
  void evaluate(std::int64_t n, const double* x, const double* y, const double* z, double t,
                double* out) const override {
    for (std::int64_t k = 0; k < n; ++k) out[k] = value(coordinate(axis_, k, x, y, z, t));
  }

 private:
  [[nodiscard]] double value(double at) const {
    const bool inside = at >= at_.front() && at <= at_.back();
    if (!inside && (undefined_outside_ || at != at)) return std::numeric_limits<double>::quiet_NaN();
    if (at <= at_.front()) return values_.front();
    if (at >= at_.back()) return values_.back();
    const auto k = static_cast<std::size_t>(std::upper_bound(at_.begin(), at_.end(), at) - at_.begin());
    const double share = (at - at_[k - 1]) / (at_[k] - at_[k - 1]);
    return values_[k - 1] + share * (values_[k] - values_[k - 1]);
  }

  std::size_t axis_;
  std::vector<double> at_, values_;
  bool undefined_outside_;
};

}  // namespace

FunctionPointer constant_values(double value) {
  return std::make_shared<ConstantFunction>(value);
}

FunctionPointer piecewise_values(std::size_t axis, std::vector<double> breaks, std::vector<Function> values) {
  return std::make_shared<PiecewiseFunction>(axis, std::move(breaks), std::move(values));
}

FunctionPointer table_values(std::size_t axis, std::vector<double> at, std::vector<double> values,
                             bool undefined_outside) {
  return std::make_shared<TableFunction>(axis, std::move(at), std::move(values), undefined_outside);
}

}  // namespace riffle
