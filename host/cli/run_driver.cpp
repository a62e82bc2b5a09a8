#include "host/cli/run_driver.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "host/cli/common.hpp"
#include "host/cli/comparison.hpp"
#include "host/cli/run_report.hpp"
#include "host/cli/surface.hpp"
#include "host/output/atomic_file.hpp"
#include "host/output/checkpoint.hpp"
#include "host/output/log.hpp"
#include "host/output/profiles.hpp"
#include "host/output/progress.hpp"
#include "host/output/run_folder.hpp"
#include "host/output/snapshots.hpp"
#include "host/verdicts/averages.hpp"
#include "host/verdicts/watch.hpp"

namespace riffle {

namespace {

std::atomic<int> caught_signal{0};
extern "C" void on_signal(int number) {
  caught_signal = number;
}

double wall_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Times k * interval, and the next of them after t; infinity when there is no interval.
double next_multiple(double interval, double t) {
  if (!(interval > 0)) return std::numeric_limits<double>::infinity();
  double k = std::floor(t / interval) + 1;
  if (k * interval <= t * (1 + 1e-14)) k += 1;
  return k * interval;
}

class Driver {
 public:
  Driver(const RunRequest& request, const Registry& registry, const Case& scene, RunFolder folder)
      : request_(request),
        registry_(registry),
        case_(scene),
        folder_(std::move(folder)),
        log_(open_log(folder_.log(), request.quiet)) {}

  int run(Simulation& simulation, const nlohmann::json& resumed) {
    for (const int number : {SIGINT, SIGTERM}) std::signal(number, on_signal);
    simulation_ = &simulation;
    wall_start_ = wall_now();
    cpu_start_ = cpu_now();
    if (case_.reference) comparison_ = std::make_unique<Comparison>(case_, registry_, simulation.services());
    if (case_.surface) surface_ = std::make_unique<SurfaceComparison>(case_);
    SnapshotWriter snapshots(folder_.path(), simulation.shown_fields());
    if (!resumed.is_null()) {
      snapshots.resume(resumed.at("snapshots").get<std::int64_t>());
      profiles_ = resumed.at("profiles").get<std::int64_t>();
      limits_ = limits_from(resumed.at("limits"));
      wall_before_ = resumed.at("wall_seconds").get<double>();
      cpu_before_ = resumed.at("cpu_seconds").get<double>();
      momentum_initial_ = resumed.at("momentum_initial").get<std::vector<double>>();
      volume_initial_ = resumed.at("volume_initial").get<double>();
      watch_->restore(resumed.at("watch"));
      if (averages_ && resumed.contains("averages")) averages_->restore(resumed.at("averages"));
      if (surface_) surface_->restore(resumed.value("surface", nlohmann::json::array()));
      log_->info("resumed at t = {} s, step {}", simulation.time(), simulation.steps());
    } else {
      momentum_initial_ = simulation.momentum();
      volume_initial_ = volume_of_water(simulation);
      if (surface_) surface_->look(simulation);
      snapshots.write(simulation.store(), 0, 0);
    }
    for (const auto& warning : simulation.warnings()) log_->warn("{}", warning.text);
    for (const auto& doubt : simulation.doubts()) log_->warn("{}", doubt);
    for (const auto& note : simulation.graph().notes()) log_->debug("{}", note);  // in log.txt only
    log_->info("{}: {} particles, {} threads, to t = {} s", case_.name, simulation.store().owned(),
               omp_get_max_threads(), case_.time.end);
    std::string failure;
    try {
      loop(simulation, snapshots);
    } catch (const RunError& error) {
      failure = fmt::format("t = {:.6g} s, step {}: {}", simulation.time(), simulation.steps(), error.what());
    }
    if (caught_signal != 0) {
      save(snapshots);
      log_->warn("interrupted at t = {:.6g} s; \"riffle run --resume {}\" goes on from here", simulation.time(),
                 folder_.path().string());
      return exit_failed;
    }
    return finish(snapshots, failure);
  }

  void capture_initial(Simulation& simulation) {
    initial_ = capture(simulation);
    watch_ = std::make_unique<Watch>(simulation);
    if (case_.output.averages_interval > 0)
      averages_ = std::make_unique<Averages>(simulation, case_.output.averages_from);
  }

 private:
  void loop(Simulation& simulation, SnapshotWriter& snapshots) {
    const double end = case_.time.end;
    Progress progress(progress_style(request_.quiet),
                      {simulation.time(), end, simulation.steps(), case_.time.max_steps}, std::cerr);
    double saved_at = wall_now();
    while (simulation.time() < end && caught_signal == 0) {
      if (case_.time.max_steps > 0 && simulation.steps() >= case_.time.max_steps) break;
      const double snapshot = next_multiple(case_.output.snapshot_interval, simulation.time());
      const double profile = next_multiple(case_.output.profile_interval, simulation.time());
      const double checkpoint = next_multiple(case_.output.checkpoint_interval, simulation.time());
      const double average = next_multiple(case_.output.averages_interval, simulation.time());
      const double measured = surface_ ? surface_->next(simulation.time()) : std::numeric_limits<double>::infinity();
      const double until = std::min({end, snapshot, profile, checkpoint, average, measured});
      while (simulation.time() < until && caught_signal == 0) {
        if (case_.time.max_steps > 0 && simulation.steps() >= case_.time.max_steps) break;
        const StepReport report = simulation.step(until);
        auto& limit = limits_[report.limiter];
        limit.smallest = limit.steps == 0 ? report.dt : std::min(limit.smallest, report.dt);
        ++limit.steps;
        if (watch_->due(simulation) || simulation.steps() == 1 || simulation.time() >= until) watch_->look(simulation);
        progress.update(simulation.time(), simulation.steps(), report.dt, report.limiter);
        if (case_.output.checkpoint_wall_interval > 0 &&
            wall_now() - saved_at >= case_.output.checkpoint_wall_interval) {
          save(snapshots);
          saved_at = wall_now();
        }
      }
      if (simulation.time() < until) continue;
      const double start = wall_now();
      if (simulation.time() == snapshot && snapshot < end) {
        simulation.refresh(simulation.shown_fields());
        snapshots.write(simulation.store(), simulation.time(), simulation.steps());
      }
      if (simulation.time() == measured) surface_->look(simulation);
      if (simulation.time() == profile && profile < end) write_profile_to(folder_.profile(profiles_++));
      if (simulation.time() == average && averages_) averages_->sample(simulation);
      if (simulation.time() == checkpoint && checkpoint < end) {
        save(snapshots);
        saved_at = wall_now();
      }
      output_seconds_ += wall_now() - start;
    }
    progress.finish();
  }

  void save(const SnapshotWriter& snapshots) {
    SimulationState state = simulation_->state();
    nlohmann::json meta{{"case", case_.name},
                        {"manifest", std::filesystem::absolute(case_.file).string()},
                        {"overrides", case_.overrides},
                        {"effective", nlohmann::json::parse(case_.effective)},
                        {"snapshots", snapshots.written()},
                        {"profiles", profiles_},
                        {"limits", limits_json(limits_)},
                        {"wall_seconds", wall_before_ + wall_now() - wall_start_},
                        {"cpu_seconds", cpu_before_ + cpu_now() - cpu_start_},
                        {"momentum_initial", momentum_initial_},
                        {"volume_initial", volume_initial_},
                        {"surface", surface_ ? surface_->state() : nlohmann::json::array()},
                        {"watch", watch_->state()}};
    if (averages_) meta["averages"] = averages_->state();
    save_checkpoint(folder_.path(), {meta.dump(), std::move(state.reals), std::move(state.integers)});
  }

  void write_profile_to(const std::filesystem::path& path) {
    simulation_->refresh(simulation_->shown_fields());
    write_run_profile(path, *simulation_, comparison_.get());
  }

  int finish(SnapshotWriter& snapshots, const std::string& failure) {
    Simulation& simulation = *simulation_;
    RunReport report;
    report.failure = failure;
    report.limits = limits_;
    report.momentum_initial = momentum_initial_;
    report.volume_initial = volume_initial_;
    if (surface_) report.surface = surface_->errors();
    if (surface_) surface_->write(folder_.path() / "surface.csv");
    report.verdicts = watch_->verdicts();
    if (averages_) {
      report.averages = averages_->result();
      const std::vector<Verdict> more = averages_->verdicts();
      report.verdicts.insert(report.verdicts.end(), more.begin(), more.end());
    }
    report.verdict_seconds = watch_->seconds();
    report.wall_seconds = wall_before_ + wall_now() - wall_start_ - output_seconds_;
    report.cpu_seconds = cpu_before_ + cpu_now() - cpu_start_;
    report.output_seconds = output_seconds_;
    report.resumed_from = request_.resume.empty() ? "" : "checkpoint.h5";
    if (failure.empty()) {
      simulation.refresh(simulation.shown_fields());
      snapshots.write(simulation.store(), simulation.time(), simulation.steps());
      write_run_profile(folder_.profile(), simulation, comparison_.get());
      if (case_.output.picture) report.picture = draw_run(folder_.path(), simulation, comparison_.get(), initial_);
      if (!report.picture.empty() && !std::filesystem::exists(report.picture)) {
        log_->warn("no picture: {}", report.picture.string());
        report.picture.clear();
      }
    } else {
      log_->error("{}", failure);
      write_snapshot(folder_.path() / "failed.hdf", simulation.store(), simulation.shown_fields(), simulation.time(),
                     simulation.steps());
      log_->error("the last state is in {}", (folder_.path() / "failed.hdf").string());
    }
    const RunRecord record = make_record(simulation, registry_, comparison_.get(), report);
    write_run_record(folder_.record(), record);
    std::cout << summary(record, case_, report, folder_.path()) << std::flush;
    return exit_code(record.status, request_.strict);
  }

  const RunRequest& request_;
  const Registry& registry_;
  const Case& case_;
  RunFolder folder_;
  std::shared_ptr<spdlog::logger> log_;
  Simulation* simulation_ = nullptr;
  std::unique_ptr<Comparison> comparison_;
  std::unique_ptr<SurfaceComparison> surface_;
  InitialState initial_;
  std::unique_ptr<Watch> watch_;
  std::unique_ptr<Averages> averages_;
  std::map<std::string, StepLimit> limits_;
  std::vector<double> momentum_initial_;
  double volume_initial_ = 0;
  double wall_start_ = 0, cpu_start_ = 0, wall_before_ = 0, cpu_before_ = 0, output_seconds_ = 0;
  std::int64_t profiles_ = 0;
};

// What must not differ between a checkpoint and the case that goes on from it: all but how long and what to write.
nlohmann::json physics_of(nlohmann::json effective) {
  effective.erase("output");
  effective.erase("reference");
  effective.erase("surface");
  if (effective.contains("time")) effective["time"].erase("end");
  if (effective.contains("time")) effective["time"].erase("max_steps");
  return effective;
}

}  // namespace

int run_case(const RunRequest& request) {
  RunRequest now = request;
  LoadedCheckpoint loaded;
  nlohmann::json meta;
  try {
    if (!now.resume.empty()) {
      loaded = load_checkpoint(now.resume);
      if (!loaded.warning.empty()) std::fprintf(stderr, "%s\n", loaded.warning.c_str());
      meta = nlohmann::json::parse(loaded.checkpoint.meta);
      now.manifest = meta.at("manifest").get<std::string>();
      if (!std::filesystem::exists(now.manifest)) now.manifest = now.resume / "manifest.toml";
      auto overrides = meta.at("overrides").get<std::vector<std::string>>();
      overrides.insert(overrides.end(), request.overrides.begin(), request.overrides.end());
      now.overrides = overrides;
    }
    const Registry registry = open_registry(now.plugin_path, now.manifest);
    const auto scene = open_case(now.manifest, now.overrides, registry);
    if (!scene) return exit_bad_input;
    if (!meta.is_null() && physics_of(meta.at("effective")) != physics_of(nlohmann::json::parse(scene->effective))) {
      std::fprintf(stderr,
                   "%s: the manifest is not the one that this run began with; only [output], [reference], time.end and "
                   "time.max_steps may change on --resume\n",
                   now.manifest.c_str());
      return exit_bad_input;
    }
    SimulationOptions options;
    options.threads = now.threads;
    if (now.block > 0) options.runner.block = now.block;
    if (now.chunk > 0) options.runner.chunk = now.chunk;
    std::unique_ptr<Simulation> simulation;
    try {
      simulation = std::make_unique<Simulation>(*scene, registry, options);
      if (scene->reference) Comparison(*scene, registry, simulation->services());
    } catch (const ScheduleError& error) {
      for (const auto& line : error.lines()) std::fprintf(stderr, "%s: %s\n", now.manifest.c_str(), line.c_str());
      return exit_bad_input;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", now.manifest.c_str(), error.what());
      return exit_bad_input;
    }
    RunFolder folder = !now.resume.empty() ? RunFolder::reopen(now.resume)
                       : !now.out.empty()  ? RunFolder::create_at(now.out, now.overwrite)
                                           : RunFolder::create_numbered("runs", scene->name);
    if (now.resume.empty()) {
      write_atomically(folder.manifest(), text_of(now.manifest));
    } else {
      folder.forget_record();
    }
    Driver driver(now, registry, *scene, std::move(folder));
    driver.capture_initial(*simulation);
    if (!now.resume.empty()) simulation->restore({loaded.checkpoint.reals, loaded.checkpoint.integers});
    return driver.run(*simulation, meta);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return exit_bad_input;
  }
}

}  // namespace riffle
