// Measuring what a term contributes: two runs that differ in it, as child processes, so that their figures are those that
// anybody gets with the same --set.
#pragma once

#include <array>
#include <functional>

#include "host/study/advise/advice.hpp"

namespace riffle {

struct VerifiedScene {
  double low = 0, high = 0;        // of x
  std::array<double, 2> region{};  // of x in which is compared
  double spacing = 0;  // m; 0: the scene has a depth, else its surface is compared, from particles so far apart
  double end = 0;      // s
  std::function<double(const Overrides&)> cost;  // CPU seconds that a run will take, or NaN
};

// Runs the trials of all terms, each run once however many terms need it, and fills them in. Runs that would take longer than
// request.budget are cut in time, and a note says so.
void verify_terms(const AdviceRequest& request, const VerifiedScene& scene, Advice& advice);

}  // namespace riffle
