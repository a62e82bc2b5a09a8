// Two and three dimensions: each target looks at the rows of cells that its radius touches, level by level.
#include <algorithm>
#include <cmath>
#include <limits>

#include "host/neighbours/filter.hpp"
#include "host/neighbours/workspace.hpp"

namespace riffle {

namespace {

// A wave's buffers should stay in the cache of their core: about 150 kB in 2D.
constexpr std::int64_t particles_per_part = 1024;

template <int dim, Reach reach, bool variable>
class GridSearch {
 public:
  GridSearch(const ParticleView& particles, double factor, const Grid& grid)
      : particles_(particles), factor_(factor), grid_(grid) {
    for (int d = 0; d < dim; ++d) from_.x[d] = grid.x[d].data();
    from_.reach2 = grid.reach2.data();
    from_.particle = grid.particle.data();
  }

  std::int64_t operator()(std::int64_t i, std::int32_t* out) const {
    double at[dim];
    for (int d = 0; d < dim; ++d) at[d] = particles_.x[d][i];
    const double own = factor_ * (variable ? particles_.l[i] : particles_.uniform_l);
    const std::int64_t self = grid_.place[static_cast<std::size_t>(i)];
    std::int32_t* end = out;
    for (const GridLevel& level : grid_.levels) {
      double radius = own;
      if constexpr (variable && reach == Reach::scatter) radius = level.radius;
      if constexpr (variable && reach == Reach::either) radius = std::max(own, level.radius);
      std::int32_t low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
      for (int d = 0; d < dim; ++d) {
        const double margin = 4 * std::numeric_limits<double>::epsilon() * (std::abs(at[d]) + radius);  // rounding
        low[d] = level.cells.index(at[d] - radius - margin, d);
        high[d] = level.cells.index(at[d] + radius + margin, d);
      }
      for (std::int64_t layer = low[2]; layer <= high[2]; ++layer) {
        for (std::int64_t row = low[1]; row <= high[1]; ++row) {
          const std::int32_t* cell = grid_.begin.data() + level.first_cell + level.cells.row(layer, row);
          const std::int64_t first = cell[low[0]], last = cell[high[0] + 1];
          if (first <= self && self < last) {
            end = append(first, self, at, own, i, out, end);
            end = append(self + 1, last, at, own, i, out, end);
          } else {
            end = append(first, last, at, own, i, out, end);
          }
        }
      }
    }
    return end - out;
  }

 private:
  std::int32_t* append(std::int64_t first, std::int64_t last, const double* at, double own, std::int64_t i,
                       const std::int32_t* out, std::int32_t* end) const {
    // with scatter only the neighbours' reaches count
    const double limit2 = variable && reach == Reach::scatter ? 0 : own * own;
    do {  // in pieces, so that a crowd cannot write past the room of a segment
      const std::int64_t stop = std::min(last, first + longest_segment);
      end = append_within < dim, variable && reach != Reach::gather > (from_, first, stop, at, limit2, end);
      if (end - out > longest_segment) throw_too_many_neighbours(particles_, i);
      first = stop;
    } while (first < last);
    return end;
  }

  const ParticleView& particles_;
  double factor_;
  const Grid& grid_;
  Candidates from_{};
};

template <int dim>
void search(const ParticleView& particles, double factor, const NeighbourRequest& request, NeighbourWorkspace& work,
            NeighbourList& out) {
  const auto run = [&](const auto& search) {
    collect(particles, request.targets, particles_per_part, search, work.collect, out);
  };
  if (uniform_reach(particles)) {
    run(GridSearch<dim, Reach::gather, false>(particles, factor, work.grid));
  } else if (request.reach == Reach::gather) {
    run(GridSearch<dim, Reach::gather, true>(particles, factor, work.grid));
  } else if (request.reach == Reach::scatter) {
    run(GridSearch<dim, Reach::scatter, true>(particles, factor, work.grid));
  } else {
    run(GridSearch<dim, Reach::either, true>(particles, factor, work.grid));
  }
}

}  // namespace

void search_grid(const ParticleView& particles, double factor, const NeighbourRequest& request,
                 NeighbourWorkspace& work, NeighbourList& out) {
  sort_into_cells(particles, request.sources, factor, work.grid);
  if (particles.dim == 2) {
    search<2>(particles, factor, request, work, out);
  } else {
    search<3>(particles, factor, request, work, out);
  }
}

}  // namespace riffle
