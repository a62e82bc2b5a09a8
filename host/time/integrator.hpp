// Integrators over declared evolved fields. They know no physics: they ask for rates by name of field and advance what
// the equation set declares, drag point-implicitly where somebody writes a damping rate.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/schedule/evaluator.hpp"

namespace riffle {

class Integrator {
 public:
  virtual ~Integrator() = default;
  // Advances all evolved fields by `dt`, from `time` to `end`, which is time + dt but for rounding: rates are evaluated
  // at the very times that the run knows. Throws RunError when a value is no longer finite.
  virtual void step(Evaluator& evaluator, double time, double dt, double end) = 0;
  // Fields whose stored values the next step uses again: in checkpoints.
  [[nodiscard]] virtual std::vector<int> carried() const { return {}; }
  [[nodiscard]] virtual bool carrying() const { return false; }  // they are in use: not before the first step
  virtual void resumed() {}                                      // carried fields have been restored
  virtual void restarted() {}                                    // they are void, because particles came or went
};

// Names that make_integrator knows, with a line on each.
struct IntegratorName {
  std::string name, summary;
};
const std::vector<IntegratorName>& integrator_names();

// Adds the fields it needs to the store. `drag_implicit`: damping point-implicit, unconditionally stable; else explicit.
std::unique_ptr<Integrator> make_integrator(const std::string& name, const Graph& graph, ParticleStore& store,
                                            bool drag_implicit);

}  // namespace riffle
