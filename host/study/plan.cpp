#include "host/study/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "host/manifest/nearest.hpp"
#include "host/plugins/sha256.hpp"
#include "host/study/refusals.hpp"

namespace riffle {
namespace {

constexpr const char* unchanged = "as in the case";

std::string joined(const Settings& settings) {
  std::string words;
  for (const auto& [name, value] : settings) words += fmt::format("{}{} = {}", words.empty() ? "" : ", ", name, value);
  return words;
}

// An axis that nobody gave has one choice that changes nothing.
const Axis& or_nothing(const std::optional<Axis>& axis) {
  static const Axis nothing{"", {Choice{}}};
  return axis ? *axis : nothing;
}

class Planner {
 public:
  Planner(const Study& study, const TryCombination& attempt) : study_(study), attempt_(attempt) {}

  StudyPlan plan(bool many) {
    refuse_too_many(many);
    for (std::size_t k = 0; k < study_.cases.size(); ++k) {
      for (const Choice& closure : or_nothing(study_.closures).choices) each_varied(k, closure, {}, study_.set, 0);
    }
    Mistakes mistakes;
    refusals_.report(mistakes);
    mistakes.throw_if_any();
    if (result_.points.empty() && !result_.skipped.empty()) {
      mistakes.add({study_.file.string(), 1, 1},
                   fmt::format("no combination of this study can be run; the first, {}: {}",
                               result_.skipped.front().combination, result_.skipped.front().reason));
    }
    check_baseline(mistakes);
    check_errors(mistakes);
    mistakes.throw_if_any();
    return std::move(result_);
  }

 private:
  void refuse_too_many(bool many) const {
    double runs =
        static_cast<double>(study_.cases.size()) * study_.repeats * static_cast<double>(study_.threads.size());
    std::string product = fmt::format("{} cases", study_.cases.size());
    const auto times = [&](const Axis& axis) {
      runs *= static_cast<double>(axis.choices.size());
      product += fmt::format(" x {} of {}", axis.choices.size(), axis.name);
    };
    if (study_.closures) times(*study_.closures);
    for (const Axis& axis : study_.vary) times(axis);
    if (study_.resolution) times(*study_.resolution);
    if (study_.threads.size() > 1) product += fmt::format(" x {} of threads", study_.threads.size());
    if (study_.repeats > 1) product += fmt::format(" x {} repeats", study_.repeats);
    if (many || runs <= static_cast<double>(study_.runs_at_most)) return;
    throw ManifestError(
        {fmt::format("{}: the study would have {:.0f} runs ({}), more than study.runs_at_most = {}; --yes runs "
                     "them all the same",
                     study_.file.string(), runs, product, study_.runs_at_most)});
  }

  void each_varied(std::size_t k, const Choice& closure, const Settings& varied, std::vector<StudyOverride> overrides,
                   std::size_t axis) {
    if (axis < study_.vary.size()) {
      for (const Choice& choice : study_.vary[axis].choices) {
        Settings settings = varied;
        settings.emplace_back(study_.vary[axis].name, choice.label);
        std::vector<StudyOverride> more = overrides;
        more.insert(more.end(), choice.overrides.begin(), choice.overrides.end());
        each_varied(k, closure, settings, more, axis + 1);
      }
      return;
    }
    overrides.insert(overrides.end(), closure.overrides.begin(), closure.overrides.end());
    const Axis& resolutions = or_nothing(study_.resolution);
    for (std::size_t turn = 0; turn < resolutions.choices.size(); ++turn) {
      const Choice& resolution = resolutions.choices[turn];
      std::vector<StudyOverride> all = overrides;
      all.insert(all.end(), resolution.overrides.begin(), resolution.overrides.end());
      StudyPoint point;
      point.manifest = study_.cases[k];
      point.closure = closure.label;
      point.varied = varied;
      point.resolution = resolution.label;
      point.resolution_name = resolutions.name;
      point.resolution_turn = turn;
      add(point, study_.case_places[k], all);
    }
  }

  void add(StudyPoint point, const SourcePlace& place, const std::vector<StudyOverride>& overrides) {
    for (const StudyOverride& change : overrides) point.overrides.push_back(change.text);
    if (!study_.pictures) point.overrides.emplace_back("output.picture=false");
    const Trial trial = attempt_(point.manifest, point.overrides);
    const std::string reason = refusals_.note(place, overrides, trial.refusals);
    point.case_name = trial.case_name.empty() ? point.manifest.stem().string() : trial.case_name;
    point.case_title = trial.title.empty() ? point.case_name : trial.title;
    point.dimension = trial.dimension;
    const Settings varied = point.varied;
    for (const int threads : study_.threads) {
      point.varied = varied;
      point.threads = threads;
      if (study_.threads.size() > 1) point.varied.emplace_back("threads", fmt::format("{}", threads));
      point.line = point.closure + (point.closure.empty() || point.varied.empty() ? "" : ", ") + joined(point.varied);
      if (point.line.empty()) point.line = unchanged;
      if (!reason.empty()) {
        std::string where = point.case_name + ", " + point.line;
        if (!point.resolution.empty()) where += fmt::format(", {} = {}", study_.resolution->name, point.resolution);
        result_.skipped.push_back({where, reason});
        continue;
      }
      point.folders.clear();
      const std::string words =
          fmt::format("{}-{}-{}", point.case_name, point.line == unchanged ? "" : point.line, point.resolution);
      for (int repeat = 0; repeat < study_.repeats; ++repeat) {
        point.folders.push_back(
            folder_name(words, fmt::format("{}\nthreads {} repeat {}", trial.identity, threads, repeat)));
      }
      result_.points.push_back(point);
    }
    if (reason.empty()) note_errors(trial);
  }

  void note_errors(const Trial& trial) {
    error_fields_.insert(trial.error_fields.begin(), trial.error_fields.end());
    if (trial.error_fields.empty() || !study_.errors.empty()) return;
    const std::string first = first_error(trial);
    if (std::find(result_.errors.begin(), result_.errors.end(), first) == result_.errors.end())
      result_.errors.push_back(first);
  }

  void check_baseline(Mistakes& mistakes) const {
    if (study_.baseline.empty() || result_.points.empty()) return;
    std::vector<std::string> labels;
    for (const StudyPoint& point : result_.points) {
      for (const std::string& label : {point.closure, point.line}) {
        if (label == study_.baseline) return;
        if (!label.empty() && std::find(labels.begin(), labels.end(), label) == labels.end()) labels.push_back(label);
      }
    }
    std::string hint = did_you_mean(study_.baseline, labels);
    if (hint.empty()) hint = "; there are " + all_of(labels);
    mistakes.add(study_.baseline_place,
                 fmt::format("the baseline \"{}\" is not in the study{}", study_.baseline, hint));
  }

  void check_errors(Mistakes& mistakes) {
    if (result_.errors.empty()) result_.errors = study_.errors;
    if (!result_.points.empty()) riffle::check_errors(study_, {error_fields_.begin(), error_fields_.end()}, mistakes);
  }

  const Study& study_;
  const TryCombination& attempt_;
  Refusals refusals_;
  StudyPlan result_;
  std::set<std::string> error_fields_;
};

}  // namespace

Settings StudyPoint::settings() const {
  Settings all{{"case", case_name}};
  if (!closure.empty()) all.emplace_back("closure", closure);
  all.insert(all.end(), varied.begin(), varied.end());
  if (!resolution.empty()) all.emplace_back(resolution_name, resolution);
  return all;
}

std::string folder_name(const std::string& words, const std::string& identity) {
  std::string name;
  for (const char c : words) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
    if (kept || (!name.empty() && name.back() != '-')) name += kept ? c : '-';
  }
  constexpr std::size_t enough = 60;
  if (name.size() > enough) name.resize(enough);
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name + '-' + sha256(std::as_bytes(std::span(identity))).substr(0, 10);
}

std::string first_error(const Trial& trial) {
  if (trial.error_fields.empty()) return "";
  const std::string& field = trial.error_fields.front();
  return "errors." + field + (field == measured_surface ? ".rmse" : ".l1");
}

// Errors against a reference are known beforehand; other numbers of run.json are seen when runs have ended.
void check_errors(const Study& study, const std::vector<std::string>& fields, Mistakes& mistakes) {
  std::vector<std::string> known;
  for (const std::string& field : fields) {
    if (field == measured_surface) {
      known.push_back(fmt::format("errors.{}.rmse", field));
      continue;
    }
    for (const char* norm : {"l1", "l2", "linf", "mean"}) known.push_back(fmt::format("errors.{}.{}", field, norm));
  }
  for (std::size_t k = 0; k < study.errors.size(); ++k) {
    const std::string& error = study.errors[k];
    if (error.rfind("errors.", 0) != 0 || std::find(known.begin(), known.end(), error) != known.end()) continue;
    if (known.empty()) {
      mistakes.add(study.error_places[k],
                   fmt::format("\"{}\" needs a [reference] or a [surface] in a case, and no case has one", error));
      continue;
    }
    std::string hint = did_you_mean(error, known);
    if (hint.empty()) hint = "; there are " + all_of(known);
    mistakes.add(study.error_places[k], fmt::format("no case has \"{}\"{}", error, hint));
  }
}

StudyPlan plan_study(const Study& study, const TryCombination& attempt, bool many) {
  return Planner(study, attempt).plan(many);
}

}  // namespace riffle
