// A sum of many doubles that is right to the last digit or two, whatever their signs and sizes.
//
// Neumaier, A. (1974), Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen, ZAMM 54, 39-51: the
// rounding error of every addition is exact in floating point, and is carried along. Error about 2^-53 of the result
// plus n 2^-106 of the sum of sizes. Same order, same bits. Not finite as soon as one term is not.
#pragma once

#include <cmath>

namespace riffle {

class CompensatedSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return std::isfinite(sum_) ? sum_ + lost_ : sum_; }

 private:
  double sum_ = 0, lost_ = 0;
};

}  // namespace riffle
