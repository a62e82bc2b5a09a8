// explain: the schedule of a case, derived from what its plugins declare.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <set>

#include "host/cli/commands.hpp"
#include "host/cli/common.hpp"
#include "host/time/simulation.hpp"

namespace riffle {

namespace {

const char* use_name(FieldUse use) {
  switch (use) {
    case FieldUse::evolved: return "evolved";
    case FieldUse::attribute: return "attribute";
    case FieldUse::carried: return "carried";
    default: return "derived";
  }
}

std::string fields_text(const Graph& graph, const std::vector<int>& fields) {
  std::vector<std::string> names;
  names.reserve(fields.size());
  for (const int f : fields) names.push_back(graph.name(f));
  return names.empty() ? "-" : fmt::format("{}", fmt::join(names, ", "));
}

void print_sweeps(const Simulation& simulation, const Plan& plan) {
  const Graph& graph = simulation.graph();
  const auto label = [&](int n) { return graph.nodes()[static_cast<std::size_t>(n)].label; };
  for (std::size_t s = 0; s < plan.sweeps.size(); ++s) {
    const Sweep& sweep = plan.sweeps[s];
    std::cout << fmt::format("\nsweep {}", s + 1);
    if (sweep.iteration >= 0) {
      const Iteration& it = graph.iterations()[static_cast<std::size_t>(sweep.iteration)];
      const bool judged = it.residual >= 0 && !graph.fields()[static_cast<std::size_t>(it.residual)].writers.empty();
      if (judged)
        std::cout << fmt::format(", repeated until {} <= {:g}, at most {} times", graph.name(it.residual), it.tolerance,
                                 it.maximum);
    }
    std::cout << "\n";
    if (sweep.global >= 0) std::cout << "  global  " << label(sweep.global) << "\n";
    for (const auto& stage : sweep.stages) {
      if (stage.node >= 0) {
        std::cout << "  particle  " << label(stage.node) << "\n";
        continue;
      }
      const auto& group = sweep.groups[static_cast<std::size_t>(stage.group)];
      std::set<int> of_neighbours;
      for (const int n : group.nodes) {
        for (const int f : graph.particle_reads(n, true)) of_neighbours.insert(f);
      }
      for (const int n : group.producers) std::cout << "  pair      " << label(n) << " (per pair)\n";
      for (const int n : group.nodes) std::cout << "  pair      " << label(n) << "\n";
      std::cout << "            reads of neighbours: "
                << fields_text(graph, {of_neighbours.begin(), of_neighbours.end()}) << "\n";
    }
  }
}

void explain(Simulation& simulation) {
  const Case& scene = simulation.scene();
  const Graph& graph = simulation.graph();
  std::cout << fmt::format("{}: {} particles, {}D, {}\n\nplugins\n", scene.name, simulation.store().owned(),
                           scene.dimension, scene.time.integrator);
  for (const auto& choice : scene.plugins) {
    std::cout << fmt::format("  {:<12} {:<16} {:<16} {}\n", choice.slot, choice.kind, choice.id,
                             choice.description->version);
  }
  if (scene.reference)
    std::cout << fmt::format("  {:<12} {:<16} {:<16} {}\n", "reference", "reference", scene.reference->plugin.id,
                             scene.reference->plugin.description->version);
  std::cout << "\nonce, at t = 0\n";
  for (const auto& node : graph.nodes()) {
    if (node.initial) std::cout << "  " << node.label << "\n";
  }
  const Plan plan = simulation.evaluator().full_plan();
  print_sweeps(simulation, plan);
  for (const auto& node : graph.nodes()) {
    if (node.occasional) {
      std::cout << fmt::format(
          "\nbetween steps: {}, every {}\n", node.label,
          node.every > 0 ? fmt::format("{} steps", node.every) : fmt::format("{:g} s", node.interval));
    }
  }
  std::cout << "\nadvanced in time\n";
  for (const auto& e : graph.evolved()) {
    std::cout << fmt::format("  {} with {}{}\n", graph.name(e.field), graph.name(e.rate),
                             e.damping >= 0 ? fmt::format(", damped by {} ({})", graph.name(e.damping),
                                                          scene.time.drag_implicit ? "point-implicit" : "explicit")
                                            : "");
  }
  std::cout << "\nlimits of the time step\n";
  for (const auto& vote : graph.votes()) {
    std::cout << fmt::format("  {}{}\n", vote.label,
                             vote.vote->scaled != 0 ? fmt::format(", times cfl = {:g}", scene.time.cfl) : "");
  }
  if (scene.time.fixed_step) std::cout << fmt::format("  none of them: fixed step of {:g} s\n", *scene.time.fixed_step);
  std::cout << "\nfields                    unit           use        bytes/particle  meaning\n";
  for (const auto& [name, field] : simulation.store().fields()) {
    std::cout << fmt::format("  {:<24}{:<15}{:<11}{:>6}          {}\n", name, field->description.unit,
                             use_name(field->use), 8 * field->component.size(), field->description.meaning);
  }
  for (const auto& doubt : simulation.doubts()) std::cout << "\nwarning: " << doubt << "\n";
  for (const auto& warning : simulation.warnings()) std::cout << "\nwarning: " << warning.text << "\n";
  for (const auto& note : graph.notes()) std::cout << "\nnote: " << note << "\n";
}

// What a step costs here, by trying a few: the honest estimate.
void estimate(Simulation& simulation) {
  constexpr int tries = 5;
  const std::clock_t start = std::clock();
  double dt = 0;
  std::string limiter;
  for (int k = 0; k < tries; ++k) {
    const StepReport report = simulation.step(simulation.scene().time.end);
    dt = report.dt;
    limiter = report.limiter;
  }
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / tries;
  const double steps = simulation.scene().time.end / dt;
  std::cout << fmt::format(
      "\ncost: {:.3g} ms CPU per step; dt = {:.3g} s, limited by {}; about {:.3g} steps and {:.3g} s CPU to t = {:g} "
      "s\n",
      1e3 * seconds, dt, limiter, steps, steps * seconds, simulation.scene().time.end);
  std::cout << fmt::format("memory: {} bytes per particle, neighbour lists included\n",
                           simulation.bytes() / static_cast<std::size_t>(simulation.store().owned()));
}

}  // namespace

void add_explain(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("explain", "Show what a case would do: schedule, sweeps, fields, limits, cost");
  auto manifest = std::make_shared<std::filesystem::path>();
  auto overrides = std::make_shared<std::vector<std::string>>();
  auto paths = std::make_shared<std::vector<std::filesystem::path>>();
  command->add_option("case", *manifest, "The manifest (TOML)")->required();
  command->add_option("--set", *overrides, "Override a key, as for run")->take_all()->allow_extra_args(false);
  command->add_option("--plugin-path", *paths, "Folder with further plugins (may be repeated)")
      ->take_all()
      ->allow_extra_args(false);
  command->callback([manifest, overrides, paths, &code] {
    const Registry registry = open_registry(*paths, *manifest);
    const auto scene = open_case(*manifest, *overrides, registry);
    code = exit_bad_input;
    if (!scene) return;
    try {
      Simulation simulation(*scene, registry);
      explain(simulation);
      estimate(simulation);
      code = exit_good;
    } catch (const ScheduleError& error) {
      for (const auto& line : error.lines()) std::cerr << manifest->string() << ": " << line << "\n";
    } catch (const RunError& error) {
      std::cerr << manifest->string() << ": " << error.what() << "\n";
      code = exit_failed;
    } catch (const std::exception& error) {
      std::cerr << manifest->string() << ": " << error.what() << "\n";
    }
  });
}

}  // namespace riffle
