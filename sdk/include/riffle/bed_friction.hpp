// What the laws of bed friction share: they read velocity and depth, in this order, and add a rate that grows with the speed.
#pragma once

#include <cmath>
#include <cstdint>

#include "riffle/block.hpp"

namespace riffle {

// drag_rate += law(speed [m/s], depth [m]) [1/s] for each particle; reads velocity as in(0) and depth as in(1), adds to out(0).
template <class Law>
void add_bed_friction(const Block& b, Law law) {
  const double *u = b.in(0, 0), *v = b.dim() > 1 ? b.in(0, 1) : nullptr, *depth = b.in(1);
  double* rate = b.out(0);
  for (std::int64_t k = 0; k < b.size(); ++k) {
    rate[k] += law(v == nullptr ? std::abs(u[k]) : std::sqrt(u[k] * u[k] + v[k] * v[k]), depth[k]);
  }
}

}  // namespace riffle
