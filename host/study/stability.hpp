// Maps of stability: a case over two parameters, its points run where the boundary between classes is looked for.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host/study/boundary.hpp"
#include "host/study/plan.hpp"
#include "host/study/study_folder.hpp"

namespace riffle {

// From good to bad.
enum class StabilityClass { good, inaccurate, suspect, too_slow, blew_up, refused };
inline constexpr std::size_t stability_classes = 6;
std::string in_words(StabilityClass of);  // "good", "inaccurate", "suspect", "too slow", "blew up", "refused"

// The worst that holds. A run without the number `error` is inaccurate; with `error` empty no run is.
StabilityClass class_of(const Outcome& outcome, const std::string& error, double error_bound);

// What is known of a point that was tried.
struct TriedPoint {
  StabilityClass of = StabilityClass::good;
  double error = 0;     // NaN where there is none
  std::string message;  // why it is not good
  std::string folder;   // of its run, or empty
};

// The map of one case and one closure.
struct StabilityResult {
  std::string case_name, case_title, closure;
  TracedMap map;                   // classes as numbers
  std::vector<TriedPoint> points;  // of those that were tried, row by row as in the map
  [[nodiscard]] StabilityClass at(int x, int y) const { return static_cast<StabilityClass>(map.at(x, y)); }
};

// Does those of the runs that have not ended.
using RunPoints = std::function<void(const std::vector<StudyPoint>&)>;

// Throws ManifestError for what is wrong with the study: a key that no corner of the map knows, an error that no case has,
// more runs than it says without `many`. Returns the number of run.json to judge by, or "".
std::string check_map(const Study& study, const TryCombination& attempt, bool many);

// One map per case and closure of the study.
std::vector<StabilityResult> map_stability(const Study& study, const TryCombination& attempt, const StudyFolder& folder,
                                           const std::string& error, const RunPoints& run);

}  // namespace riffle
