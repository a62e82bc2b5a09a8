// What `riffle compare` and `riffle stability` share: options, the folder, doing the runs that are missing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/study/launch.hpp"
#include "host/study/plan.hpp"

namespace CLI {
class App;
}

namespace riffle {

struct StudyRequest {
  std::filesystem::path study, out;
  std::vector<std::filesystem::path> plugin_path;
  std::vector<std::string> sbatch;
  std::string launcher = "local";
  int cores = 0;
  bool yes = false, retry = false, wait = false, collect = false, quiet = false;
};

void add_study_options(CLI::App& command, StudyRequest& request);

// studies/<name>, or what --out says.
std::filesystem::path folder_of(const StudyRequest& request, const std::string& name);

// The runs of a plan as this request starts them.
std::vector<WantedRun> wanted_runs(const std::vector<StudyPoint>& points, const StudyRequest& request);

// The exit code of what is done, with every mistake and failure on stderr, a line each.
int guarded(const std::function<int()>& work);

enum class Launched { done, handed_over };
// Does what is missing, here or through the launcher, and says so on stderr: a line per run that ends. `describe` gives
// what to say about one. Throws Interrupted and std::runtime_error.
Launched do_missing(const std::vector<WantedRun>& wanted, const StudyFolder& folder, const StudyRequest& request,
                    const std::string& study, const LaunchOptions& options,
                    const std::function<std::string(const std::string& name)>& describe);

}  // namespace riffle
