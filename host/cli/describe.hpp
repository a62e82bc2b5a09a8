// A plugin's description as text.
#pragma once

#include <string>

#include "host/plugins/registry.hpp"

namespace riffle {

// `id` or "kind/id". Prints and returns the exit code.
int describe_plugin(const Registry& registry, const std::string& id);

}  // namespace riffle
