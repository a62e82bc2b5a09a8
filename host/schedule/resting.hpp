// Water at rest costs next to nothing: which particles need no evaluation, because nothing that theirs depends on has
// changed by a single bit since the last one.
//
// Particles along a line are taken in groups of 32. Their evolved fields, and those whose previous values are read, are
// compared with what they were; a change wakes everybody within as many reaches as passes look beyond their neighbours. Only
// passes that follow from their inputs alone (RIFFLE_STEADY) may be left out. What is left out would have given the same
// bits again, so results do not depend on it; nor does a checkpoint need to know.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host/schedule/graph.hpp"
#include "host/schedule/images.hpp"
#include "host/schedule/runner.hpp"

namespace riffle {

class Resting {
 public:
  Resting(const Graph& graph, const ParticleStore& store, double kappa);

  // Whether a plan of these nodes (global ones apart) can leave particles out at all.
  [[nodiscard]] bool possible(const std::vector<int>& nodes) const;
  // What is new since the last look, and whom of the water these nodes must be run for; nothing: for all of it.
  std::optional<std::vector<Span>> awake(const std::vector<int>& nodes, const std::vector<Image>& images);
  void ran(const std::vector<int>& nodes);  // for those
  void forget();                            // all is new

 private:
  struct Input {
    const AlignedArray* now;
    std::vector<double> before;
  };
  struct Group {
    std::int64_t changed = 0;  // serial of the look that saw it
    double low = 0, high = 0;  // between which it stood before and after
  };
  void look();
  [[nodiscard]] bool steady(int node) const;

  const Graph& graph_;
  const ParticleStore& store_;
  double kappa_;
  std::vector<Input> inputs_;
  std::vector<int> hops_;          // per node: reaches that it looks away; -1: it may not be left out
  std::vector<std::int64_t> ran_;  // per node: serial at which it last ran
  std::vector<Group> groups_;
  std::int64_t serial_ = 0;
  std::size_t position_ = 0;        // among the inputs
  int pause_ = 0, next_pause_ = 1;  // evaluations without a look, where hardly anything rests
  bool paused_ = false;
};

}  // namespace riffle
