/* riffle/fields.h: the dictionary of fields that the host and the shipped plugins share.
 *
 * Each line: X(name, shape, flags, unit, meaning with sign convention). A plugin may also invent fields of its own; two
 * plugins that use one name must agree on shape and unit, which the host checks. Exponent d is the dimension.
 * Velocities are intrinsic (pore) velocities; pressures are relative to the atmosphere, positive in compression.
 */
#ifndef RIFFLE_FIELDS_H
#define RIFFLE_FIELDS_H

#include "riffle/abi.h"

#define RIFFLE_FIELDS(X)                                                                                          \
  X(position, RIFFLE_VECTOR, 0, "m", "position of the particle; z is up")                                         \
  X(velocity, RIFFLE_VECTOR, 0, "m.s-1", "velocity of the water, depth-averaged in shallow-water sets")           \
  X(particle_velocity, RIFFLE_VECTOR, 0, "m.s-1",                                                                 \
    "velocity at which the particle moves, in sets where it may differ from that of the water")                   \
  X(acceleration, RIFFLE_VECTOR, RIFFLE_ACCUMULATES, "m.s-2", "rate of change of velocity, drag excluded")        \
  X(drag_rate, RIFFLE_SCALAR, RIFFLE_ACCUMULATES | RIFFLE_NOT_NEGATIVE, "s-1",                                    \
    "lambda in du/dt = -lambda u; friction and drag are rates, so they can only dissipate")                       \
  X(smoothing_length, RIFFLE_SCALAR, 0, "m", "l of the kernel; the support radius is kappa l")                    \
  X(cell_measure, RIFFLE_SCALAR, 0, "md",                                                                         \
    "length, area or volume of the domain that the particle stands for at t = 0")                                 \
  X(depth, RIFFLE_SCALAR, 0, "m", "water depth h, normal to the bed in shallow-water sets")                       \
  X(volume, RIFFLE_SCALAR, 0, "m.md", "water carried by a shallow-water particle: depth times length or area")    \
  X(extent, RIFFLE_SCALAR, 0, "md", "length or area that a shallow-water particle stands for: volume over depth") \
  X(momentum, RIFFLE_VECTOR, 0, "m2.md.s-1", "volume times velocity, in sets that evolve it")                     \
  X(mass, RIFFLE_SCALAR, 0, "kg.m-3.md", "mass carried by a particle")                                            \
  X(density, RIFFLE_SCALAR, 0, "kg.m-3", "density of the water")                                                  \
  X(density_rate, RIFFLE_SCALAR, RIFFLE_ACCUMULATES, "kg.m-3.s-1", "rate of change of density")                   \
  X(pressure, RIFFLE_SCALAR, 0, "kg.m-1.s-2", "pressure above the atmosphere, positive in compression")           \
  X(wave_speed, RIFFLE_SCALAR, 0, "m.s-1", "speed of small waves: sqrt(g h), or the speed of sound")              \
  X(bed_level, RIFFLE_SCALAR, 0, "m", "level of the bed, positive upwards")                                       \
  X(bed_slope, RIFFLE_VECTOR, 0, "1", "gradient of bed_level, positive where the bed rises along the axis")       \
  X(smoothed_bed_level, RIFFLE_SCALAR, 0, "m",                                                                    \
    "bed averaged with the particle's kernel, as a summation depth sees it")                                      \
  X(smoothed_bed_slope, RIFFLE_VECTOR, 0, "1", "gradient of smoothed_bed_level")                                  \
  X(smoothed_bed_curvature, RIFFLE_SCALAR, 0, "m-1", "slope of smoothed_bed_slope, along a channel")              \
  X(water_level, RIFFLE_SCALAR, 0, "m", "level of the free surface: bed_level + depth")                           \
  X(channel_width, RIFFLE_SCALAR, 0, "m", "width B of the channel")                                               \
  X(width_slope, RIFFLE_SCALAR, 0, "1", "dB/dx: positive where the channel widens along x")                       \
  X(porosity, RIFFLE_SCALAR, RIFFLE_NOT_NEGATIVE, "1", "share of the space open to water, 0 < phi <= 1")          \
  X(velocity_gradient, RIFFLE_TENSOR, 0, "s-1", "du_a/dx_b, row a, column b")                                     \
  X(strain_rate, RIFFLE_SCALAR, RIFFLE_NOT_NEGATIVE, "s-1", "|S| = sqrt(2 S:S)")                                  \
  X(eddy_viscosity, RIFFLE_SCALAR, RIFFLE_NOT_NEGATIVE, "m2.s-1", "kinematic eddy viscosity nu_t")                \
  X(wall_distance, RIFFLE_SCALAR, 0, "m", "distance to the nearest wall particle or mirror plane")                \
  X(local_depth, RIFFLE_SCALAR, 0, "m", "depth of the water column that the particle stands in (vertical plane)") \
  X(neighbour_count, RIFFLE_SCALAR, 0, "1", "neighbours within the support, the particle itself excluded")        \
  X(nearest_spacing, RIFFLE_SCALAR, 0, "m", "distance to the nearest neighbour")                                  \
  X(kernel_sum, RIFFLE_SCALAR, 0, "1", "sum over j, itself included, of (cell volume of j) W")

#define RIFFLE_PAIR_FIELDS(X)                                                                                      \
  X(separation, RIFFLE_VECTOR, RIFFLE_PER_PAIR, "m", "x_i - x_j")                                                  \
  X(distance, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m", "r = |x_i - x_j|; 0 for the pair of a particle with itself")    \
  X(distance_squared, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m2", "r^2")                                                 \
  X(approach, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m2.s-1", "(u_i - u_j) . (x_i - x_j); negative when approaching")    \
  X(kernel, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m-d", "W(r, l)")                                                      \
  X(kernel_gradient, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m-d.m-2", "F = (dW/dr)/r <= 0: grad_i W = F (x_i - x_j)")    \
  X(kernel_dl, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m-d.m-1", "dW/dl")                                                 \
  X(kernel_drr, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m-d.m-2", "d2W/dr2")                                              \
  X(kernel_drdl, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m-d.m-2", "d2W/(dr dl)")                                         \
  X(kernel_dldl, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m-d.m-2", "d2W/dl2")                                             \
  X(viscous_pressure, RIFFLE_SCALAR, RIFFLE_PER_PAIR, "m2.s-2",                                                    \
    "Pi_ij times the pair-mean density (or depth): >= 0 when approaching, symmetric in i and j; the equation set " \
    "divides by its own pair-mean density or depth")

#endif /* RIFFLE_FIELDS_H */
