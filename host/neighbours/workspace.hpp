// Memory of the search between builds.
#pragma once

#include "host/neighbours/collect.hpp"
#include "host/neighbours/grid.hpp"
#include "host/neighbours/line.hpp"

namespace riffle {

struct NeighbourWorkspace {
  CollectWorkspace collect;
  Grid grid;
  Line line;
};

// 2D and 3D; 1D. `factor` times the smoothing length is the reach.
void search_grid(const ParticleView& particles, double factor, const NeighbourRequest& request,
                 NeighbourWorkspace& work, NeighbourList& out);
void search_line(const ParticleView& particles, double factor, const NeighbourRequest& request,
                 NeighbourWorkspace& work, NeighbourList& out);

}  // namespace riffle
