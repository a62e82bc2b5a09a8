// What the plugin boundary costs: the same physics by the usual way, by the best monolith, and by plugins.
#pragma once

#include <functional>
#include <optional>

#include "host/bench/state.hpp"

namespace riffle::bench {

// Nanoseconds of CPU time per true pair: pairs within the support count, padding and skin do not.
struct BoundaryTimes {
  double fused_cells = 0, fused_best = 0;
  std::optional<double> plugins;

  [[nodiscard]] double price() const { return *plugins / fused_best; }  // of the boundary; needs `plugins`
  [[nodiscard]] double gain() const { return fused_cells / *plugins; }  // over the usual way; needs `plugins`
};

// `plugins`: one evaluation of the same rates of the same state through loaded plugins, on the calling thread; may be
// empty.
BoundaryTimes time_boundary(const BenchState& state, const std::function<void()>& plugins, int repeats);

}  // namespace riffle::bench
