// Fields that begin as the reference of the case has them at t = 0: initial.velocity = "reference".
#pragma once

#include "host/manifest/case.hpp"
#include "host/plugins/registry.hpp"
#include "riffle/abi.h"

namespace riffle {

// Makes functions of scene.initial of what scene.initial_from_reference names; 0 where the reference is not defined. Throws
// PluginError when the reference refuses the scene.
void begin_with_reference(Case& scene, const Registry& registry, const riffle_services& services);

}  // namespace riffle
