// Neighbour lists for any particle set in 1, 2 or 3 dimensions, with uniform or variable smoothing length.
//
// A list serves every pass that can share its reach and its roles. With a skin it stays valid over several steps:
// verlet.hpp says for how long. All functions run on the OpenMP threads of the caller's setting, and what they return
// is a function of positions and particle order alone: the same for any number of threads.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "host/neighbours/index_array.hpp"

namespace riffle {

// Which neighbours j particle i has; kappa l is the support of the kernel with smoothing length l.
enum class Reach {
  gather,   // r < kappa l_i
  scatter,  // r < kappa l_j
  either    // r < kappa max(l_i, l_j)
};

struct NeighbourRequest {
  Reach reach = Reach::gather;
  std::uint32_t targets = ~0u, sources = ~0u;  // masks of roles: bit r = role r
};

// Particles as the search sees them, laid out [owned | images | dummy]; owned ones are grouped by role.
struct ParticleView {
  int dim = 1;                         // 1, 2 or 3
  std::int64_t owned = 0, all = 0;     // the dummy has index `all`; it is never read here
  const double* x[3] = {};             // [all] each, m
  const double* l = nullptr;           // [all] smoothing lengths, m; nullptr: uniform_l for all
  double uniform_l = 0;                // m
  const std::uint8_t* role = nullptr;  // [all] role indices; nullptr: all have role 0
};

// No segment of a list is longer, so that a block of pairs always fits its arrays.
inline constexpr std::int64_t longest_segment = 1000;

struct NeighbourWorkspace;  // memory of the search, kept so that rebuilding a list allocates nothing

// Full list in compressed rows. Segment of i: neighbour[begin[i]] .. neighbour[begin[i + 1] - 1], of which the first
// count[i] are neighbours and the rest is padding with the dummy's index. Segments follow one another without gaps.
struct NeighbourList {
  NeighbourList();
  ~NeighbourList();
  NeighbourList(NeighbourList&&) noexcept;
  NeighbourList& operator=(NeighbourList&&) noexcept;

  std::vector<std::int64_t> begin;  // [owned + 1], multiples of 4; particles that are not targets have empty segments
  std::vector<std::int32_t> count;  // [owned] true neighbours, self excluded
  IndexArray neighbour;             // [begin[owned]]
  std::int64_t longest = 0;         // of the padded segments
  std::int64_t pairs = 0;           // sum of count
  std::unique_ptr<NeighbourWorkspace> workspace;
};

// Lists for each target all sources with r < (1 + skin) * support, each once and never itself; coincident particles are
// neighbours. Throws std::runtime_error with one sentence that names the particle and its position when a position or a
// smoothing length is not finite, or when a segment would be longer than longest_segment. `out` is then unusable until
// the next successful build.
void build(const ParticleView& particles, double kappa, double skin, const NeighbourRequest& request,
           NeighbourList& out);

// The order in which neighbours in space are neighbours in memory: order[new] = old, [owned]. Stable counting sort by
// cells of the given edge (m), rows along x[0], within each group of equal role; in 1D by x exactly.
// Throws std::runtime_error when a position is not finite.
std::vector<std::int64_t> cell_order(const ParticleView& particles, double cell_size);

}  // namespace riffle
