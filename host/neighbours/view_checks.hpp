// What every part of the search asks of a particle view: roles, reaches, and the sentences for particles that cannot
// be searched.
#pragma once

#include <cstdint>
#include <string>

#include "host/neighbours/neighbours.hpp"

namespace riffle {

inline bool has_role(const ParticleView& particles, std::uint32_t mask, std::int64_t i) {
  return ((mask >> (particles.role == nullptr ? 0 : particles.role[i])) & 1u) != 0;
}

inline double smoothing_length(const ParticleView& particles, std::int64_t i) {
  return particles.l == nullptr ? particles.uniform_l : particles.l[i];
}

// True when all smoothing lengths are one number, so that all reaches mean the same.
inline bool uniform_reach(const ParticleView& particles) {
  return particles.l == nullptr;
}

// "particle 17 at (0.1, 0.2)", or "image particle ..."
std::string name_of(const ParticleView& particles, std::int64_t i);

// Throws std::runtime_error if a position is not finite, or a smoothing length not finite or negative, naming the first
// such particle.
void require_searchable(const ParticleView& particles);

[[noreturn]] void throw_too_many_neighbours(const ParticleView& particles, std::int64_t i);

}  // namespace riffle
