#include "host/study/advise/verify.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "host/study/advise/profile_file.hpp"
#include "host/study/pool.hpp"

namespace riffle {
namespace {

constexpr int compared_points = 2000;

// A folder of its own, gone with its contents when the runs have been read.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "riffle-advise-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder can be made for the runs: " + name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct MeasuredRun {
  FlowState state;
  double cpu_seconds = 0;
  std::string problem;
};

double number_in(const Overrides& changes, const std::string& key, double otherwise) {
  for (const std::string& change : changes) {
    if (change.rfind(key + '=', 0) == 0) otherwise = std::atof(change.c_str() + key.size() + 1);
  }
  return otherwise;
}

class Verifier {
 public:
  Verifier(const AdviceRequest& request, const Scout& scout, Advice& advice)
      : request_(request),
        scout_(scout),
        advice_(advice),
        line_(flow_line(scout.line.low, scout.line.high, compared_points)) {}

  void run(const std::array<double, 2>& region) {
    for (Term& term : advice_.terms) {
      if (term.trial) shorten(term);
    }
    std::vector<Overrides> wanted;
    for (const Term& term : advice_.terms) {
      if (!term.trial) continue;
      for (const Overrides* changes : {&term.trial->without, &term.trial->with}) {
        if (runs_.emplace(*changes, MeasuredRun{}).second) wanted.push_back(*changes);
      }
    }
    do_runs(wanted);
    for (Term& term : advice_.terms) {
      if (term.trial) judge(*term.trial, region);
    }
  }

 private:
  // By the scout's cost, which grows with the square of the number of particles.
  void shorten(Term& term) {
    TermTrial& trial = *term.trial;
    double longest = 0;
    for (const Overrides* changes : {&trial.without, &trial.with}) {
      const double ratio = number_in(*changes, "initial.particles.count", scout_.particles) / scout_.particles;
      longest = std::max(longest, scout_.cpu_seconds * ratio * ratio);
    }
    constexpr double dearer = 3;  // than the scout's model
    if (dearer * longest <= request_.budget) return;
    const double end = scout_.last().time * request_.budget / (dearer * longest);
    for (Overrides* changes : {&trial.without, &trial.with}) changes->push_back(fmt::format("time.end={:.3g}", end));
    advice_.notes.push_back(fmt::format("{}: measured up to t = {:.3g} s only", term.name, end));
  }

  void do_runs(const std::vector<Overrides>& wanted) {
    const TemporaryFolder folder;
    std::vector<Job> jobs;
    const auto out = [&](std::size_t k) { return folder.path() / std::to_string(k); };
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      Job job;
      job.command = {std::filesystem::read_symlink("/proc/self/exe").string(),
                     "run",
                     request_.manifest.string(),
                     "--threads",
                     "1",
                     "--quiet",
                     "--out",
                     out(k).string()};
      for (const auto& path : request_.plugin_path) job.command.insert(job.command.end(), {"--plugin-path", path});
      for (const Overrides& changes : {request_.overrides, quiet_output(), wanted[k]}) {
        for (const std::string& change : changes) job.command.insert(job.command.end(), {"--set", change});
      }
      job.said = folder.path() / (std::to_string(k) + ".txt");
      jobs.push_back(std::move(job));
    }
    run_jobs(jobs, {usable_cores(), false}, [&](std::size_t k, const JobEnd& end) {
      MeasuredRun& run = runs_[wanted[k]];
      try {
        if (end.signal != 0) throw std::runtime_error(fmt::format("it was ended by signal {}", end.signal));
        std::ifstream record(out(k) / "run.json");
        if (!record) throw std::runtime_error("it left no record");
        const nlohmann::json json = nlohmann::json::parse(record);
        if (json.at("status") == "failed") throw std::runtime_error(json.value("message", "it failed"));
        run.cpu_seconds = json.at("cpu_seconds").get<double>();
        const auto columns = profile_columns(out(k) / "profile.csv", {"x", "depth"});
        run.state = {json.at("time").get<double>(), along_line(line_, columns[0], columns[1]), {}};
      } catch (const std::exception& error) {
        run.problem = error.what();
      }
    });
  }

  void judge(TermTrial& trial, const std::array<double, 2>& region) {
    const MeasuredRun &without = runs_[trial.without], &with = runs_[trial.with];
    trial.problem = !without.problem.empty() ? "without it: " + without.problem
                    : !with.problem.empty()  ? "with it: " + with.problem
                                             : "";
    trial.cpu_without = without.cpu_seconds;
    trial.cpu_with = with.cpu_seconds;
    if (!trial.problem.empty()) return;
    trial.difference = relative_difference(line_, without.state.depth, with.state.depth, region[0], region[1]);
    trial.done = true;
  }

  const AdviceRequest& request_;
  const Scout& scout_;
  Advice& advice_;
  FlowLine line_;
  std::map<Overrides, MeasuredRun> runs_;
};

}  // namespace

void verify_terms(const AdviceRequest& request, const std::array<double, 2>& region, const Scout& scout,
                  Advice& advice) {
  Verifier(request, scout, advice).run(region);
}

}  // namespace riffle
