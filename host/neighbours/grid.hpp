// Sources sorted into cells, in as many levels as their reaches ask for.
//
// With smoothing lengths that vary strongly no single cell size is good: cells of the largest reach hold too many small
// particles, smaller ones make large reaches sweep too many cells. So sources are grouped by reach (a factor of two per
// level), each level has cells of its own size, and a target visits every level with the radius that this level needs.
// With uniform smoothing length there is one level, and this is the usual grid.
#pragma once

#include <cstdint>
#include <vector>

#include "host/neighbours/cells.hpp"

namespace riffle {

struct GridLevel {
  double radius = 0;  // largest reach of its sources, m
  Cells cells;
  std::int64_t first_cell = 0;  // in the numbering of all levels' cells one after the other
};

struct Grid {
  std::vector<GridLevel> levels;
  std::vector<std::int32_t> begin;      // [cells + 1] into the sorted arrays
  std::vector<double> x[3];             // sorted positions, readable 8 past the end
  std::vector<double> reach2;           // sorted squares of reaches, readable 8 past the end; empty if uniform
  std::vector<std::int32_t> particle;   // sorted place -> particle, readable 8 past the end
  std::vector<std::int32_t> place;      // [all] particle -> sorted place, -1 if not a source
  std::vector<std::int32_t> histogram;  // scratch
};

// Sorts the sources into `grid`; within a cell they keep their order. The reach of j is `factor` times its smoothing
// length. Throws like build().
void sort_into_cells(const ParticleView& particles, std::uint32_t sources, double factor, Grid& grid);

}  // namespace riffle
