// Where particles are at t = 0.
//
// A place is wet where the initial depth (if the equation set has one) and `inside` (if given) are above 0.
//
//   spacing       cells of the given size from the lower corner of the domain on; a particle in the middle of each cell
//                 whose middle lies in the domain and is wet. In 1, 2 and 3 dimensions.
//   count         the wetted length is cut into equal cells; a particle in the middle of each. Dry gaps are left out, so
//                 that a cell may reach across one.
//   equal volume  cells hold the same water; the particle stands where half of its cell's water lies on either side.
//
// With count and equal volume, shorelines and jumps of the depth are located by bisection to the last bit. A face
// between cells falls on a jump exactly when the numbers allow it (the water on its left is a whole number of cells);
// otherwise one cell straddles it, as equal volumes demand. What is narrower than 1/8192 of the domain may be missed.
//
//   equal volume in the vertical plane
//                 each particle stands for the water of spacing x spacing, in pores too: host/particles/equal_water.hpp.
//
// A perturbation then moves each particle along each axis by up to that share of the width of its cell, uniformly, by a
// generator whose numbers are the same everywhere. A particle that this would take out of the water stays. Cells keep
// their measure.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <vector>

#include "host/manifest/case.hpp"

namespace riffle {

// One sentence: no particle results, too many do, or a function of [initial] has no value somewhere.
class PlacementError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct PlacedParticles {
  std::array<std::vector<double>, 3> x;  // m, by axis: x | x z | x y z; the axes of the dimension are filled
  std::vector<double> cell_measure;      // m^d: the part of the wet domain that the particle stands for
};

// Share of the space that is open to water, at n points of the vertical plane.
using PorosityAt = std::function<void(std::int64_t n, const double* x, const double* z, double* phi)>;

PlacedParticles place(const Case& scene, const PorosityAt& porosity = {});

}  // namespace riffle
