// A scout: the scene on few particles by the cheapest model there is, in this process. What the scene will be like, from
// milliseconds of computing instead of from guesses.
#pragma once

#include <string>
#include <vector>

#include "host/plugins/registry.hpp"
#include "host/study/advise/advice.hpp"
#include "host/study/advise/flow.hpp"

namespace riffle {

struct Scout {
  FlowLine line;
  std::vector<FlowState> states;  // at t = 0, then at equal times up to the end
  double end = 0;                 // that it was meant to reach
  double cpu_seconds = 0;         // of the steps
  int particles = 0;
  std::string problem;  // why it did not get there, or ""
  [[nodiscard]] bool good() const { return problem.empty() && states.size() > 1; }
  [[nodiscard]] const FlowState& last() const { return states.back(); }
};

inline constexpr int scout_states = 20;

// Runs the case with further overrides; `cells` points are kept of each state. It stops after `seconds` of CPU time.
// What the manifest or the plugins refuse is the problem of the result.
Scout scout(const AdviceRequest& request, const Overrides& further, int cells, const Registry& registry,
            double seconds);

// What every run of this command adds: nothing but the end is written.
Overrides quiet_output();

// CPU seconds that a case will take, from a few of its steps; NaN when it cannot be tried.
double estimated_cost(const AdviceRequest& request, const Overrides& further, const Registry& registry);

}  // namespace riffle
