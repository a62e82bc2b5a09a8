#include "host/bench/fused_best.hpp"

#include <cmath>
#include <cstdlib>
#include <new>

namespace riffle::bench {

namespace {

typedef double v4 __attribute__((vector_size(32), may_alias));

inline v4 all(double value) {
  return v4{value, value, value, value};
}

// One instruction each; written with the vector extensions, GCC 12 makes two or more of them.
#if defined(__AVX__)
inline v4 root(v4 value) {
  return __builtin_ia32_sqrtpd256(value);
}
inline v4 positive(v4 value) {
  return __builtin_ia32_maxpd256(value, all(0));
}
inline v4 negative(v4 value) {
  return __builtin_ia32_minpd256(value, all(0));
}
#else
inline v4 root(v4 value) {
  return v4{std::sqrt(value[0]), std::sqrt(value[1]), std::sqrt(value[2]), std::sqrt(value[3])};
}
inline v4 positive(v4 value) {
  return value > 0 ? value : all(0);
}
inline v4 negative(v4 value) {
  return value < 0 ? value : all(0);
}
#endif

// Rows to columns.
inline void transpose(v4& a, v4& b, v4& c, v4& d) {
  const v4 ab_low = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_high = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const v4 cd_low = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_high = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7);
}

}  // namespace

void FusedBest::Free::operator()(double* p) const {
  std::free(p);
}

FusedBest::FusedBest(const BenchState& state)
    : state_(state),
      record_(static_cast<double*>(std::aligned_alloc(64, static_cast<std::size_t>(state.particles + 1) * 64))) {
  if (record_ == nullptr) throw std::bad_alloc();
}

void FusedBest::operator()(BenchRates& rates) {
  const BenchState& s = state_;
  const Physics& physics = s.physics;
  const double kernel = physics.kernel_factor();
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    double* record = record_.get() + 8 * i;
    record[0] = s.x[i];
    record[1] = s.z[i];
    record[2] = s.u[i];
    record[3] = s.w[i];
    record[4] = s.density[i];
    record[5] = s.pressure[i];
    record[6] = s.mass[i] / s.density[i] * kernel;
    record[7] = 0;
  }
  // the dummy: far away, without volume, so that it contributes exactly 0
  const double dummy[8] = {1e3, 1e3, 0, 0, physics.reference_density, 0, 0, 0};
  for (std::size_t k = 0; k < 8; ++k) record_[8 * s.x.size() + k] = dummy[k];

  const v4* record = reinterpret_cast<const v4*>(record_.get());
  const auto at = [record](std::int32_t j) {
    return record + 2 * static_cast<std::size_t>(static_cast<std::uint32_t>(j));
  };
  const v4 inverse_support = all(1 / physics.support()), eta2 = all(physics.eta2());
  const v4 viscosity = all(physics.viscosity_factor()), diffusivity = all(physics.diffusion_factor());
  const std::int32_t* neighbour = s.list.neighbour.data();
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    const double* own = record_.get() + 8 * i;
    const v4 xi = all(own[0]), zi = all(own[1]), ui = all(own[2]), wi = all(own[3]);
    const v4 density_i = all(own[4]), pressure_i = all(own[5]);
    v4 acceleration_x = all(0), acceleration_z = all(0), density_rate = all(0);
    for (std::int64_t k = s.list.begin[i]; k < s.list.begin[i + 1]; k += 4) {
      const v4 *a = at(neighbour[k]), *b = at(neighbour[k + 1]);
      const v4 *c = at(neighbour[k + 2]), *d = at(neighbour[k + 3]);
      v4 x = a[0], z = b[0], u = c[0], w = d[0];
      transpose(x, z, u, w);
      v4 density = a[1], pressure = b[1], volume = c[1], unused = d[1];
      transpose(density, pressure, volume, unused);

      const v4 dx = x - xi, dz = z - zi;  // j minus i throughout: i is the operand in memory
      const v4 r2 = dx * dx + dz * dz;
      const v4 q = positive(1 - root(r2) * inverse_support);
      const v4 f = q * q * q;
      const v4 vx = (u - ui) * dx + (w - wi) * dz;
      const v4 vf = volume * f;
      const v4 force = (pressure + pressure_i + viscosity * negative(vx) / (r2 + eta2)) * vf;
      acceleration_x += force * dx;
      acceleration_z += force * dz;
      density_rate += vf * (density_i * vx + diffusivity * (density_i - density));
    }
    v4 unused = all(0);
    transpose(acceleration_x, acceleration_z, density_rate, unused);
    const v4 sum = (acceleration_x + acceleration_z) + (density_rate + unused);
    rates.acceleration_x[i] = sum[0] / own[4];
    rates.acceleration_z[i] = sum[1] / own[4];
    rates.density_rate[i] = sum[2];
  }
}

}  // namespace riffle::bench
