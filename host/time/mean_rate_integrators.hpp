// Integrators that advance from the start of the step with a mean of the rates seen so far: the strong-stability-preserving
// Runge-Kutta schemes, and velocity Verlet with a predictor.
//
// Every stage is one Euler step over a part of the step with the mean rate and the mean damping of the stages before it.
// With a damping lambda that step is, with k = dt lambda,
//
//   u = u0 + (dt a - k u0) (1 + k/2) / (1 + k + k^2/2)
//
// which is of second order for du/dt = a - lambda u, tends to a / lambda for stiff damping, and stays exactly where a =
// lambda u already: uniform flow with friction is kept to round-off, as neither splitting nor damping stage by stage do.
#pragma once

#include <memory>

#include "host/time/integrator.hpp"

namespace riffle {

// `order` 2 or 3. Third order holds for what is not damped; damped fields are of second order.
std::unique_ptr<Integrator> make_ssp_runge_kutta(int order, const Graph& graph, ParticleStore& store,
                                                 bool drag_implicit);
std::unique_ptr<Integrator> make_predictor_verlet(const Graph& graph, ParticleStore& store, bool drag_implicit);

}  // namespace riffle
