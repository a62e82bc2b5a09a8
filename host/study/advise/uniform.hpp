// Whether a scene is the same everywhere along x.
#pragma once

#include "host/manifest/case.hpp"

namespace riffle {

// Nothing in the scene knows where along x it is: water that leaves at one end enters at the other, and no function of the
// case depends on x.
bool uniform_along_x(const Case& scene);

}  // namespace riffle
