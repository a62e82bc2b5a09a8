// What the equation set `wcsph` shares with the walls, filters, turbulence closures and drags that work beside it.
//
// Sums are in volume form, so that a closure needs no density: it adds to the force per volume of a particle, or to the
// divergence of its velocity, and the equation set divides or multiplies by density once per particle.
//
//   drho_i/dt = rho_i D_i,           D_i = (1 / phi_i) sum_j V_j (phi_i u_i - phi_j u_j) . x_ij F
//   a_i       = f_i / rho_i + g,     f_i = - sum_j V_j (P_i + P_j) F x_ij + ...,      V_j = m_j / (phi_j rho_j)
//
// phi, the porosity, is 1 where no plugin of the scene gives one. Pair forces are antisymmetric where phi is even.
#pragma once

#include <cmath>

#include "riffle/fields.hpp"
#include "riffle/sdk.hpp"

namespace riffle::wc {

// Roles whose pressure follows from their density; walls and pistons have it too, by other means where a plugin says so.
inline constexpr std::uint32_t water = RIFFLE_FLUID | RIFFLE_INFLOW | RIFFLE_OUTFLOW;
inline constexpr std::uint32_t solid = RIFFLE_WALL | RIFFLE_PISTON;

inline constexpr riffle_field particle_volume =
    scalar_field("particle_volume", "md", "V = m / (phi rho); of walls m / rho");
inline constexpr riffle_field rest_volume =
    scalar_field("rest_volume", "md", "m / (phi rho0): the volume of a particle at rest density");
inline constexpr riffle_field pair_pressure = scalar_field(
    "pair_pressure", "kg.m-1.s-2", "pressure that particles push with: all of it, or what exceeds the hydrostatic one");
inline constexpr riffle_field velocity_divergence = scalar_field(
    "velocity_divergence", "s-1", "- (1 / phi) div(phi u), as the pairs of a particle sum it up", RIFFLE_ACCUMULATES);
inline constexpr riffle_field pair_force = vector_field(
    "pair_force", "kg.m-2.s-2", "force per volume of pressure and viscosity, summed over pairs", RIFFLE_ACCUMULATES);
inline constexpr riffle_field density_spread = scalar_field(
    "density_spread", "kg.m-3.s-1", "rate of density that filters exchange between particles", RIFFLE_ACCUMULATES);
inline constexpr riffle_field excess_density = scalar_field(
    "excess_density", "kg.m-3", "density plus rho0 g z / c0^2, which is even in water at rest under gravity");
inline constexpr riffle_field diffusing_volume =
    scalar_field("diffusing_volume", "md", "V of water, 0 of walls: what density may spread to");
inline constexpr riffle_field acoustic_diffusivity =
    scalar_field("acoustic_diffusivity", "m2.s-1", "l c0, in units of which density diffusion is given");
// A wall plugin may write it for walls and pistons: their pressure, instead of the one of their density.
inline constexpr riffle_field wall_pressure =
    scalar_field("wall_pressure", "kg.m-1.s-2", "pressure of a wall particle, continued from the water before it");
inline constexpr riffle_field eddy_stress = {
    sizeof(riffle_field), RIFFLE_SYMMETRIC, 0, 0, "eddy_stress", "kg.m-1.s-2", "2 rho0 nu_t S: tension positive"};
inline constexpr riffle_field body_force = vector_field(
    "body_force", "m.s-2", "gravity and what else drives the water, per mass; along a bed of slope S0 it is g S0");
inline constexpr riffle_field modelled_shear_stress =
    scalar_field("modelled_shear_stress", "kg.m-1.s-2", "rho (nu + nu_t) (du/dz + dw/dx)");
inline constexpr riffle_field virial_shear_stress = scalar_field(
    "virial_shear_stress", "kg.m-1.s-2",
    "shear stress that pressure forces between particles carry, 1/2 sum_j V_j (P_i + P_j) F x_ij z_ij: 0 in a fluid");

}  // namespace riffle::wc
