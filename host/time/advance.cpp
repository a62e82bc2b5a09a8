#include "host/time/advance.hpp"

#include <algorithm>
#include <cmath>

namespace riffle {

namespace {

// The particles of the given roles: work(first, last) returns 0, or NaN when a value is not finite.
template <class Work>
bool over_roles(const ParticleStore& store, std::uint32_t roles, const Work& work) {
  bool finite = true;
  for (int role = 0; role < role_count; ++role) {
    if ((roles & (1u << role)) == 0) continue;
    const std::int64_t first = store.role_begin(role), last = store.role_begin(role + 1);
    if (first != last) finite = work(first, last) == 0 && finite;
  }
  return finite;
}

// to = formula(from, rate, damping), damping being a scalar; false when a result is not finite.
template <class Formula>
bool each_value(ParticleStore& store, const std::string& to, const std::string& from, const std::string& rate,
                const std::string& damping, std::uint32_t roles, const Formula& formula) {
  bool finite = true;
  Field& target = store.at(to);
  const double* lambda = store.data(damping);
  for (std::size_t c = 0; c < target.component.size(); ++c) {
    double* x = target.component[c].data();
    const double* x0 = store.at(from).component[c].data();
    const double* v = store.at(rate).component[c].data();
    const auto work = [=](std::int64_t first, std::int64_t last) {
      double bad = 0;  // a sum of x - x: 0, or NaN as soon as one value is not finite
#pragma omp parallel for simd schedule(static) reduction(+ : bad)
      for (std::int64_t i = first; i < last; ++i) {
        const double moved = formula(x0[i], v[i], lambda[i]);
        x[i] = moved;
        bad += moved - moved;
      }
      return bad;
    };
    finite = over_roles(store, roles, work) && finite;
  }
  return finite;
}

}  // namespace

bool advance(ParticleStore& store, const std::string& to, const std::string& from, const std::string& rate,
             const std::string& damping, bool implicit, double dt, std::uint32_t roles) {
  if (damping.empty()) {  // without a division: most scenes have no drag
    return each_value(store, to, from, rate, rate, roles, [dt](double x0, double v, double) { return x0 + dt * v; });
  }
  if (implicit) {
    return each_value(store, to, from, rate, damping, roles,
                      [dt](double x0, double v, double lambda) { return (x0 + dt * v) / (1 + dt * lambda); });
  }
  return each_value(store, to, from, rate, damping, roles,
                    [dt](double x0, double v, double lambda) { return x0 + dt * v - dt * lambda * x0; });
}

bool advance_damped(ParticleStore& store, const std::string& to, const std::string& from, const std::string& rate,
                    const std::string& damping, double dt, std::uint32_t roles) {
  if (damping.empty()) return advance(store, to, from, rate, "", true, dt, roles);
  return each_value(store, to, from, rate, damping, roles, [dt](double x0, double v, double lambda) {
    const double k = dt * lambda;
    return x0 + (dt * v - k * x0) * ((1 + 0.5 * k) / (1 + k * (1 + 0.5 * k)));
  });
}

void mix(ParticleStore& store, const std::string& mean, const std::string& value, double keep, double take,
         std::uint32_t roles) {
  Field& target = store.at(mean);
  for (std::size_t c = 0; c < target.component.size(); ++c) {
    double* m = target.component[c].data();
    const double* v = store.at(value).component[c].data();
    over_roles(store, roles, [&](std::int64_t first, std::int64_t last) {
#pragma omp parallel for simd schedule(static)
      for (std::int64_t i = first; i < last; ++i) m[i] = keep != 0 ? keep * m[i] + take * v[i] : take * v[i];
      return 0.0;
    });
  }
}

void mix_damping(ParticleStore& store, const std::string& mean, const std::string& damping, const std::string& value,
                 double take, std::uint32_t roles) {
  Field& target = store.at(mean);
  const double* lambda = store.data(damping);
  for (std::size_t c = 0; c < target.component.size(); ++c) {
    double* m = target.component[c].data();
    const double* v = store.at(value).component[c].data();
    over_roles(store, roles, [&](std::int64_t first, std::int64_t last) {
#pragma omp parallel for simd schedule(static)
      for (std::int64_t i = first; i < last; ++i) m[i] -= take * lambda[i] * v[i];
      return 0.0;
    });
  }
}

void copy_field(ParticleStore& store, const std::string& to, const std::string& from) {
  const auto n = store.owned();
  Field& target = store.at(to);
  for (std::size_t c = 0; c < target.component.size(); ++c) {
    std::copy_n(store.at(from).component[c].data(), n, target.component[c].data());
  }
}

}  // namespace riffle
