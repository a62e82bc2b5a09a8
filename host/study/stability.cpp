#include "host/study/stability.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <set>

#include "host/study/refusals.hpp"

namespace riffle {
namespace {

const std::vector<Choice>& closures_of(const Study& study) {
  static const std::vector<Choice> none{Choice{}};
  return study.closures ? study.closures->choices : none;
}

// Everything that is set at point (x, y) of the map.
std::vector<StudyOverride> overrides_at(const Study& study, const Choice& closure, int x, int y) {
  std::vector<StudyOverride> all = study.set;
  all.insert(all.end(), closure.overrides.begin(), closure.overrides.end());
  const std::array<int, 2> turn{x, y};
  for (std::size_t k = 0; k < 2; ++k) {
    const MapAxis& axis = study.map->axes[k];
    all.push_back({axis.key, fmt::format("{}={}", axis.key, axis.value(turn[k])), axis.place});
  }
  if (!study.pictures) all.push_back({"output.picture", "output.picture=false", {}});
  return all;
}

std::vector<std::string> texts_of(const std::vector<StudyOverride>& overrides) {
  std::vector<std::string> texts;
  for (const StudyOverride& change : overrides) texts.push_back(change.text);
  return texts;
}

class Mapper {
 public:
  Mapper(const Study& study, const TryCombination& attempt, const StudyFolder& folder, const std::string& error,
         const RunPoints& run)
      : study_(study), attempt_(attempt), folder_(folder), error_(error), run_(run) {}

  StabilityResult map(const std::filesystem::path& manifest, const Choice& closure) {
    const StabilityMap& map = *study_.map;
    StabilityResult result;
    result.case_name = result.case_title = manifest.stem().string();
    result.closure = closure.label;
    result.points.resize(static_cast<std::size_t>(map.axes[0].points) * static_cast<std::size_t>(map.axes[1].points));
    const Classify classify = [&](const std::vector<GridPoint>& wanted) {
      std::vector<StudyPoint> runs;
      for (const GridPoint& p : wanted) {
        TriedPoint& tried = result.points[index(p)];
        const StudyPoint point = point_at(manifest, closure, p, tried, result);
        if (tried.of != StabilityClass::refused) runs.push_back(point);
      }
      run_(runs);
      std::vector<int> classes;
      for (const GridPoint& p : wanted) {
        TriedPoint& tried = result.points[index(p)];
        if (tried.of != StabilityClass::refused) judge(tried);
        classes.push_back(static_cast<int>(tried.of));
      }
      return classes;
    };
    result.map = trace_map(map.axes[0].points, map.axes[1].points, map.search, classify);
    return result;
  }

 private:
  [[nodiscard]] std::size_t index(const GridPoint& p) const {
    return static_cast<std::size_t>(p.y * study_.map->axes[0].points + p.x);
  }

  StudyPoint point_at(const std::filesystem::path& manifest, const Choice& closure, const GridPoint& p,
                      TriedPoint& tried, StabilityResult& result) const {
    const auto& axes = study_.map->axes;
    StudyPoint point;
    point.manifest = manifest;
    point.closure = closure.label;
    point.threads = study_.threads.front();
    point.overrides = texts_of(overrides_at(study_, closure, p.x, p.y));
    point.varied = {{axes[0].name, fmt::format("{:g}", axes[0].value(p.x))},
                    {axes[1].name, fmt::format("{:g}", axes[1].value(p.y))}};
    const Trial trial = attempt_(manifest, point.overrides);
    tried.error = std::numeric_limits<double>::quiet_NaN();
    if (!trial.refusals.empty()) {
      tried.of = StabilityClass::refused;
      tried.message = trial.refusals.front();
      return point;
    }
    result.case_name = point.case_name = trial.case_name;
    result.case_title = trial.title;
    point.line = closure.label + (closure.label.empty() ? "" : ", ") + point.varied[0].first + " = " +
                 point.varied[0].second + ", " + point.varied[1].first + " = " + point.varied[1].second;
    tried.folder = folder_name(point.case_name + '-' + point.line,
                               fmt::format("{}\nthreads {} repeat 0", trial.identity, point.threads));
    point.folders = {tried.folder};
    return point;
  }

  void judge(TriedPoint& tried) const {
    const Outcome outcome = folder_.outcome(tried.folder);
    tried.of = class_of(outcome, error_, study_.map->error_bound);
    tried.error = error_.empty() ? std::numeric_limits<double>::quiet_NaN() : outcome.number(error_);
    tried.message = outcome.message;
  }

  const Study& study_;
  const TryCombination& attempt_;
  const StudyFolder& folder_;
  const std::string& error_;
  const RunPoints& run_;
};

}  // namespace

std::string in_words(StabilityClass of) {
  switch (of) {
    case StabilityClass::good: return "good";
    case StabilityClass::inaccurate: return "inaccurate";
    case StabilityClass::suspect: return "suspect";
    case StabilityClass::too_slow: return "too slow";
    case StabilityClass::blew_up: return "blew up";
    case StabilityClass::refused: break;
  }
  return "refused";
}

StabilityClass class_of(const Outcome& outcome, const std::string& error, double error_bound) {
  switch (outcome.ending) {
    case Ending::too_slow: return StabilityClass::too_slow;
    case Ending::blew_up:
    case Ending::crashed:
    case Ending::missing: return StabilityClass::blew_up;
    case Ending::suspect: return StabilityClass::suspect;
    case Ending::good: break;
  }
  if (!error.empty() && !(outcome.number(error) <= error_bound)) return StabilityClass::inaccurate;
  return StabilityClass::good;
}

std::string check_map(const Study& study, const TryCombination& attempt, bool many) {
  const auto& axes = study.map->axes;
  const double points = static_cast<double>(axes[0].points) * axes[1].points *
                        static_cast<double>(study.cases.size() * closures_of(study).size());
  if (!many && points / 4 > static_cast<double>(study.runs_at_most)) {
    throw ManifestError(
        {fmt::format("{}: the maps have {:.0f} points, of which about a quarter is run, more than "
                     "study.runs_at_most = {}; --yes runs them all the same",
                     study.file.string(), points, study.runs_at_most)});
  }
  Refusals refusals;
  std::set<std::string> fields;
  std::string first;
  for (std::size_t k = 0; k < study.cases.size(); ++k) {
    for (const Choice& closure : closures_of(study)) {
      for (const int x : {0, axes[0].points / 2, axes[0].points - 1}) {
        for (const int y : {0, axes[1].points / 2, axes[1].points - 1}) {
          const std::vector<StudyOverride> overrides = overrides_at(study, closure, x, y);
          const Trial trial = attempt(study.cases[k], texts_of(overrides));
          refusals.note(study.case_places[k], overrides, trial.refusals);
          fields.insert(trial.error_fields.begin(), trial.error_fields.end());
          if (first.empty()) first = first_error(trial);
        }
      }
    }
  }
  Mistakes mistakes;
  refusals.report(mistakes);
  mistakes.throw_if_any();
  check_errors(study, {fields.begin(), fields.end()}, mistakes);
  mistakes.throw_if_any();
  return study.errors.empty() ? first : study.errors.front();
}

std::vector<StabilityResult> map_stability(const Study& study, const TryCombination& attempt, const StudyFolder& folder,
                                           const std::string& error, const RunPoints& run) {
  std::vector<StabilityResult> results;
  Mapper mapper(study, attempt, folder, error, run);
  for (const std::filesystem::path& manifest : study.cases) {
    for (const Choice& closure : closures_of(study)) results.push_back(mapper.map(manifest, closure));
  }
  return results;
}

}  // namespace riffle
