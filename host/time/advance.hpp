// The arithmetic of all integrators, over the roles of an evolved field: to = (from + dt rate) / (1 + dt damping), and what
// schemes of higher order need beside it.
#pragma once

#include <string>

#include "host/schedule/evaluator.hpp"

namespace riffle {

// Fields by name in the store; `damping` empty: none. Implicit damping divides, explicit damping subtracts
// dt damping from. Returns false when a result is not finite.
bool advance(ParticleStore& store, const std::string& to, const std::string& from, const std::string& rate,
             const std::string& damping, bool implicit, double dt, std::uint32_t roles);

// The same to second order in the damping: to = from + (dt rate - k from) (1 + k/2) / (1 + k + k^2/2), k = dt damping.
bool advance_damped(ParticleStore& store, const std::string& to, const std::string& from, const std::string& rate,
                    const std::string& damping, double dt, std::uint32_t roles);

// mean = keep mean + take value; `keep` 0: whatever mean holds.
void mix(ParticleStore& store, const std::string& mean, const std::string& value, double keep, double take,
         std::uint32_t roles);
// mean -= take damping value: damping as a part of the rate.
void mix_damping(ParticleStore& store, const std::string& mean, const std::string& damping, const std::string& value,
                 double take, std::uint32_t roles);

void copy_field(ParticleStore& store, const std::string& to, const std::string& from);

}  // namespace riffle
