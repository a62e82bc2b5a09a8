// The porosity of a scene as a function of place, before there are particles: from the pass that its plugin has for them.
#pragma once

#include "host/particles/placement.hpp"
#include "host/plugins/instance.hpp"

namespace riffle {

// Empty where there is no plugin, or where it makes porosity of more than the position. In the vertical plane. What the
// plugin finds impossible, such as a porosity of 0, is thrown as std::runtime_error, one sentence.
PorosityAt porosity_of(const PluginInstance* plugin);

}  // namespace riffle
