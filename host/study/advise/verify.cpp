#include "host/study/advise/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "host/study/advise/flow.hpp"
#include "host/study/advise/profile_file.hpp"
#include "host/study/advise/temporary_folder.hpp"
#include "host/study/pool.hpp"

namespace riffle {
namespace {

constexpr int compared_points = 2000;

struct MeasuredRun {
  std::vector<double> depth;  // or height of the surface, along the line
  double from_reference = 0;  // relative L1 difference of velocity_x from the exact one
  double cpu_seconds = 0;
  std::string problem;
};

// The highest water in each cell of the line.
std::vector<double> surface_along(const FlowLine& line, const std::vector<double>& x, const std::vector<double>& z,
                                  double spacing) {
  std::vector<double> height(line.x.size(), 0);
  if (x.empty()) return height;
  const double bottom = *std::min_element(z.begin(), z.end()) - 0.5 * spacing;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double cell = (x[i] - line.low) / line.step();
    if (cell < 0 || cell >= static_cast<double>(height.size())) continue;
    double& highest = height[static_cast<std::size_t>(cell)];
    highest = std::max(highest, z[i] + 0.5 * spacing - bottom);
  }
  return height;
}

double share_apart(const std::vector<double>& computed, const std::vector<double>& exact) {
  double apart = 0, sum = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!std::isfinite(exact[i])) continue;
    apart += std::abs(computed[i] - exact[i]);
    sum += std::abs(exact[i]);
  }
  return apart / sum;
}

class Verifier {
 public:
  Verifier(const AdviceRequest& request, const VerifiedScene& scene, Advice& advice)
      : request_(request), scene_(scene), advice_(advice), line_(flow_line(scene.low, scene.high, points(scene))) {}

  void run() {
    for (Term& term : advice_.terms) {
      if (term.trial) shorten(term);
    }
    std::vector<RunKey> wanted;
    for (const Term& term : advice_.terms) {
      if (!term.trial) continue;
      if (!term.trial->against_reference) want({term.trial->manifest_without, term.trial->without}, wanted);
      want({"", term.trial->with}, wanted);
    }
    do_runs(wanted);
    for (Term& term : advice_.terms) {
      if (term.trial) judge(*term.trial);
    }
  }

 private:
  static int points(const VerifiedScene& scene) {
    if (scene.spacing == 0) return compared_points;
    return std::max(4, static_cast<int>((scene.high - scene.low) / (4 * scene.spacing)));
  }

  using RunKey = std::pair<std::string, Overrides>;  // text of another manifest, or ""

  void want(const RunKey& run, std::vector<RunKey>& wanted) {
    if (runs_.emplace(run, MeasuredRun{}).second) wanted.push_back(run);
  }

  void shorten(Term& term) {
    TermTrial& trial = *term.trial;
    const bool cheap = trial.against_reference || !trial.manifest_without.empty();
    const double without = cheap ? 0 : scene_.cost(trial.without), with = scene_.cost(trial.with);
    const double longest = std::max(std::isfinite(without) ? without : 0, std::isfinite(with) ? with : 0);
    if (longest <= request_.budget) return;
    const double end = scene_.end * request_.budget / longest;
    for (Overrides* changes : {&trial.without, &trial.with}) changes->push_back(fmt::format("time.end={:.3g}", end));
    advice_.notes.push_back(fmt::format("{}: measured up to t = {:.3g} s only", term.name, end));
  }

  void do_runs(const std::vector<RunKey>& wanted) {
    const TemporaryFolder folder;
    std::vector<Job> jobs;
    const auto out = [&](std::size_t k) { return folder.path() / std::to_string(k); };
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      Job job;
      const auto& [text, changes] = wanted[k];
      const std::filesystem::path other = folder.path() / (std::to_string(k) + ".toml");
      if (!text.empty()) std::ofstream(other) << text;
      job.command = {std::filesystem::read_symlink("/proc/self/exe").string(),
                     "run",
                     (text.empty() ? request_.manifest : other).string(),
                     "--threads",
                     "1",
                     "--quiet",
                     "--out",
                     out(k).string()};
      for (const auto& path : request_.plugin_path) job.command.insert(job.command.end(), {"--plugin-path", path});
      for (const Overrides& some : {text.empty() ? request_.overrides : Overrides{}, quiet_output(), changes}) {
        for (const std::string& change : some) job.command.insert(job.command.end(), {"--set", change});
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
        read_profile(out(k) / "profile.csv", run, wanted[k]);
      } catch (const std::exception& error) {
        run.problem = error.what();
      }
    });
  }

  void read_profile(const std::filesystem::path& file, MeasuredRun& run, const RunKey& key) const {
    if (scene_.spacing == 0 || !key.first.empty()) {
      const auto columns = profile_columns(file, {"x", "depth"});
      run.depth = along_line(line_, columns[0], columns[1]);
      return;
    }
    const auto columns = profile_columns(file, {"x", "z"});
    run.depth = surface_along(line_, columns[0], columns[1], scene_.spacing);
    for (const Term& term : advice_.terms) {
      if (!term.trial || !term.trial->against_reference || term.trial->with != key.second) continue;
      const auto speeds = profile_columns(file, {"velocity_x", "velocity_x_exact"});
      run.from_reference = share_apart(speeds[0], speeds[1]);
    }
  }

  void judge(TermTrial& trial) {
    const MeasuredRun& with = runs_[{"", trial.with}];
    const MeasuredRun& without = trial.against_reference ? with : runs_[{trial.manifest_without, trial.without}];
    trial.problem = !without.problem.empty() ? "without it: " + without.problem
                    : !with.problem.empty()  ? "with it: " + with.problem
                                             : "";
    trial.cpu_without = trial.against_reference ? 0 : without.cpu_seconds;
    trial.cpu_with = with.cpu_seconds;
    if (!trial.problem.empty()) return;
    trial.difference = trial.against_reference
                           ? with.from_reference
                           : relative_difference(line_, without.depth, with.depth, scene_.region[0], scene_.region[1]);
    trial.done = true;
  }

  const AdviceRequest& request_;
  const VerifiedScene& scene_;
  Advice& advice_;
  FlowLine line_;
  std::map<RunKey, MeasuredRun> runs_;
};

}  // namespace

void verify_terms(const AdviceRequest& request, const VerifiedScene& scene, Advice& advice) {
  Verifier(request, scene, advice).run();
}

}  // namespace riffle
