// What each kind owes, checked by the host before a run instead of trusted: a few calls on made-up numbers, under a
// millisecond per plugin.
//
//   kernel      W has the integral it claims; F <= 0; W and all outputs are exactly 0 from the support on; F and the
//               derivatives fit W; W = l^-d w(r / l)
//   viscosity   viscous_pressure is the same for (i, j) and (j, i) and never feeds kinetic energy:
//               viscous_pressure * approach <= 0
//   drag        drag_rate >= 0 and finite, also at rest
//   turbulence  eddy_viscosity >= 0 and finite, also at rest
//   reference   finite values, and scales that are finite and not negative, wherever it says it is defined
//   others      finite outputs
#pragma once

#include <string>
#include <vector>

#include "host/plugins/instance.hpp"

namespace riffle {

// The kinds of the first five lines, whose contract is demanded before each run; what equations, boundaries and filters
// make of made-up numbers is only looked at by `riffle check`. Beds and widths are looked at where the scene needs them.
bool has_contract(const std::string& kind);

// Sentences about what this instance breaks, each beginning with its kind and id; empty when all is well.
std::vector<std::string> contract_problems(const PluginInstance& instance);

// The parts of it for a kernel, and for every pass of any kind.
std::vector<std::string> kernel_problems(const PluginInstance& instance);
std::vector<std::string> pass_problems(const PluginInstance& instance);
std::vector<std::string> reference_problems(const PluginInstance& instance);

// A pass that the instance's parameters switch off (riffle_pass.when) is not run, so it owes nothing.
bool is_active(const PluginInstance& instance, const char* when);

}  // namespace riffle
