#include "host/time/advance.hpp"

#include <algorithm>
#include <cmath>

namespace riffle {

bool advance(ParticleStore& store, const std::string& to, const std::string& from, const std::string& rate,
             const std::string& damping, bool implicit, double dt, std::uint32_t roles) {
  bool finite = true;
  Field& target = store.at(to);
  const double* lambda = damping.empty() ? nullptr : store.data(damping);
  for (std::size_t c = 0; c < target.component.size(); ++c) {
    double* x = target.component[c].data();
    const double* x0 = store.at(from).component[c].data();
    const double* v = store.at(rate).component[c].data();
    for (int role = 0; role < role_count; ++role) {
      if ((roles & (1u << role)) == 0) continue;
      const std::int64_t first = store.role_begin(role), last = store.role_begin(role + 1);
      if (first == last) continue;
      double bad = 0;  // a sum of x - x: 0, or NaN as soon as one value is not finite
#pragma omp parallel for simd schedule(static) reduction(+ : bad)
      for (std::int64_t i = first; i < last; ++i) {
        const double k = lambda != nullptr ? dt * lambda[i] : 0.0;
        const double moved = implicit ? (x0[i] + dt * v[i]) / (1 + k) : x0[i] + dt * v[i] - k * x0[i];
        x[i] = moved;
        bad += moved - moved;
      }
      finite = finite && bad == 0;
    }
  }
  return finite;
}

void copy_field(ParticleStore& store, const std::string& to, const std::string& from) {
  const auto n = store.owned();
  Field& target = store.at(to);
  for (std::size_t c = 0; c < target.component.size(); ++c) {
    std::copy_n(store.at(from).component[c].data(), n, target.component[c].data());
  }
}

}  // namespace riffle
