// Fields that the host itself offers, each a pass like any other: it runs only where somebody reads the field (or the
// output shows it) and nobody else gives it, for the roles that its readers have.
//
//   neighbour_count  neighbours j with r < kappa l_i, the particle itself excluded
//   nearest_spacing  distance to the nearest of them; +infinity without any
//   kernel_sum       sum over j, itself included, of V_j W(r, l_i) with V_j = mass / density where both are known, else
//                    volume / depth (shallow water), else cell_measure: 1 inside the water, less at its surface
//   wall_distance    distance to the nearest wall particle (image or not), or to the nearest mirror plane that has
//                    images; +infinity where there is neither
//   local_depth      highest water in the same column, half a spacing added, minus the bed where the scene has one, else
//                    minus the lowest water of the column, half a spacing taken off; columns are two spacings wide in x
//                    (and y). 0 in a dry column. Two and three dimensions; water thrown up counts, so it is of no use
//                    under a breaking wave
#pragma once

#include <memory>
#include <vector>

#include "host/particles/store.hpp"
#include "host/schedule/graph.hpp"
#include "host/schedule/images.hpp"

namespace riffle {

class HostFields {
 public:
  HostFields();
  ~HostFields();

  // As the last of the plugins of a graph. Valid as long as this object.
  [[nodiscard]] ActivePlugin plugin(int dim) const;
  // Before the first evaluation. `kappa`: support of the kernel in smoothing lengths. All must outlive this object's use.
  void connect(const ParticleStore& store, double kappa, const std::vector<Image>& images);

 private:
  struct Instance;
  std::unique_ptr<Instance> instance_;
};

}  // namespace riffle
