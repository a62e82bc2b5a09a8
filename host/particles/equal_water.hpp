// Particles of the same water in the vertical plane: in pores they stand further apart, about spacing / sqrt(phi).
//
// The plane is cut into strips across the axis along which the porosity changes more, of a width spacing / sqrt(phi) with the
// mean porosity of the strip; each strip then into cells that hold the same water, the whole number nearest to
// spacing x spacing each. A particle stands where half of its cell's water lies on either side. Where the porosity changes
// along one axis only this is the placement of Kazemi (2017), eq. 5.1.
// Supports are those of the spacing, so that particles in pores have fewer neighbours, by the factor phi.
#pragma once

#include "host/particles/placement.hpp"
#include "host/particles/water.hpp"

namespace riffle {

PlacedParticles place_equal_water(const Case& scene, const Water& water, const PorosityAt& porosity);

}  // namespace riffle
