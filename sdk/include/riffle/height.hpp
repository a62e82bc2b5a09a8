// Heights above a bed whose level is a parameter of the plugin (a constant, a formula, a table), for passes that read the
// position; z is up.
#pragma once

#include <cstddef>
#include <vector>

#include "riffle/block.hpp"

namespace riffle {

// z - b(x, y) [m] of each particle; `position` is the index of that read.
inline std::vector<double> heights_above(const riffle_function& bed_level, const Block& b, int position) {
  std::vector<double> height(static_cast<std::size_t>(b.size()));
  const double* z = b.in(position, b.dim() - 1);
  bed_level.evaluate(bed_level.context, b.size(), b.in(position, 0), b.dim() == 3 ? b.in(position, 1) : nullptr,
                     nullptr, b.time(), height.data());
  for (std::size_t k = 0; k < height.size(); ++k) height[k] = z[k] - height[k];
  return height;
}

}  // namespace riffle
