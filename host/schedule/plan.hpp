// From passes to sweeps: which passes run for a request, fused as far as the declarations allow.
//
// A sweep is one walk over chunks of particles. Inside a chunk the stages run in order; pair passes that share a list
// and do not feed each other form one group, gathered once. A sweep ends only where a later pass reads of neighbours
// what an earlier one wrote, at a global pass, and at the ends of an iteration.
#pragma once

#include <string>
#include <vector>

#include "host/schedule/graph.hpp"

namespace riffle {

struct PairGroup {
  std::vector<int> producers;  // closures whose per-pair output the passes read, in order
  std::vector<int> nodes;
  NeighbourRequest request;
};

struct Stage {
  int group = -1;  // index into Sweep::groups, or
  int node = -1;   // a particle pass
};

struct Sweep {
  std::vector<PairGroup> groups;
  std::vector<Stage> stages;
  std::vector<int> nodes;
  int global = -1;     // a global pass stands alone
  int iteration = -1;  // that the sweep belongs to
};

struct Plan {
  std::vector<Sweep> sweeps;
  std::vector<int> nodes;  // all passes that run, producers included
};

// `wanted` nodes in graph order. Producers of per-pair fields are evaluated inside the groups that read them.
Plan make_plan(const Graph& graph, const std::vector<int>& wanted);

}  // namespace riffle
