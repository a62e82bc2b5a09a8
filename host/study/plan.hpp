// From a study to its runs: the product of everything that varies, without the combinations that mean nothing.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "host/study/study.hpp"

namespace riffle {

// In a list of fields that have errors: the surface against measured levels, which has one number only.
inline constexpr const char* measured_surface = "surface";

// What trying a combination tells without running it.
struct Trial {
  std::vector<std::string> refusals;  // sentences as the manifest and the schedule say them; empty: it can be run
  std::string identity;               // two runs with the same identity compute the same
  std::string case_name, title;
  int dimension = 1;
  std::vector<std::string> error_fields;  // that its reference compares, in the reference's order; measured_surface
};
using TryCombination =
    std::function<Trial(const std::filesystem::path& manifest, const std::vector<std::string>& overrides)>;

using Settings = std::vector<std::pair<std::string, std::string>>;  // ("kernel", "cubic-spline"), ...

// One combination; `repeats` runs.
struct StudyPoint {
  std::filesystem::path manifest;
  std::vector<std::string> overrides;
  int threads = 1;
  std::string case_name, case_title;
  int dimension = 1;
  std::string line;                         // what a line of a chart stands for: "monaghan, kernel = cubic-spline"
  std::string closure;                      // label of the closure alone, or empty
  Settings varied;                          // values of [vary], and threads where they vary
  std::string resolution, resolution_name;  // "1000" and "count", or empty
  std::size_t resolution_turn = 0;
  std::vector<std::string> folders;         // one per repeat: names below runs/
  [[nodiscard]] Settings settings() const;  // all of the above, case first
};

struct Skipped {
  std::string combination, reason;
};

struct StudyPlan {
  std::vector<StudyPoint> points;
  std::vector<Skipped> skipped;
  std::vector<std::string> errors;  // those of the study, or the first of each reference
};

// Throws ManifestError for what is wrong with the study however it is combined: a key that no combination knows, a
// baseline that is not in it, more runs than it says without `many`.
StudyPlan plan_study(const Study& study, const TryCombination& attempt, bool many);

// The number of run.json that is judged when the study names none: the first field's error in L1; "" without a reference.
std::string first_error(const Trial& trial);
// A mistake for each error of the study that none of the cases compares; `fields` are those that they do.
void check_errors(const Study& study, const std::vector<std::string>& fields, Mistakes& mistakes);

// A name for files: "wet-0.5-monaghan-1000-0f3a..."; `identity` makes it one of a kind.
std::string folder_name(const std::string& words, const std::string& identity);

}  // namespace riffle
