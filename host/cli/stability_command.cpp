// stability: maps over two parameters, with the boundary between what works and what does not.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <memory>

#include "host/cli/commands.hpp"
#include "host/cli/common.hpp"
#include "host/cli/study_run.hpp"
#include "host/study/attempt.hpp"
#include "host/study/map_output.hpp"
#include "host/study/read_study.hpp"

namespace riffle {

namespace {

int stability(const StudyRequest& request) {
  if (request.launcher == "print" || request.collect || (request.launcher == "slurm" && !request.wait)) {
    std::cerr
        << "which points a map needs is seen only when the first have ended: riffle stability takes no --collect, no "
           "--launcher print, and --launcher slurm with --wait only\n";
    return exit_bad_input;
  }
  const Registry registry = open_registry(request.plugin_path, request.study);
  const Study study = read_study(request.study, StudyPurpose::stability, registry);
  const TryCombination trial = [&](const std::filesystem::path& manifest, const std::vector<std::string>& overrides) {
    return attempt(manifest, overrides, registry);
  };
  const std::string error = check_map(study, trial, request.yes);
  const StudyFolder folder(folder_of(request, study.name));
  const LaunchOptions options{request.cores > 0 ? request.cores : usable_cores(), study.exclusive, study.time_limit};
  const RunPoints run = [&](const std::vector<StudyPoint>& points) {
    std::map<std::string, const StudyPoint*> named;
    for (const StudyPoint& point : points) named[point.folders.front()] = &point;
    do_missing(wanted_runs(points, request), folder, request, study.name, options, [&](const std::string& name) {
      const Outcome outcome = folder.outcome(name);
      const StabilityClass of = class_of(outcome, error, study.map->error_bound);
      return fmt::format("{}, {}: {}{}", named.at(name)->case_name, named.at(name)->line, in_words(of),
                         outcome.message.empty() ? "" : fmt::format(" ({})", outcome.message));
    });
  };
  const std::vector<StabilityResult> results = map_stability(study, trial, folder, error, run);
  const std::string complaint = write_maps(study, results, error, folder.path());
  if (!complaint.empty()) std::cerr << complaint << "\n";
  for (const StabilityResult& result : results) {
    std::map<StabilityClass, int> counts;
    for (const int of : result.map.of) ++counts[static_cast<StabilityClass>(of)];
    std::string words;
    for (const auto& [of, count] : counts) words += fmt::format(", {} {}", count, in_words(of));
    std::cout << fmt::format("{}{}: {} of {} points run{}\n", result.case_name,
                             result.closure.empty() ? "" : ", " + result.closure, result.map.runs(),
                             result.map.of.size(), words);
  }
  std::cout << fmt::format("maps: {}, with a picture and a CSV each\n", (folder.path() / "stability.md").string());
  return exit_good;
}

}  // namespace

void add_stability(CLI::App& app, int& code) {
  auto request = std::make_shared<StudyRequest>();
  auto* command =
      app.add_subcommand("stability", "Map where a case works over two parameters: riffle stability STUDY.toml");
  add_study_options(*command, *request);
  command->callback([request, &code] { code = guarded([&] { return stability(*request); }); });
}

}  // namespace riffle
