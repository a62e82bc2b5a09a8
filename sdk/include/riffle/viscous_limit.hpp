// riffle/viscous_limit.hpp: the vote of viscosities whose pressure is alpha c w, w the speed at which a pair closes.
//
// dt <= 0.5 l / (alpha c), and 0.4 where parting pairs are damped, too. Measured with swe-variational on a dam break of
// depth ratio 0.1: stable at 0.5 and 0.4, not at 0.6 and 0.45. It is the limit of an explicit viscosity, so it does not
// scale with cfl. A plugin derives from it and has the members `alpha` and `parting`.
#pragma once

#include "riffle/sdk.hpp"

namespace riffle {

template <class Plugin>
struct ViscousLimit {
  static constexpr auto name = "viscous";
  static constexpr std::uint32_t scaled = 0;
  static constexpr riffle_read reads[] = {at_i(fields::smoothing_length), at_i(fields::wave_speed)};
  static double limit(const Plugin& plugin, const Block& b) {
    const double *l = b.in(0), *c = b.in(1);
    double least = infinity;
    RIFFLE_EACH_LEAST(k, b, least) least = l[k] < least * c[k] ? l[k] / c[k] : least;
    return (plugin.parting ? 0.4 : 0.5) * least / plugin.alpha;
  }
};

}  // namespace riffle
