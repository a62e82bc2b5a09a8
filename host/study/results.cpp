#include "host/study/results.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace riffle {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double middle_of(std::vector<double> values) {
  if (values.empty()) return none;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// From a resolution that is a spacing or a count; else from the number of particles.
double spacing_of(const StudyPoint& point, std::int64_t particles) {
  double number = 0;
  const std::string& text = point.resolution;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size() && number > 0;
  const std::string& name = point.resolution_name;
  if (whole && name.ends_with("spacing")) return number;
  const double count = whole && name.ends_with("count") ? number : static_cast<double>(particles);
  return count > 0 ? std::pow(count, -1.0 / point.dimension) : none;
}

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

// The worst of the repeats decides how the point ended: one that is missing makes it incomplete.
PointResult result_of(const Study& study, const StudyPlan& plan, const StudyPoint& point, const StudyFolder& folder,
                      const std::string& program) {
  PointResult result;
  result.point = point;
  std::vector<double> costs;
  for (std::size_t k = 0; k < point.folders.size(); ++k) {
    const Outcome outcome = folder.outcome(point.folders[k]);
    if (outcome.ending == Ending::missing) continue;
    std::vector<double> errors;
    for (const std::string& error : plan.errors) errors.push_back(outcome.number(error));
    if (result.repeats_done++ == 0) {
      result.ending = outcome.ending;
      result.message = outcome.message;
      result.errors = errors;
      result.time = outcome.number("time");
      const double particles = outcome.number("particles"), steps = outcome.number("steps");
      result.particles = std::isnan(particles) ? 0 : static_cast<std::int64_t>(particles);
      result.steps = std::isnan(steps) ? 0 : static_cast<std::int64_t>(steps);
      std::error_code ignored;
      const std::string picture = "runs/" + point.folders[k] + "/picture.png";
      if (std::filesystem::exists(folder.path() / picture, ignored)) result.picture = picture;
    } else {
      result.same_bits = result.same_bits && std::equal(errors.begin(), errors.end(), result.errors.begin(), same);
      if (outcome.ending > result.ending) {
        result.ending = outcome.ending;
        result.message = outcome.message;
      }
    }
    const double cost = outcome.number(study.cost);
    if (!std::isnan(cost)) costs.push_back(cost);
  }
  result.errors.resize(plan.errors.size(), none);
  result.cost = middle_of(costs);
  result.cost_low = costs.empty() ? none : *std::min_element(costs.begin(), costs.end());
  result.cost_high = costs.empty() ? none : *std::max_element(costs.begin(), costs.end());
  result.spacing = spacing_of(point, result.particles);
  result.command = shell_words(command_of(point, program));
  return result;
}

// The place of a value in a list, which grows by those that are new.
template <class Value>
std::size_t place_in(std::vector<Value>& known, const Value& value) {
  const auto place = static_cast<std::size_t>(std::find(known.begin(), known.end(), value) - known.begin());
  if (place == known.size()) known.push_back(value);
  return place;
}

// Closures by colour and the rest by marks, when charts have enough of both; else colours in turn, then marks.
void give_looks(std::vector<ResultLine>& lines) {
  std::vector<std::string> closures, labels;
  std::vector<Settings> variants;
  for (ResultLine& line : lines) {
    line.colour = place_in(closures, line.points.front()->point.closure);
    line.mark = place_in(variants, line.points.front()->point.varied);
  }
  const bool both = closures.size() > 1 && variants.size() > 1;
  if (both && closures.size() <= chart_colours && variants.size() <= chart_marks) return;
  for (ResultLine& line : lines) {
    const std::size_t turn = place_in(labels, line.label);
    line.colour = turn % chart_colours;
    line.mark = turn / chart_colours % chart_marks;
  }
}

}  // namespace

std::vector<ResultLine> lines_of(const StudyResults& results) {
  std::vector<ResultLine> lines;
  for (const PointResult& result : results.points) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const ResultLine& line) {
      return line.case_name == result.point.case_name && line.label == result.point.line;
    });
    if (found != lines.end()) {
      found->points.push_back(&result);
    } else {
      lines.push_back({result.point.case_name, result.point.case_title, result.point.line, {&result}});
    }
  }
  give_looks(lines);
  return lines;
}

const ResultLine* baseline_of(const ResultLine& line, const std::vector<ResultLine>& lines,
                              const std::string& baseline) {
  if (baseline.empty()) return nullptr;
  for (const ResultLine& other : lines) {
    if (other.case_name != line.case_name) continue;
    if (other.label == baseline) return &other;
    const StudyPoint& theirs = other.points.front()->point;
    if (theirs.closure == baseline && theirs.varied == line.points.front()->point.varied) return &other;
  }
  return nullptr;
}

StudyResults collect(const Study& study, const StudyPlan& plan, const StudyFolder& folder, const std::string& program) {
  StudyResults results{study.name, study.title, study.cost, plan.errors, study.baseline, {}, plan.skipped};
  for (const StudyPoint& point : plan.points) results.points.push_back(result_of(study, plan, point, folder, program));
  return results;
}

std::string shown_name(const std::string& key) {
  if (key == "cpu_seconds") return "CPU time (s)";
  if (key == "wall_seconds") return "wall time (s)";
  return key.rfind("errors.", 0) == 0 ? key.substr(7) : key;
}

std::vector<std::string> command_of(const StudyPoint& point, const std::string& program) {
  std::vector<std::string> words{program, "run", point.manifest.string(), "--threads", std::to_string(point.threads)};
  for (const std::string& change : point.overrides) {
    words.emplace_back("--set");
    words.push_back(change);
  }
  return words;
}

}  // namespace riffle
