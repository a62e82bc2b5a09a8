// A scalar function of position and time, as a manifest may give it: a constant, piecewise values, a formula in x, y, z
// and t, or a table in CSV.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace riffle {

// Cheap to copy; evaluation is thread-safe and has no side effect.
class Function {
 public:
  class Implementation {
   public:
    virtual ~Implementation() = default;
    virtual void evaluate(std::int64_t n, const double* x, const double* y, const double* z, double t,
                          double* out) const = 0;
  };

  Function() = default;
  Function(std::shared_ptr<const Implementation> implementation, std::string text)
      : implementation_(std::move(implementation)), text_(std::move(text)) {}

  // out[k] = f(x[k], y[k], z[k], t) for k < n; y and z may be null (taken as 0)
  void evaluate(std::int64_t n, const double* x, const double* y, const double* z, double t, double* out) const {
    implementation_->evaluate(n, x, y, z, t, out);
  }
  [[nodiscard]] double operator()(double x, double y = 0, double z = 0, double t = 0) const {
    double out = 0;
    evaluate(1, &x, &y, &z, t, &out);
    return out;
  }
  [[nodiscard]] bool valid() const { return implementation_ != nullptr; }
  [[nodiscard]] const std::string& text() const { return text_; }  // as the manifest has it

 private:
  std::shared_ptr<const Implementation> implementation_;
  std::string text_;
};

}  // namespace riffle
