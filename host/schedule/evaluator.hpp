// Rates on demand: brings the fields that somebody asks for up to date with the smallest set of passes.
//
// Every pass is fresh or stale. Changing a field makes stale what depends on it; computing a field runs the stale passes
// it needs, as sweeps. So an integrator may ask for the density rate, advance density, and then ask for the
// acceleration: the passes between are found from the declarations alone.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/schedule/neighbourhood.hpp"
#include "host/schedule/resting.hpp"
#include "host/schedule/runner.hpp"

namespace riffle {

struct Limit {
  double dt = 0;
  std::string name;  // "swe-standard: acoustic"
};

class Evaluator {
 public:
  Evaluator(const Graph& graph, ParticleStore& store, Neighbourhood& neighbourhood, RunnerOptions options);

  [[nodiscard]] const Graph& graph() const { return graph_; }
  [[nodiscard]] ParticleStore& store() { return store_; }
  [[nodiscard]] Runner& runner() { return runner_; }

  void run_initial_passes();
  void changed(int field);
  void everything_changed();  // particles were added or removed, or a checkpoint was read
  void mark_fresh(const std::vector<int>& nodes);
  // Of each history node: 1 when it is fresh. With restore_history() after everything_changed() it is so again.
  [[nodiscard]] std::vector<std::int64_t> history() const;
  void restore_history(const std::vector<std::int64_t>& fresh);
  void compute(const std::vector<int>& fields, double time, double dt);
  // Passes between steps that are due after `step` steps, at time `time`, the last step having been dt.
  void run_occasional_passes(std::int64_t step, double time, double dt);
  // The smallest vote, each multiplied by cfl where it scales.
  Limit time_step(double cfl, double time, double dt);
  // Passes that one full evaluation of all rates runs, as sweeps.
  [[nodiscard]] Plan full_plan() const;
  // "pass of plugin wrote a NaN into field at particle 17, x = 3.2": the first culprit, or empty.
  [[nodiscard]] std::string find_culprit() const;
  // Nodes whose output depends on their history (iterations, previous values): not derivable from evolved fields.
  [[nodiscard]] std::vector<int> history_nodes() const;

  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }  // sweeps of pair passes over all particles
  [[nodiscard]] double list_seconds() const { return list_seconds_; }
  [[nodiscard]] double sweep_seconds() const { return sweep_seconds_; }

 private:
  // `awake`: the only particles that it must be run for; nullptr: all.
  void run(const Plan& plan, double time, double dt, const std::vector<Span>* awake = nullptr);
  void run_sweep(const Plan& plan, std::size_t index, double time, double dt, const std::vector<Span>* only = nullptr);
  void bring_lists();
  [[nodiscard]] bool may_rest(const Plan& plan) const;
  bool same_images_as_last_time(const Sweep& sweep);
  [[nodiscard]] bool converges_alone(const Plan& plan, std::size_t first, std::size_t last) const;
  [[nodiscard]] std::vector<Span> unconverged(const double* residual, double tolerance) const;
  const Plan& plan_for(const std::vector<int>& nodes);
  void collect(int field, bool all, std::vector<char>& wanted) const;
  void collect_node(int node, bool all, std::vector<char>& wanted) const;
  void make_stale(int node);
  void pass_of_time(double time);
  void require_lists(bool initial);

  const Graph& graph_;
  ParticleStore& store_;
  Neighbourhood& neighbourhood_;
  Runner runner_;
  std::vector<char> stale_;
  std::vector<char> images_current_;          // per field
  std::vector<std::vector<int>> dependents_;  // per field: nodes that read it
  std::vector<int> of_time_;                  // nodes that read nothing that changes, but may look at the time
  double computed_at_ = 0;
  bool attributes_changed_ = false;
  std::map<std::vector<int>, std::unique_ptr<Plan>> plans_;
  std::map<const Sweep*, std::vector<int>> image_fields_;
  std::map<const Plan*, bool> may_rest_;
  std::map<const Sweep*, std::vector<Image>> images_of_sweep_;
  Resting resting_;
  std::vector<double> next_due_;
  bool lists_current_ = false;
  int position_ = -1, smoothing_length_ = -1;
  std::int64_t evaluations_ = 0;
  double list_seconds_ = 0, sweep_seconds_ = 0;
};

}  // namespace riffle
