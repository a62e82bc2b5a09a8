// The one arithmetic of all integrators: to = (from + dt rate) / (1 + dt damping), over the roles of an evolved field.
#pragma once

#include <string>

#include "host/schedule/evaluator.hpp"

namespace riffle {

// Fields by name in the store; `damping` empty: none. Implicit damping divides, explicit damping subtracts
// dt damping from. Returns false when a result is not finite.
bool advance(ParticleStore& store, const std::string& to, const std::string& from, const std::string& rate,
             const std::string& damping, bool implicit, double dt, std::uint32_t roles);

void copy_field(ParticleStore& store, const std::string& to, const std::string& from);

}  // namespace riffle
