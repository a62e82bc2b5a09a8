#include "host/study/advise/scout.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "host/manifest/read.hpp"
#include "host/time/simulation.hpp"

namespace riffle {
namespace {

double cpu_time_now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Case case_with(const AdviceRequest& request, const Overrides& further, const Registry& registry) {
  Overrides all = request.overrides;
  all.insert(all.end(), further.begin(), further.end());
  return read_case(request.manifest, all, registry);
}

// The level is what is linear between particles, for the bed may not be.
FlowState state_of(Simulation& simulation, const FlowLine& line) {
  simulation.refresh({"depth", "velocity"});
  const ParticleStore& store = simulation.store();
  const auto n = static_cast<std::size_t>(store.role_begin(1));
  const auto taken = [&](const char* name) {
    const double* data = store.data(name);
    return std::vector<double>(data, data + n);
  };
  const std::vector<double> x = taken("position"), depth = taken("depth");
  std::vector<double> level(n);
  const riffle_services& scene = simulation.services();
  scene.bed(scene.context, static_cast<std::int64_t>(n), x.data(), nullptr, level.data(), nullptr, nullptr);
  for (std::size_t i = 0; i < n; ++i) level[i] += depth[i];
  FlowState state{simulation.time(), along_line(line, x, depth), along_line(line, x, taken("velocity"))};
  const std::vector<double> surface = along_line(line, x, level);
  for (std::size_t k = 0; k < line.x.size(); ++k) {
    if (state.depth[k] > 0) state.depth[k] = std::max(surface[k] - line.bed[k], 0.0);
  }
  return state;
}

SimulationOptions one_thread() {
  SimulationOptions options;
  options.threads = 1;
  return options;
}

void run_scout(Scout& result, Simulation& simulation, double seconds) {
  const riffle_services& scene = simulation.services();
  scene.bed(scene.context, static_cast<std::int64_t>(result.line.x.size()), result.line.x.data(), nullptr,
            result.line.bed.data(), nullptr, nullptr);
  result.particles = static_cast<int>(simulation.store().owned());
  result.states.push_back(state_of(simulation, result.line));
  const double start = cpu_time_now();
  for (int k = 1; k <= scout_states; ++k) {
    const double until = result.end * k / scout_states;
    while (simulation.time() < until) {
      simulation.step(until);
      if (simulation.steps() % 64 == 0 && cpu_time_now() - start > seconds) {
        result.problem = "it was not done after " + std::to_string(static_cast<int>(seconds)) + " s";
        return;
      }
    }
    result.states.push_back(state_of(simulation, result.line));
  }
  result.cpu_seconds = cpu_time_now() - start;
}

}  // namespace

Overrides quiet_output() {
  return {"output.picture=false", "output.fields=[]",    "output.snapshots=0",
          "output.profiles=0",    "output.checkpoint=0", "output.checkpoint_wall=0"};
}

Scout scout(const AdviceRequest& request, const Overrides& further, int cells, const Registry& registry,
            double seconds) {
  Scout result;
  try {
    Overrides all = further;
    for (const std::string& change : quiet_output()) all.push_back(change);
    const Case scene = case_with(request, all, registry);
    result.line = flow_line(scene.lower[0], scene.upper[0], cells);
    result.end = scene.time.end;
    Simulation simulation(scene, registry, one_thread());
    run_scout(result, simulation, seconds);
  } catch (const ManifestError& error) {
    result.problem = error.lines().front();
  } catch (const ScheduleError& error) {
    result.problem = error.lines().front();
  } catch (const std::exception& error) {
    result.problem = error.what();
  }
  return result;
}

double estimated_cost(const AdviceRequest& request, const Overrides& further, const Registry& registry) {
  constexpr int tries = 4;
  constexpr double longest = 1;  // s
  try {
    const Case scene = case_with(request, further, registry);
    Simulation simulation(scene, registry, one_thread());
    double start = cpu_time_now(), begin = 0;
    int steps = 0;
    simulation.step(scene.time.end);  // the first one does more than the others
    if (simulation.time() >= scene.time.end) return cpu_time_now() - start;
    begin = simulation.time();
    start = cpu_time_now();
    while (steps < tries && simulation.time() < scene.time.end && cpu_time_now() - start < longest) {
      simulation.step(scene.time.end);
      ++steps;
    }
    return (cpu_time_now() - start) * (scene.time.end - begin) / (simulation.time() - begin);
  } catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace riffle
