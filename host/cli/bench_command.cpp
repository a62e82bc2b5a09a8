// bench: what the plugin boundary costs, measured here and now.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "host/bench/boundary.hpp"
#include "host/bench/dam_break.hpp"
#include "host/bench/fused_best.hpp"
#include "host/bench/through_plugins.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/common.hpp"
#include "host/output/atomic_file.hpp"
#include "host/plugins/check/checks.hpp"

namespace riffle {

namespace {

constexpr double skin = 0.1;                // of both lists, fraction of the support
constexpr double agreement_wanted = 1e-12;  // relative L2: sums in another order

struct BoundaryRequest {
  std::vector<std::filesystem::path> plugin_path;
  std::filesystem::path json;
  int repeats = 15;
  std::int64_t along = 400, block = 0;
};

void warn_of_slow_loops(const Registry& registry) {
  for (const auto& [kind, id] : {std::pair<const char*, const char*>{"kernel", "wendland-c2"},
                                 {"viscosity", "monaghan"},
                                 {"filter", "delta-sph"},
                                 {"equations", "wcsph"}}) {
    const Plugin* plugin = registry.plugin(kind, id);
    if (plugin == nullptr) continue;
    const check::Findings found = check::check_speed(*plugin);
    for (const auto* lines : {&found.failures, &found.warnings}) {
      for (const auto& line : *lines) std::cerr << fmt::format("warning: {} {}: {}\n", kind, id, line);
    }
  }
}

int bench_boundary(const BoundaryRequest& request) {
  const Registry registry = open_registry(request.plugin_path, "");
  const bench::BenchState state = bench::make_state(request.along, skin);
  bench::ThroughPlugins plugins(state, registry, skin, request.block);
  bench::BenchRates best(state.particles), ours(state.particles);
  bench::FusedBest fused(state);
  fused(best);
  plugins();
  plugins.copy_to(ours);
  const double difference = bench::relative_difference(ours, best);
  std::cout << fmt::format(
      "{} particles, {:.2f} neighbours, Wendland C2, Monaghan viscosity, weakly compressible flow with density "
      "diffusion, one thread\n",
      state.particles, static_cast<double>(state.true_pairs) / static_cast<double>(state.particles));
  std::cout << fmt::format("plugins and monolith differ by {:.1e} (relative L2)\n", difference);
  if (!(difference < agreement_wanted)) {
    std::cerr << fmt::format("the two sides must agree to {:.0e}: the comparison is void\n", agreement_wanted);
    return exit_failed;
  }
  warn_of_slow_loops(registry);
  const bench::BoundaryTimes times = bench::time_boundary(
      state, [&] { plugins(); }, request.repeats);
  const auto line = [&](const char* name, double ns) {
    std::cout << fmt::format("  {:<44} {:6.2f} ns/pair {:6.1f} M evaluations/s\n", name, ns,
                             1e3 / (ns * static_cast<double>(state.true_pairs) / static_cast<double>(state.particles)));
  };
  line("a  fused scalar loop over cells", times.fused_cells);
  line("b  best monolith fused by hand, same list", times.fused_best);
  line("c  four loaded plugins", *times.plugins);
  std::cout << fmt::format("price of the boundary c/b = {:.2f}, ahead of the usual way a/c = {:.2f}\n", times.price(),
                           times.gain());
  if (!request.json.empty()) {
    const nlohmann::ordered_json json{
        {"particles", state.particles},
        {"neighbours", static_cast<double>(state.true_pairs) / static_cast<double>(state.particles)},
        {"repeats", request.repeats},
        {"fused_cells_ns_per_pair", times.fused_cells},
        {"fused_best_ns_per_pair", times.fused_best},
        {"plugins_ns_per_pair", *times.plugins},
        {"price", times.price()},
        {"gain", times.gain()},
        {"relative_difference", difference}};
    write_atomically(request.json, json.dump(2) + "\n");
  }
  return exit_good;
}

struct DamBreakBench {
  std::vector<std::filesystem::path> plugin_path;
  std::filesystem::path json;
  bench::DamBreakRequest scene;
};

int bench_dam_break_2d(const DamBreakBench& request) {
  const Registry registry = open_registry(request.plugin_path, "");
  const bench::DamBreakFigures figures = bench::bench_dam_break(registry, request.scene);
  std::cout << fmt::format(
      "{} particles of water, {:.1f} neighbours, disordered; Wendland C2, Monaghan viscosity, density diffusion, walls "
      "of "
      "particles; search, steps and walls included\n",
      figures.particles, figures.neighbours);
  std::cout << fmt::format("  {:.2f} M evaluations of all rates per second and core\n",
                           1e-6 * figures.evaluations_per_second_per_core);
  std::cout << fmt::format("  {:.2f} M per second times dt c0 / dx = {:.3f}: advance rate\n",
                           1e-6 * figures.advance_rate, figures.step_over_spacing);
  std::cout << fmt::format("  {:.2f} times as fast with two threads\n", figures.speedup_2_threads);
  std::cout << fmt::format("  {:.0f} bytes per particle\n", figures.bytes_per_particle);
  if (!request.json.empty()) {
    const nlohmann::ordered_json json{{"particles", figures.particles},
                                      {"neighbours", figures.neighbours},
                                      {"evaluations_per_second_per_core", figures.evaluations_per_second_per_core},
                                      {"advance_rate", figures.advance_rate},
                                      {"step_over_spacing", figures.step_over_spacing},
                                      {"speedup_2_threads", figures.speedup_2_threads},
                                      {"bytes_per_particle", figures.bytes_per_particle}};
    write_atomically(request.json, json.dump(2) + "\n");
  }
  return exit_good;
}

void add_dam_break(CLI::App& bench, int& code) {
  auto* command = bench.add_subcommand(
      "dam-break-2d", "A collapsing column in the vertical plane, as a run computes it: CPU time, medians");
  auto request = std::make_shared<DamBreakBench>();
  command->add_option("--json", request->json, "Write the figures to this file");
  command->add_option("--particles", request->scene.particles, "Particles of water, about")
      ->check(CLI::Range(1000, 10000000))
      ->capture_default_str();
  command->add_option("--warm-up", request->scene.warm_up, "Steps before the first that is timed")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  command->add_option("--steps", request->scene.steps, "Steps per repetition")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_option("--repeats", request->scene.repeats, "Timed repetitions with one and with two threads")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--cfl", request->scene.cfl, "[time] cfl of the scene")->capture_default_str();
  command->add_option("--plugin-path", request->plugin_path, "Folder with further plugins (may be repeated)")
      ->take_all()
      ->allow_extra_args(false);
  command->callback([request, &code] {
    try {
      code = bench_dam_break_2d(*request);
    } catch (const std::exception& error) {
      std::cerr << error.what() << "\n";
      code = exit_bad_input;
    }
  });
}

}  // namespace

void add_bench(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("bench", "Measure the program on this machine");
  command->require_subcommand(1);
  auto* boundary = command->add_subcommand(
      "boundary",
      "Plugins against the best hand-written monolith and against the usual way: CPU time, interleaved, medians");
  add_dam_break(*command, code);
  auto request = std::make_shared<BoundaryRequest>();
  boundary->add_option("--json", request->json, "Write the figures to this file");
  boundary->add_option("--repeats", request->repeats, "Timed repetitions of each side")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  boundary->add_option("--along", request->along, "Particles along one side of the square")
      ->check(CLI::Range(20, 2000))
      ->capture_default_str();
  boundary->add_option("--block", request->block, "Pairs per block; 0: as the program chooses")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  boundary->add_option("--plugin-path", request->plugin_path, "Folder with further plugins (may be repeated)")
      ->take_all()
      ->allow_extra_args(false);
  boundary->callback([request, &code] {
    try {
      code = bench_boundary(*request);
    } catch (const std::exception& error) {
      std::cerr << error.what() << "\n";
      code = exit_bad_input;
    }
  });
}

}  // namespace riffle
