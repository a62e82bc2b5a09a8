// Maps of stability: a case over two parameters, each point run or filled in from its neighbours, classed, and drawn.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/study/boundary.hpp"
#include "host/study/plan.hpp"
#include "host/study/study_folder.hpp"

namespace riffle {

enum class StabilityClass { good, inaccurate, suspect, too_slow, blew_up, refused };
inline constexpr int stability_classes = 6;
std::string in_words(StabilityClass of);  // "good", "inaccurate", "suspect", "too slow", "blew up", "refused"

// The worst that holds: refused combinations and crashes come before too slow, suspect and inaccurate.
StabilityClass class_of(const Outcome& outcome, const std::string& error, double error_bound);

// A map of one case and one closure.
struct StabilityResult {
  std::string case_name, case_title, closure;
  TracedMap map;
  std::vector<double> error;         // of tried points, row by row; NaN elsewhere
  std::vector<std::string> message;  // why a tried point is not good
  int refused = 0;                   // points that were not run, for the manifest or the schedule refuses them
};

// What a point of the map is before it is run: a plan's point, or why it cannot be run.
struct MapPoint {
  StudyPoint point;
  std::string refusal;
};

// Runs what is asked for and has not ended yet.
using RunPoints = std::function<void(const std::vector<StudyPoint>&)>;

// One map per case and closure of the study. `error` is the number of run.json that is judged.
std::vector<StabilityResult> map_stability(const Study& study, const TryCombination& attempt, const StudyFolder& folder,
                                           const std::string& error, const RunPoints& run);

// Throws ManifestError for what is wrong with the study: a key that no point of the map knows, an error that no case has.
// Returns the number of run.json to judge by: that of the study, or the first of the reference.
std::string check_map(const Study& study, const TryCombination& attempt, bool many);

// <folder>/<case>-<closure>.csv, .svg and .png, stability.md; returns why nothing is drawn, or "".
std::string write_maps(const Study& study, const std::vector<StabilityResult>& maps, const std::string& error,
                       const std::filesystem::path& folder);

}  // namespace riffle
