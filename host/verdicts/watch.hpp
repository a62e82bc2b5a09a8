// Watches a run for signs that its result cannot be trusted although every number is finite: water lost or gained,
// depths that fall to nothing, particles that lose sight of each other or overtake each other, energy out of nothing.
//
// A look costs a few walks over the particles, so it is taken every `interval` steps and when something is written.
// docs/stability.md shows each sign on a scene that has it.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/output/run_record.hpp"
#include "host/time/simulation.hpp"

namespace riffle {

class Watch {
 public:
  static constexpr std::int64_t interval = 50;  // steps

  // Remembers what the scene began with.
  explicit Watch(Simulation& simulation);

  // After a step.
  void look(Simulation& simulation);
  [[nodiscard]] bool due(const Simulation& simulation) const { return simulation.steps() % interval == 0; }

  // What was judged, good or bad, with the worst value seen and when a bound was first crossed.
  [[nodiscard]] std::vector<Verdict> verdicts() const;

  // For checkpoints.
  [[nodiscard]] nlohmann::json state() const;
  void restore(const nlohmann::json& state);

  [[nodiscard]] double seconds() const { return seconds_; }  // wall time of all looks

 private:
  struct Sign {  // above `bound` is bad, or below it where the smallest counts
    double value = 0, bound = 0, first = -1;
    bool seen = false;
    std::string where;
  };
  enum class Worst { largest, smallest, latest };  // which value counts; `latest`: how it ended
  void see(const std::string& name, double value, double bound, double time, Worst worst = Worst::largest,
           const std::string& where = "");
  void look_at_mass(Simulation& simulation);
  void look_at_depth(const Simulation& simulation);
  void look_along_line(const Simulation& simulation);
  void look_at_energy(Simulation& simulation);

  std::map<std::string, Sign> signs_;
  std::vector<std::int64_t> order_;  // ids of the water in ascending x at the last look
  double depth_scale_ = 0, energy_ = 0, liveliest_ = 0;
  std::int64_t one_sided_ = 0;  // at the first look
  bool looked_ = false, closed_ = true;
  double seconds_ = 0;
};

}  // namespace riffle
