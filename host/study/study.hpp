// A study as its file says it: which cases, what varies, how it is run, what is compared. docs/comparing.md explains the
// file to its users.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/manifest/mistakes.hpp"

namespace riffle {

// One "key=value" for --set, and where the study says it.
struct StudyOverride {
  std::string key, text;  // "time.cfl", "time.cfl=0.5"
  SourcePlace place;
};

// One of several things that take turns: a closure, a value of a varied key, a resolution, a case.
struct Choice {
  std::string label;
  std::vector<StudyOverride> overrides;
  SourcePlace place;
};

struct Axis {
  std::string name;  // "case", "closure", "alpha", "count", ...
  std::vector<Choice> choices;
};

// One axis of a map of stability: a key that runs over a range.
struct MapAxis {
  std::string name, key;
  double low = 0, high = 1;
  int points = 20;
  bool logarithmic = false, whole = false;  // whole: values are rounded to integers
  SourcePlace place;
  [[nodiscard]] double value(int k) const;  // of point k, from low to high
};

struct StabilityMap {
  std::array<MapAxis, 2> axes;  // x, y
  double error_bound = 0;       // above it a run is inaccurate
  int search = 4;               // points per axis of the grid that is looked at first
};

struct Study {
  std::filesystem::path file;
  std::string name, title;
  std::vector<std::filesystem::path> cases;  // as they can be opened from here
  std::vector<SourcePlace> case_places;
  std::vector<StudyOverride> set;  // for all runs
  std::vector<Axis> vary;          // one per key of [vary]
  std::optional<Axis> closures;
  std::optional<Axis> resolution;
  std::vector<int> threads{1};
  int repeats = 1;
  bool exclusive = false, pictures = true;
  double time_limit = 0;  // s of wall time for one run; 0: none
  std::size_t runs_at_most = 500;
  std::vector<std::string> errors;  // numbers of run.json, "errors.depth.l1"; empty: the first that there is
  std::vector<SourcePlace> error_places;
  std::string cost = "cpu_seconds";
  std::string baseline;  // label of a closure or of a whole combination; empty: none
  SourcePlace baseline_place;
  std::optional<StabilityMap> map;
};

}  // namespace riffle
