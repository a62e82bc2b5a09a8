// What a study found: one result per combination, repeats taken together.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host/study/plan.hpp"
#include "host/study/study_folder.hpp"

namespace riffle {

struct PointResult {
  StudyPoint point;
  Ending ending = Ending::missing;
  std::string message;                           // why it is not good
  double time = 0;                               // s, simulated, reached
  std::vector<double> errors;                    // one per error of the study; NaN where there is none
  double cost = 0, cost_low = 0, cost_high = 0;  // median and extremes over the repeats; NaN where there is none
  int repeats_done = 0;
  bool same_bits = true;  // the errors of all repeats are equal to the last bit
  std::int64_t particles = 0, steps = 0;
  double spacing = 0;   // that the order of convergence goes by, up to a factor; NaN where there is none
  std::string picture;  // relative to the study's folder, or empty
  std::string command;  // that repeats it
  [[nodiscard]] bool counts() const { return ending == Ending::good || ending == Ending::suspect; }
};

struct StudyResults {
  std::string name, title, cost;
  std::vector<std::string> errors;
  std::string baseline;
  std::vector<PointResult> points;
  std::vector<Skipped> skipped;
};

inline constexpr std::size_t chart_colours = 10, chart_marks = 5;

// A line of the charts: the results of one case and one combination of closures, from the coarsest resolution on.
struct ResultLine {
  std::string case_name, case_title, label;
  std::vector<const PointResult*> points;
  std::size_t colour = 0, mark = 0;  // how charts show it: by closure and by what else varies, where both do
};

// In the order of the study. The lines point into the results.
std::vector<ResultLine> lines_of(const StudyResults& results);

// The line that `line` is measured against: that of the same case whose label is the baseline, or whose closure is and
// which is the same otherwise. nullptr when there is none.
const ResultLine* baseline_of(const ResultLine& line, const std::vector<ResultLine>& lines,
                              const std::string& baseline);

// Reads what the runs left. `program` stands in front of the commands.
StudyResults collect(const Study& study, const StudyPlan& plan, const StudyFolder& folder, const std::string& program);

// "depth.l1" for "errors.depth.l1", "CPU time (s)" for "cpu_seconds": for axes and headings.
std::string shown_name(const std::string& key);

// The command of `riffle run` for a point, without --out.
std::vector<std::string> command_of(const StudyPoint& point, const std::string& program);

}  // namespace riffle
