#include "host/bench/boundary.hpp"

#include "host/bench/fused_best.hpp"
#include "host/bench/fused_cells.hpp"
#include "host/bench/timing.hpp"

namespace riffle::bench {

BoundaryTimes time_boundary(const BenchState& state, const std::function<void()>& plugins, int repeats) {
  FusedCells cells(state);
  FusedBest best(state);
  BenchRates rates(state.particles);
  std::vector<std::function<void()>> sides{[&] { cells(rates); }, [&] { best(rates); }};
  if (plugins) sides.push_back(plugins);
  const std::vector<double> seconds = time_interleaved(sides, repeats);
  const auto per_pair = [&](double time) { return 1e9 * time / static_cast<double>(state.true_pairs); };
  BoundaryTimes times{per_pair(seconds[0]), per_pair(seconds[1]), {}};
  if (plugins) times.plugins = per_pair(seconds[2]);
  return times;
}

}  // namespace riffle::bench
