#include "host/study/launch.hpp"

#include <set>

namespace riffle {

std::vector<WantedRun> missing_runs(const std::vector<WantedRun>& wanted, const StudyFolder& folder) {
  std::vector<WantedRun> missing;
  std::set<std::string> seen;
  for (const WantedRun& run : wanted) {
    if (seen.insert(run.name).second && folder.outcome(run.name).ending == Ending::missing) missing.push_back(run);
  }
  return missing;
}

std::vector<std::string> full_command(const WantedRun& run, const std::filesystem::path& out) {
  std::vector<std::string> words = run.command;
  for (const char* word : {"--quiet", "--overwrite", "--out"}) words.emplace_back(word);
  words.push_back(out.string());
  return words;
}

void launch_here(const std::vector<WantedRun>& runs, const StudyFolder& folder, const LaunchOptions& options,
                 const std::function<void(const std::string&)>& ended) {
  std::vector<Job> jobs;
  for (const WantedRun& run : runs) {
    jobs.push_back({full_command(run, folder.run(run.name)), run.threads, options.time_limit, folder.said(run.name)});
  }
  run_jobs(jobs, {options.cores, options.exclusive}, [&](std::size_t k, const JobEnd& end) {
    folder.note_end(runs[k].name, end);
    ended(runs[k].name);
  });
}

std::string listed(const std::vector<WantedRun>& runs, const StudyFolder& folder) {
  std::string lines;
  for (const WantedRun& run : runs) {
    lines += shell_words(full_command(run, std::filesystem::absolute(folder.run(run.name)))) + '\n';
  }
  return lines;
}

}  // namespace riffle
