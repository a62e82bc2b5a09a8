// Which particles may be left out: those that have converged, and those around which nothing has changed.
#include <algorithm>

#include "host/schedule/evaluator.hpp"

namespace riffle {

bool Evaluator::converges_alone(const Plan& plan, std::size_t first, std::size_t last) const {
  std::vector<int> read, written;
  for (std::size_t s = first; s < last; ++s) {
    if (plan.sweeps[s].global >= 0) return false;
    for (const int n : plan.sweeps[s].nodes) {
      for (const int f : graph_.particle_reads(n, true)) read.push_back(f);
      for (const auto& w : graph_.nodes()[static_cast<std::size_t>(n)].writes) written.push_back(w.field);
    }
  }
  return std::none_of(written.begin(), written.end(),
                      [&](int f) { return std::find(read.begin(), read.end(), f) != read.end(); });
}

// Particles can be left out where each converges alone, and where nobody adds to a sum that another sweep began.
bool Evaluator::may_rest(const Plan& plan) const {
  std::map<int, std::size_t> sweep_of;  // sums
  for (std::size_t s = 0; s < plan.sweeps.size(); ++s) {
    if (plan.sweeps[s].global >= 0) continue;
    std::size_t end = s;
    while (end < plan.sweeps.size() && plan.sweeps[end].iteration == plan.sweeps[s].iteration) ++end;
    if (plan.sweeps[s].iteration >= 0 && !converges_alone(plan, s, end)) return false;
    for (const int n : plan.sweeps[s].nodes) {
      for (const auto& w : graph_.nodes()[static_cast<std::size_t>(n)].writes) {
        const bool sum = graph_.fields()[static_cast<std::size_t>(w.field)].description.accumulates;
        if (sum && sweep_of.emplace(w.field, s).first->second != s) return false;
      }
    }
  }
  return true;
}

// Pairs that are kept for a global pass name images by their number.
bool Evaluator::same_images_as_last_time(const Sweep& sweep) {
  const std::vector<Image>& now = neighbourhood_.images();
  std::vector<Image>& before = images_of_sweep_[&sweep];
  const bool same =
      std::equal(now.begin(), now.end(), before.begin(), before.end(), [](const Image& a, const Image& b) {
        return a.origin == b.origin && a.mirror == b.mirror && a.axis == b.axis && a.a == b.a;
      });
  if (!same) before = now;
  return same;
}

}  // namespace riffle
