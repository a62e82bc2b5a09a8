// What `riffle advise` has to say about a scene. All contributions are shares of the depth: the sum of |h_a - h_b| over the
// sum of h_b, which is the norm "l1" of run.json (host/output/errors.hpp), so that a tolerance means the same everywhere.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/manifest/case.hpp"
#include "host/plugins/registry.hpp"

namespace riffle {

inline constexpr double default_tolerance = 0.005;

using Overrides = std::vector<std::string>;  // "key=value", as for --set

// A number of the scene, from the manifest or from the scout.
struct SceneFigure {
  std::string key, name, unit;  // "froude_number", "largest Froude number", "1"
  double value = 0;
};

// Two runs that differ in one term alone, and what they showed.
struct TermTrial {
  Overrides without, with;
  std::string manifest_without;  // text of the manifest that `without` belongs to, where it is another
  double difference = 0, cpu_without = 0, cpu_with = 0;
  std::string problem;  // why there is no difference
  bool done = false;
  bool against_reference = false;  // `with` alone is run, and its velocity compared with the reference that it names
};

// The last number that the overrides give to a key, or the other.
double number_in(const Overrides& changes, const std::string& key, double otherwise);

inline TermTrial pair_of(Overrides without, Overrides with) {
  TermTrial trial;
  trial.without = std::move(without);
  trial.with = std::move(with);
  return trial;
}

// Something that a model may leave out.
struct Term {
  std::string name;                // "vertical acceleration"
  double contributes = 0;          // estimate; NaN: nothing here tells. Where the depth is resolved: of the forces
  std::string how;                 // where the estimate is from, one clause
  std::string obstacle;            // why it cannot be kept although it matters, or ""
  bool kept = false;               // by the proposal
  std::optional<TermTrial> trial;  // nothing when there is nothing to run
  [[nodiscard]] double measured() const;  // NaN unless a trial has told
  [[nodiscard]] double best()
      const;  // measured, else the estimate; a solution of the same equations does not overrule it
  [[nodiscard]] bool matters(double tolerance) const { return best() > tolerance; }
};

struct Advice {
  std::string case_name, title;
  double tolerance = default_tolerance;
  std::vector<SceneFigure> figures;
  std::vector<Term> terms;
  std::vector<std::string> notes;  // sentences
  std::string model;               // the proposal in a few words; "" when there is none
  Overrides proposal;
  std::string manifest;                    // another one that the proposal belongs to, or ""
  double cpu_given = 0, cpu_proposed = 0;  // s, estimates; NaN where nothing tells
};

struct AdviceRequest {
  std::filesystem::path manifest;
  std::vector<std::filesystem::path> plugin_path;
  Overrides overrides;
  double tolerance = default_tolerance;
  bool verify = false;
  double budget = 20;  // s of CPU for one run of verify; longer ones are cut in time
};

// Throws ManifestError for a case that is wrong, std::runtime_error for one that cannot be judged.
Advice advise(const AdviceRequest& request, const Registry& registry);

std::string advice_in_words(const Advice& advice, const std::string& manifest);
std::string advice_in_json(const Advice& advice);

}  // namespace riffle
