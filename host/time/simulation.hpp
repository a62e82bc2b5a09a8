// One running case: particles, plugins, schedule, integrator and boundaries together, and its state for checkpoints.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/manifest/case.hpp"
#include "host/plugins/instance.hpp"
#include "host/plugins/registry.hpp"
#include "host/schedule/evaluator.hpp"
#include "host/schedule/host_fields.hpp"
#include "host/terrain/terrain_fields.hpp"
#include "host/time/blow_up.hpp"
#include "host/time/boundaries.hpp"
#include "host/time/integrator.hpp"
#include "host/time/scene_rules.hpp"

namespace riffle {

struct SimulationOptions {
  int threads = 0;    // 0: all cores
  double skin = 0.1;  // of neighbour lists, fraction of the support; 2D and 3D
  RunnerOptions runner;
  bool only_plugins = false;  // to try a combination: plugins and their graph are made, and nothing can be run
};

// All that a later process needs to go on bit by bit.
struct SimulationState {
  std::map<std::string, std::vector<double>> reals;
  std::map<std::string, std::vector<std::int64_t>> integers;
};

struct StepReport {
  double dt = 0;
  std::string limiter;  // "swe-standard: acoustic", "output time", "fixed step", ...
};

// Fields that averages over time are made of, beside those that move; those that the equations do not offer are left out.
const std::vector<std::string>& averaged_fields();

class Simulation {
 public:
  // Throws PluginError, ScheduleError or std::runtime_error with whole sentences when the case cannot be run.
  Simulation(const Case& scene, const Registry& registry, const SimulationOptions& options = {});

  // One step, at most to `until`. Throws RunError when the run cannot go on; the particles then show the last state.
  StepReport step(double until);

  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }
  [[nodiscard]] const Case& scene() const { return case_; }
  [[nodiscard]] ParticleStore& store() { return store_; }
  [[nodiscard]] const ParticleStore& store() const { return store_; }
  [[nodiscard]] const Graph& graph() const { return *graph_; }
  [[nodiscard]] Evaluator& evaluator() { return *evaluator_; }
  [[nodiscard]] const Neighbourhood& neighbourhood() const { return *neighbourhood_; }
  [[nodiscard]] Boundaries& boundaries() { return *boundaries_; }
  [[nodiscard]] const riffle_services& services() const { return terrain_->services(); }
  [[nodiscard]] std::size_t bytes() const { return store_.bytes() + neighbourhood_->bytes(); }
  // What plugins find doubtful about the scene, a sentence each.
  [[nodiscard]] const std::vector<std::string>& doubts() const { return terrain_->warnings(); }
  [[nodiscard]] std::int64_t particle_steps() const { return particle_steps_; }
  // What makes the result doubtful from the start.
  [[nodiscard]] const std::vector<SceneWarning>& warnings() const { return warnings_; }
  // Sum of conserved amount times velocity over the water, per axis.
  [[nodiscard]] std::vector<double> momentum() const;
  // Brings derived fields up to date for output.
  void refresh(const std::vector<std::string>& fields);
  // Fields that output shows when the manifest does not say: initial and evolved ones, position excluded.
  [[nodiscard]] std::vector<std::string> shown_fields() const;

  [[nodiscard]] SimulationState state() const;
  // Throws std::runtime_error with one sentence when the state is not of this case.
  void restore(const SimulationState& state);

 private:
  [[nodiscard]] const PluginInstance* instance_of(const std::string& kind) const;
  void create_plugins(const Registry& registry);
  void place_particles();
  void require_shown_fields() const;
  void require_that_terrain_is_used() const;
  void require_enough_particles(std::int64_t n) const;
  void look_at_scene();
  void add_fields();
  [[nodiscard]] std::vector<std::string> saved_fields() const;

  Case case_;
  SimulationOptions options_;
  ParticleStore store_;
  std::vector<std::unique_ptr<PluginInstance>> instances_;
  std::unique_ptr<Terrain> terrain_;
  std::unique_ptr<TerrainFields> terrain_fields_;
  HostFields host_fields_;
  std::unique_ptr<Graph> graph_;
  std::unique_ptr<Neighbourhood> neighbourhood_;
  std::unique_ptr<Evaluator> evaluator_;
  std::unique_ptr<Integrator> integrator_;
  BlowUp blow_up_;
  std::unique_ptr<Boundaries> boundaries_;
  double time_ = 0, last_dt_ = 0;
  std::int64_t steps_ = 0, particle_steps_ = 0;
  std::vector<SceneWarning> warnings_;
};

}  // namespace riffle
