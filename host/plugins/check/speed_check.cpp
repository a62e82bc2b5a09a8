#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "host/plugins/call.hpp"
#include "host/plugins/check/checks.hpp"
#include "host/plugins/check/closure.hpp"

namespace riffle::check {
namespace {

constexpr std::int64_t pairs = 64;
// A closure of some tens of operations takes 0.2 to 0.7 ns per pair in a vector loop; without the pragma that
// RIFFLE_EACH is, or with a call of libm in the loop, 2.4 and more. A busy machine doubles both.
constexpr double slow = 1.5;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The best of many short measurements: whatever disturbs one makes it longer.
double nanoseconds_per_pair(const Closure& closure, const SyntheticBlock& block) {
  riffle_error error = no_error();
  constexpr int calls = 300;
  double best = 1e300;
  for (int measurement = 0; measurement < 60; ++measurement) {
    const double start = cpu_seconds();
    for (int k = 0; k < calls; ++k) closure.pass.run(closure.self, &block.block(), &error);
    best = std::min(best, cpu_seconds() - start);
  }
  return 1e9 * best / (calls * static_cast<double>(pairs));
}

}  // namespace

Findings check_speed(const Plugin& plugin) {
  Findings findings;
  for (const int dim : plugin.description.dimensions) {
    const PluginInstance instance(plugin, dim, default_values(plugin.description));
    for (const Closure& closure : closures_of(instance, RIFFLE_W | RIFFLE_F)) {
      if (!closure.pairs()) continue;
      const SyntheticBlock block(scene_for(closure, dim), closure.pass, first_items(pairs));
      run(closure, block);
      const double time = nanoseconds_per_pair(closure, block);
      if (time > slow) {
        findings.warn(
            fmt::format("{} takes {:.1f} ns per pair in {}D, where 0.2 to 0.7 is usual; unless the formula is a "
                        "long one, its loop is no vector loop: no RIFFLE_EACH, a call of libm, a branch, or a "
                        "build without optimisation",
                        closure.name, time, dim));
      }
      findings.summary +=
          fmt::format("{}{} {:.2f} ns in {}D", findings.summary.empty() ? "per pair: " : ", ", closure.name, time, dim);
    }
  }
  if (findings.summary.empty()) findings.summary = nothing;
  return findings;
}

}  // namespace riffle::check
