// What plugins of kind porosity share: the field `porosity` of water and walls as a function of place, written once at t = 0
// for the masses and then wherever a pass reads it. A plugin has `double porosity(const std::array<double, 3>& x) const`,
// whose x has as many entries as the scene has axes, and a member `riffle::PorousDomain domain`.
//
// Walls have the porosity of the nearest place within the domain: they continue the medium before them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "riffle/sdk.hpp"

namespace riffle {

struct PorousDomain {
  const riffle_services* services = nullptr;
  // The place itself, or the nearest one within the domain.
  [[nodiscard]] std::array<double, 3> within(std::array<double, 3> x, int dim) const {
    if (services == nullptr) return x;
    for (int a = 0; a < dim; ++a) {
      const auto k = static_cast<std::size_t>(a);
      const double little = 1e-9 * (services->high[a] - services->low[a]);
      x[k] = std::clamp(x[k], services->low[a] + little, services->high[a] - little);
    }
    return x;
  }
};

inline double checked_porosity(double phi, const std::array<double, 3>& x, int dim) {
  if (phi > 0 && phi <= 1) return phi;
  std::ostringstream text;
  text << "porosity must be above 0 and at most 1, got " << phi << " at x = " << x[0]
       << " m, z = " << x[static_cast<std::size_t>(dim - 1)] << " m";
  throw std::invalid_argument(text.str());
}

template <class Plugin>
struct PorosityPass {
  static constexpr auto pass_name = "porosity";
  static constexpr std::uint32_t targets = RIFFLE_ALL_ROLES & ~RIFFLE_PROBE;
  static constexpr riffle_read reads[] = {at_i(fields::position)};
  static constexpr riffle_write writes[] = {set(fields::porosity)};
  static void run(const Plugin& s, const Block& b) {
    std::array<double, 3> x{};
    for (std::int64_t k = 0; k < b.size(); ++k) {
      for (int c = 0; c < b.dim(); ++c) x[static_cast<std::size_t>(c)] = b.in(0, c)[k];
      const auto here = s.domain.within(x, b.dim());
      b.out(0)[k] = checked_porosity(s.porosity(here), here, b.dim());
    }
  }
};
template <class Plugin>
struct InitialPorosityPass : PorosityPass<Plugin> {
  static constexpr auto pass_name = "porosity at t = 0";
  static constexpr std::uint32_t pass_flags = RIFFLE_INITIAL;
};
template <class Plugin>
using PorosityPasses = Passes<PorosityPass<Plugin>, InitialPorosityPass<Plugin>>;

}  // namespace riffle
