// What can go wrong with water in pores and leaves every number finite: too few neighbours where particles stand far apart,
// and particles that lock into a lattice and hold the water of a bed.
#pragma once

#include <optional>
#include <vector>

#include "host/output/run_record.hpp"
#include "host/time/simulation.hpp"

namespace riffle {

constexpr double fewest_neighbours_in_pores =
    10;                               // of water and walls; 9 carry a flow that drag rules, but no pressure
constexpr double locked_share = 0.1;  // of the velocity that the reference has in the bed

// Mean number of neighbours within the support of water where the porosity is smallest, in the vertical plane; none where it is 1
// everywhere.
std::optional<double> neighbours_in_pores(const Simulation& simulation);

// Whether the water where the porosity is smallest moves, in the median, as `exact`, the velocity along x that the reference has at each water
// particle, NaN where it has none.
std::optional<Verdict> locked_bed(const Simulation& simulation, const std::vector<double>& exact);

}  // namespace riffle
