// Measuring what a term contributes: two runs that differ in it, as child processes, so that their figures are those that
// anybody gets with the same --set.
#pragma once

#include <array>

#include "host/study/advise/advice.hpp"
#include "host/study/advise/scout.hpp"

namespace riffle {

// Runs the trials of all terms, each run once however many terms need it, and fills them in. `region`: extent of x in which
// depths are compared. Runs that would take longer than request.budget, going by the scout, are cut in time, and a note says so.
void verify_terms(const AdviceRequest& request, const std::array<double, 2>& region, const Scout& scout,
                  Advice& advice);

}  // namespace riffle
