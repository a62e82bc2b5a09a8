// Ends a run that has blown up although every number in it is finite.
//
// Steps shrink as speeds grow, so that an unstable run settles at speeds without sense and steps too short to come to an
// end. Either of two signs is enough:
//   - water faster than three times the speed of waves, where that is a constant of the equations: the speed of sound of
//     weakly compressible water, chosen far above all speeds. From about once on the flow is no water any more; single
//     splashes get no further than that. (Where it follows from the depth, no such bound is known: water that runs down a
//     steep slope reaches twenty times, and the verdicts of the watch doubt what is wrong.)
//   - a step below a millionth of the longest one that was allowed: the rest would take a million times as long.
#pragma once

#include <cstdint>

#include "host/particles/store.hpp"
#include "host/schedule/evaluator.hpp"

namespace riffle {

class BlowUp {
 public:
  static constexpr double of_sound = 3, shortest = 1e-6;
  static constexpr std::int64_t interval = 10;  // steps between looks at the speeds

  // Before a step of at most `limit`, the `steps`-th. Throws RunError with one sentence.
  void look(const ParticleStore& store, const Limit& limit, std::int64_t steps);

 private:
  static void look_at_speeds(const ParticleStore& store, const Limit& limit);

  double longest_ = 0;
};

}  // namespace riffle
