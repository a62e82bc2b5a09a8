// The buffer of an outflow in the vertical plane, as water that crosses the end makes it: riffle/open_end.hpp.
#pragma once

#include <cstdint>
#include <vector>

#include "riffle/open_end.hpp"

namespace riffle {

// Particles on the lattice beyond the end, of the density of water at rest below `level`. For `begin`.
inline std::vector<std::int64_t> fill_beyond(const OpenEnd& end, const riffle_editor& e, double level) {
  const double l = OpenEnd::spacing(e);
  std::vector<std::int64_t> buffer;
  for (double z = end.bed() + 0.5 * l; z < level; z += l) {
    const std::int64_t like = end.nearest(e, z);
    for (double out = 0.5 * l; out < OpenEnd::width(e); out += l) buffer.push_back(end.add(e, like, out, z));
  }
  const double *phi = e.read(e.context, "porosity", 0), *z = OpenEnd::read(e, "position", 1);
  double *rho = e.write(e.context, "density", 0), *mass = e.write(e.context, "mass", 0);
  for (const std::int64_t k : buffer) {
    rho[k] = end.density(e, level - z[k]);
    mass[k] = (phi != nullptr ? phi[k] : 1) * l * l * rho[k];
  }
  return buffer;
}

// Water beyond the end becomes buffer, buffer inside becomes water, and what nobody inside sees any more is taken out, all at
// once when the first is half a spacing beyond. Returns the buffer; `crossed`: whether roles changed.
inline std::vector<std::int64_t> pass_beyond(const OpenEnd& end, const riffle_editor& e, std::uint32_t role,
                                             bool& crossed) {
  crossed = end.due(e, RIFFLE_FLUID, false) || end.due(e, role, true);
  const double *x = OpenEnd::read(e, "position", 0), *z = OpenEnd::read(e, "position", 1), width = OpenEnd::width(e);
  std::vector<std::int64_t> buffer;
  for (std::int64_t k = 0; k < e.count; ++k) {
    const double inside = end.inside_by(x[k]);
    if (end.is_buffer(e, k)) {
      if (crossed && inside < -width)
        e.remove(e.context, k);
      else if (crossed && inside >= 0)
        e.retag(e.context, k, RIFFLE_FLUID);
      else
        buffer.push_back(k);
    } else if (crossed && e.role[k] == RIFFLE_FLUID && inside < 0) {
      if (end.is_floor(z[k])) {
        e.remove(e.context, k);
        continue;
      }
      e.retag(e.context, k, role);
      buffer.push_back(k);
    }
  }
  return buffer;
}

}  // namespace riffle
