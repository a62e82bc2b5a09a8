// Trying a combination without running it: the manifest's own checks, then plugins, contracts and schedule.
#pragma once

#include "host/plugins/registry.hpp"
#include "host/study/plan.hpp"

namespace riffle {

// Never throws for what is wrong with the combination; that is in Trial::refusals.
Trial attempt(const std::filesystem::path& manifest, const std::vector<std::string>& overrides,
              const Registry& registry);

}  // namespace riffle
