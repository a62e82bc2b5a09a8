#include "host/bench/timing.hpp"

#include <time.h>

#include <algorithm>
#include <cassert>

namespace riffle::bench {

double thread_cpu_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<double> time_interleaved(const std::vector<std::function<void()>>& callables, int repeats) {
  assert(repeats > 0);
  for (const auto& callable : callables) callable();
  std::vector<std::vector<double>> times(callables.size());
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t k = 0; k < callables.size(); ++k) {
      const double start = thread_cpu_time();
      callables[k]();
      times[k].push_back(thread_cpu_time() - start);
    }
  }
  std::vector<double> medians;
  for (auto& series : times) {
    const auto middle = series.begin() + static_cast<std::ptrdiff_t>(series.size() / 2);
    std::nth_element(series.begin(), middle, series.end());
    medians.push_back(*middle);
  }
  return medians;
}

}  // namespace riffle::bench
