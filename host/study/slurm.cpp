// Job arrays for Slurm: a list of runs, a line each, and a script that does the line of its turn.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "host/output/atomic_file.hpp"
#include "host/study/launch.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_array = 1000;  // Slurm's MaxArraySize is 1001 unless a site raises it

std::string program_on_path(const std::string& name) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder) / name;
    if (!folder.empty() && ::access(candidate.c_str(), X_OK) == 0) return candidate.string();
  }
  throw std::runtime_error(name + " is not on PATH; --launcher slurm needs a machine from which Slurm takes jobs");
}

// What a local pool would note of a run that left no record, the script notes here.
constexpr const char* note_end = R"(run() { # name command...
  local name=$1 code ending=crashed
  shift
  [ -e "runs/$name/run.json" ] && return
  (cd "$here" && $limit "$@") > "ended/$name.txt" 2>&1
  code=$?
  if [ -e "runs/$name/run.json" ]; then rm -f "ended/$name.txt"; return; fi
  [ $code = 124 ] && ending="too slow"
  printf '{"ending": "%s", "message": "ended with code %d; see %s", "exit_code": %d}\n' \
    "$ending" "$code" "ended/$name.txt" "$code" > "ended/$name.json.part"
  mv "ended/$name.json.part" "ended/$name.json"
}
)";

std::string script_of(const StudyFolder& folder, const std::string& study, int threads, const LaunchOptions& options,
                      const std::string& list) {
  std::string text = "#!/bin/bash\n";
  text += fmt::format("#SBATCH --job-name=riffle-{}\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task={}\n", study, threads);
  text += "#SBATCH --output=/dev/null\n";
  if (options.exclusive) text += "#SBATCH --exclusive\n";
  text += fmt::format("here={}\ncd {} || exit 1\n", shell_words({fs::current_path().string()}),
                      shell_words({fs::absolute(folder.path()).string()}));
  const std::string limit = fmt::format("timeout --kill-after=5 {}", std::ceil(options.time_limit));
  text += fmt::format("limit='{}'\n", options.time_limit > 0 ? limit : "");
  return text + note_end + fmt::format("eval \"$(sed -n \"${{SLURM_ARRAY_TASK_ID}}p\" slurm/{})\"\n", list);
}

}  // namespace

std::vector<std::string> launch_slurm(const std::vector<WantedRun>& runs, const StudyFolder& folder,
                                      const std::string& study, const LaunchOptions& options,
                                      const std::vector<std::string>& extra, bool wait) {
  const std::string sbatch = program_on_path("sbatch");
  const fs::path here = folder.path() / "slurm";
  fs::create_directories(here);
  std::map<int, std::vector<const WantedRun*>> by_threads;
  for (const WantedRun& run : runs) by_threads[run.threads].push_back(&run);
  std::vector<Job> jobs;
  for (const auto& [threads, group] : by_threads) {
    for (std::size_t begin = 0; begin < group.size(); begin += largest_array) {
      const std::size_t count = std::min(largest_array, group.size() - begin);
      const std::string stem = fmt::format("{}-threads-{}", threads, begin / largest_array + 1);
      std::string list;
      for (std::size_t k = begin; k < begin + count; ++k) {
        const WantedRun& run = *group[k];
        list += "run " + shell_words({run.name}) + ' ' +
                shell_words(full_command(run, fs::absolute(folder.run(run.name)))) + '\n';
      }
      write_atomically(here / (stem + ".txt"), list);
      write_atomically(here / (stem + ".sh"), script_of(folder, study, threads, options, stem + ".txt"));
      Job job;
      job.command = {sbatch, "--parsable", fmt::format("--array=1-{}", count)};
      if (wait) job.command.emplace_back("--wait");
      job.command.insert(job.command.end(), extra.begin(), extra.end());
      job.command.push_back((here / (stem + ".sh")).string());
      job.said = here / (stem + ".said");
      jobs.push_back(job);
    }
  }
  std::vector<std::string> said(jobs.size());
  std::string refusal;
  run_jobs(jobs, {static_cast<int>(jobs.size()), false}, [&](std::size_t k, const JobEnd&) {
    std::ifstream stream(jobs[k].said);
    std::getline(stream, said[k]);
    // With --wait the exit code is that of the runs, so only a missing job number tells of a refusal.
    const bool number = !said[k].empty() && said[k].find_first_not_of("0123456789") == std::string::npos;
    if (!number && refusal.empty()) refusal = said[k].empty() ? "it said nothing" : said[k];
  });
  if (!refusal.empty()) throw std::runtime_error("sbatch took no job: " + refusal);
  return said;
}

}  // namespace riffle
