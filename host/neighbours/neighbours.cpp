#include "host/neighbours/neighbours.hpp"

#include <cassert>

#include "host/neighbours/workspace.hpp"

namespace riffle {

NeighbourList::NeighbourList() : workspace(std::make_unique<NeighbourWorkspace>()) {}
NeighbourList::~NeighbourList() = default;
NeighbourList::NeighbourList(NeighbourList&&) noexcept = default;
NeighbourList& NeighbourList::operator=(NeighbourList&&) noexcept = default;

void build(const ParticleView& particles, double kappa, double skin, const NeighbourRequest& request,
           NeighbourList& out) {
  assert(particles.dim >= 1 && particles.dim <= 3 && particles.owned <= particles.all);
  assert(particles.all < (std::int64_t{1} << 31) - 64);
  assert(kappa > 0 && skin >= 0);
  const double factor = (1 + skin) * kappa;
  if (particles.dim == 1) {
    search_line(particles, factor, request, *out.workspace, out);
  } else {
    search_grid(particles, factor, request, *out.workspace, out);
  }
}

}  // namespace riffle
