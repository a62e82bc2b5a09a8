// Getting runs done: here, by Slurm, or by whoever reads the list.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/study/pool.hpp"
#include "host/study/study_folder.hpp"

namespace riffle {

// A run that a study wants, whoever starts it.
struct WantedRun {
  std::string name;                  // of its folder below runs/
  std::vector<std::string> command;  // `riffle run` with everything but --out
  int threads = 1;
};

struct LaunchOptions {
  int cores = 1;
  bool exclusive = false;
  double time_limit = 0;  // s; 0: none
};

// Those that have not ended yet, each once.
std::vector<WantedRun> missing_runs(const std::vector<WantedRun>& wanted, const StudyFolder& folder);

// The whole command of a run.
std::vector<std::string> full_command(const WantedRun& run, const std::filesystem::path& out);

// On this machine. `ended` is called after each with its name. Throws Interrupted.
void launch_here(const std::vector<WantedRun>& runs, const StudyFolder& folder, const LaunchOptions& options,
                 const std::function<void(const std::string&)>& ended);

// Writes job arrays into <folder>/slurm and submits them with sbatch, one per number of threads and 1000 runs. `extra`:
// further options of sbatch. Returns the lines that sbatch printed; with `wait` only when all runs have ended. Throws
// std::runtime_error with one sentence when sbatch is missing or refuses.
std::vector<std::string> launch_slurm(const std::vector<WantedRun>& runs, const StudyFolder& folder,
                                      const std::string& study, const LaunchOptions& options,
                                      const std::vector<std::string>& extra, bool wait);

// One shell command per run.
std::string listed(const std::vector<WantedRun>& runs, const StudyFolder& folder);

}  // namespace riffle
