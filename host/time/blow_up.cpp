#include "host/time/blow_up.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace riffle {

namespace {

// " at particle 17, x = 0.1 m, 0.2"
std::string place_of(const ParticleStore& store, std::int64_t i) {
  std::string text =
      fmt::format(" at particle {}, x = {:.4g}", store.ids()[static_cast<std::size_t>(i)], store.data("position")[i]);
  for (int c = 1; c < store.dim(); ++c)
    text += fmt::format(", {} = {:.4g}", c + 1 == store.dim() ? "z" : "y", store.data("position", c)[i]);
  return text + " m";
}

}  // namespace

void BlowUp::look(const ParticleStore& store, const Limit& limit, std::int64_t steps) {
  if (std::isfinite(limit.dt)) longest_ = std::max(longest_, limit.dt);
  if (limit.dt < shortest * longest_) {
    throw RunError(fmt::format("blown up: the time step has shrunk from {:.3g} s to {:.3g} s, limited by {}", longest_,
                               limit.dt, limit.name));
  }
  if (steps % interval == 0) look_at_speeds(store, limit);
}

void BlowUp::look_at_speeds(const ParticleStore& store, const Limit& limit) {
  const Field *velocity = store.find("velocity"), *waves = store.find("wave_speed");
  const std::int64_t n = store.role_begin(1);
  if (velocity == nullptr || waves == nullptr || waves->use != FieldUse::attribute || n == 0) return;
  const double sound = *std::max_element(waves->component[0].data(), waves->component[0].data() + n);
  double most = 0;
  std::int64_t where = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    double square = 0;
    for (const auto& component : velocity->component) square += component.data()[i] * component.data()[i];
    if (square > most) most = square, where = i;
  }
  const double speed = std::sqrt(most);
  if (speed <= of_sound * sound) return;
  throw RunError(
      fmt::format("blown up: the water moves at {:.3g} m/s{}, more than {:g} times the {:.3g} m/s of sound; the step "
                  "of {:.3g} s is limited by {}",
                  speed, place_of(store, where), of_sound, sound, limit.dt, limit.name));
}

}  // namespace riffle
