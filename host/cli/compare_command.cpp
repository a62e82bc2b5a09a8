// compare: a study's runs, then its tables, charts and report.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>

#include "host/cli/commands.hpp"
#include "host/cli/common.hpp"
#include "host/cli/study_run.hpp"
#include "host/output/atomic_file.hpp"
#include "host/study/attempt.hpp"
#include "host/study/charts.hpp"
#include "host/study/read_study.hpp"
#include "host/study/relative.hpp"
#include "host/study/report.hpp"
#include "host/study/tables.hpp"

namespace riffle {

namespace {

std::string words_of(const StudyPoint& point) {
  std::string words = point.case_name + ", " + point.line;
  if (!point.resolution.empty()) words += fmt::format(", {} = {}", point.resolution_name, point.resolution);
  return words;
}

// One line about a run that has ended.
std::string ended_line(const StudyPoint& point, const Outcome& outcome, const std::string& error) {
  const std::string words = words_of(point);
  if (outcome.ending > Ending::suspect)
    return fmt::format("{}: {} ({})", words, in_words(outcome.ending), outcome.message);
  const double value = error.empty() ? NAN : outcome.number(error);
  return fmt::format("{}: {}{}{:.3g} s CPU", words, outcome.ending == Ending::suspect ? "suspect, " : "",
                     std::isfinite(value) ? fmt::format("{} = {:.3g}, ", shown_name(error), value) : "",
                     outcome.number("cpu_seconds"));
}

// A number that no run has is a mistake of the study, and only the runs tell.
void warn_of_missing_numbers(const StudyResults& results) {
  for (std::size_t e = 0; e < results.errors.size(); ++e) {
    bool ended = false, found = false;
    for (const PointResult& point : results.points) {
      ended = ended || point.counts();
      found = found || std::isfinite(point.errors[e]);
    }
    if (ended && !found) std::cerr << fmt::format("no run has the number \"{}\" in its run.json\n", results.errors[e]);
  }
}

void print_fronts(const StudyResults& results) {
  for (const std::string& name : cases_of(results)) {
    for (std::size_t e = 0; e < results.errors.size(); ++e) {
      const auto front = front_of(results, name, e);
      if (front.empty()) continue;
      std::cout << fmt::format("{}: {} against {}, what nothing beats, from the cheapest on\n", name,
                               shown_name(results.errors[e]), shown_name(results.cost));
      for (const PointResult* point : front) {
        std::cout << fmt::format("  {:>9.3g}  {:>9.3g}  {}\n", point->errors[e], point->cost, words_of(point->point));
      }
    }
  }
}

void write_results(const StudyResults& results, const StudyFolder& folder) {
  write_atomically(folder.path() / "results.csv", results_in_csv(results));
  write_atomically(folder.path() / "results.md", results_in_markdown(results));
  print_fronts(results);
  std::cout << counts_of(results) << "\n";
  std::cout << fmt::format("tables: {}, results.csv\n", (folder.path() / "results.md").string());
  const std::string complaint = draw_charts(results, folder.path());
  if (complaint.empty()) {
    std::cout << fmt::format("charts: {}/charts/\n", folder.path().string());
  } else {
    std::cerr << complaint << "\n";
  }
  const std::filesystem::path library = find_chart_library(program_directory());
  if (library.empty()) {
    std::cerr << "no report is written, for Chart.js is not installed (package libjs-chart.js)\n";
    return;
  }
  write_report(folder.path() / "report.html", report_data(results), library);
  std::cout << fmt::format("report: {}\n", (folder.path() / "report.html").string());
}

int compare(const StudyRequest& request) {
  const Registry registry = open_registry(request.plugin_path, request.study);
  const Study study = read_study(request.study, StudyPurpose::compare, registry);
  const auto trial = [&](const std::filesystem::path& manifest, const std::vector<std::string>& overrides) {
    return attempt(manifest, overrides, registry);
  };
  const StudyPlan plan = plan_study(study, trial, request.yes);
  if (!request.quiet) {
    for (const Skipped& skipped : plan.skipped) {
      std::cerr << fmt::format("skipped: {}: {}\n", skipped.combination, skipped.reason);
    }
  }
  const StudyFolder folder(folder_of(request, study.name));
  std::map<std::string, const StudyPoint*> points;
  for (const StudyPoint& point : plan.points) {
    for (const std::string& name : point.folders) points[name] = &point;
  }
  const std::string error = plan.errors.empty() ? "" : plan.errors.front();
  const LaunchOptions options{request.cores > 0 ? request.cores : usable_cores(), study.exclusive, study.time_limit};
  const Launched launched =
      do_missing(wanted_runs(plan.points, request), folder, request, study.name, options,
                 [&](const std::string& name) { return ended_line(*points.at(name), folder.outcome(name), error); });
  if (launched == Launched::handed_over) return exit_good;
  const StudyResults results = collect(study, plan, folder, "riffle");
  warn_of_missing_numbers(results);
  write_results(results, folder);
  return exit_good;
}

}  // namespace

void add_compare(CLI::App& app, int& code) {
  auto request = std::make_shared<StudyRequest>();
  auto* command =
      app.add_subcommand("compare", "Error against cost over closures and resolutions: riffle compare STUDY.toml");
  add_study_options(*command, *request);
  command->callback([request, &code] { code = guarded([&] { return compare(*request); }); });
}

}  // namespace riffle
