#include <fmt/format.h>

#include <cmath>
#include <random>

#include "host/plugins/check/checks.hpp"
#include "host/plugins/check/parameter_sets.hpp"
#include "host/plugins/contracts.hpp"
#include "host/plugins/instance.hpp"

namespace riffle::check {

Findings check_creation(const Plugin& plugin) {
  const PluginDescription& description = plugin.description;
  Findings findings;
  std::mt19937_64 random(1);
  int created = 0, refused = 0;
  for (const int dim : description.dimensions) {
    const auto attempt = [&](const ParameterSet& set) {
      try {
        const PluginInstance instance(plugin, dim, set.values);
        ++created;
      } catch (const PluginError& error) {
        // Ranges are per parameter; a plugin may refuse a combination, if it says why.
        ++refused;
        const std::string text = error.what();
        if (text.ends_with("it gave no reason")) findings.fail(fmt::format("refuses {} without a reason", set.name));
        if (text.find("an exception left") != std::string::npos || text.find("floating-point") != std::string::npos) {
          findings.fail(fmt::format("with {}: {}", set.name, text));
        }
      }
    };
    if (!needs_values(description)) {
      const PluginInstance at_defaults(plugin, dim, default_values(description));  // its message is the finding
    }
    attempt({"its defaults", default_values(description)});
    for (const ParameterSet& set : bounds_of(description)) attempt(set);
    for (int k = 0; k < 50; ++k) attempt(random_set(description, random));
    if (!findings.failures.empty()) break;
  }
  if (created == 0) findings.fail("refuses every set of parameters that was tried");
  findings.summary = fmt::format("created and destroyed {} times: defaults, bounds, random sets", created);
  if (refused > 0) findings.summary += fmt::format(" ({} refused with a reason)", refused);
  return findings;
}

Findings check_contract(const Plugin& plugin) {
  Findings findings;
  for (const int dim : plugin.description.dimensions) {
    const PluginInstance instance(plugin, dim, default_values(plugin.description));
    for (const std::string& line : contract_problems(instance)) findings.fail(fmt::format("{} in {}D", line, dim));
  }
  findings.summary = "what its kind owes, at its defaults";
  return findings;
}

Findings check_bounds(const Plugin& plugin) {
  Findings findings;
  const auto sets = bounds_of(plugin.description);
  for (const int dim : plugin.description.dimensions) {
    for (const ParameterSet& set : sets) {
      try {
        const PluginInstance instance(plugin, dim, set.values);
        for (const std::string& line : contract_problems(instance)) {
          findings.fail(fmt::format("with {}: {} in {}D", set.name, line, dim));
        }
      } catch (const PluginError&) {
        continue;  // refused: the check of creation has looked at that
      }
    }
  }
  findings.summary = sets.empty() ? "no parameter has bounds" : fmt::format("{} bounds of parameters", sets.size());
  return findings;
}

}  // namespace riffle::check
