#include "host/cli/study_run.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "host/cli/common.hpp"

namespace riffle {

void add_study_options(CLI::App& command, StudyRequest& request) {
  command.add_option("study", request.study, "The study (TOML)")->required();
  command.add_option("--out", request.out,
                     "Folder for runs and results; default studies/<name>. What is there is not done again");
  command
      .add_option(
          "--launcher", request.launcher,
          "local: runs on this machine; slurm: submits job arrays; print: lists the commands of the missing runs")
      ->check(CLI::IsMember({"local", "slurm", "print"}));
  command.add_option("--cores", request.cores, "Cores for runs on this machine; default all")
      ->check(CLI::Range(1, 4096));
  command
      .add_option("--sbatch", request.sbatch,
                  "Further option for sbatch, such as --sbatch=--partition=long (may be repeated)")
      ->take_all()
      ->allow_extra_args(false);
  command.add_flag("--wait", request.wait, "With --launcher slurm: wait for the jobs and make the results");
  command.add_flag("--collect", request.collect, "Start nothing; make the results of the runs that there are");
  command.add_flag("--retry", request.retry, "Do runs again that blew up, crashed or were too slow");
  command.add_flag("--yes", request.yes, "Do more runs than study.runs_at_most");
  command.add_flag("--quiet", request.quiet, "No line per run");
  command.add_option("--plugin-path", request.plugin_path, "Folder with further plugins (may be repeated)")
      ->take_all()
      ->allow_extra_args(false);
}

std::filesystem::path folder_of(const StudyRequest& request, const std::string& name) {
  return request.out.empty() ? std::filesystem::path("studies") / name : request.out;
}

std::vector<WantedRun> wanted_runs(const std::vector<StudyPoint>& points, const StudyRequest& request) {
  std::vector<WantedRun> runs;
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  for (const StudyPoint& point : points) {
    WantedRun run{
        "", {program, "run", point.manifest.string(), "--threads", std::to_string(point.threads)}, point.threads};
    for (const auto& path : request.plugin_path)
      run.command.insert(run.command.end(), {"--plugin-path", path.string()});
    for (const std::string& change : point.overrides) run.command.insert(run.command.end(), {"--set", change});
    for (const std::string& folder : point.folders) {
      run.name = folder;
      runs.push_back(run);
    }
  }
  return runs;
}

int guarded(const std::function<int()>& work) {
  try {
    return work();
  } catch (const ManifestError& error) {
    for (const auto& line : error.lines()) std::cerr << line << "\n";
    return exit_bad_input;
  } catch (const Interrupted&) {
    std::cerr << "interrupted; the same command goes on with the runs that are missing\n";
    return exit_failed;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return exit_bad_input;
  }
}

Launched do_missing(const std::vector<WantedRun>& wanted, const StudyFolder& folder, const StudyRequest& request,
                    const std::string& study, const LaunchOptions& options,
                    const std::function<std::string(const std::string& name)>& describe) {
  if (request.retry) {
    for (const WantedRun& run : wanted) {
      if (folder.outcome(run.name).ending > Ending::suspect) folder.forget(run.name);
    }
  }
  if (request.collect) return Launched::done;
  const std::vector<WantedRun> missing = missing_runs(wanted, folder);
  if (request.launcher == "print") {
    std::cout << listed(missing, folder);
    return Launched::handed_over;
  }
  if (missing.empty()) return Launched::done;
  if (request.launcher == "slurm") {
    const auto numbers = launch_slurm(missing, folder, study, options, request.sbatch, request.wait);
    std::cerr << fmt::format("{} runs in {} job arrays of Slurm: {}\n", missing.size(), numbers.size(),
                             fmt::join(numbers, ", "));
    if (request.wait) return Launched::done;
    std::cerr << "when they have ended, the same command with --collect makes the results\n";
    return Launched::handed_over;
  }
  std::size_t done = 0;
  launch_here(missing, folder, options, [&](const std::string& name) {
    ++done;
    if (!request.quiet) std::cerr << fmt::format("[{}/{}] {}\n", done, missing.size(), describe(name));
  });
  return Launched::done;
}

}  // namespace riffle
