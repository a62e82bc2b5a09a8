// The water along an axis as a running sum from the left, and its inverse: where a given share of it lies to the left.
#pragma once

#include <vector>

#include "host/particles/water.hpp"

namespace riffle {

class RunningVolume {
 public:
  // The stretches come from stretches_of, at least one, in order.
  RunningVolume(const Water& water, const std::vector<Stretch>& stretches);

  [[nodiscard]] double total() const { return sum_.back(); }
  // The x with `volume` on its left, 0 <= volume <= total.
  [[nodiscard]] double position(double volume) const;

 private:
  struct Interval {
    double begin, end;
  };
  [[nodiscard]] double integral(double begin, double end) const;

  const Water& water_;
  std::vector<Interval> intervals_;
  std::vector<double> sum_;  // up to the end of each interval
};

}  // namespace riffle
