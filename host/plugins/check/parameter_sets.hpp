// Sets of parameters to try a plugin with, all of them allowed by its own ranges.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "host/plugins/instance.hpp"

namespace riffle::check {

struct ParameterSet {
  std::string name;  // "alpha = 100", for messages
  std::vector<ParameterValue> values;
};

// Defaults but for one parameter, which is at one of its bounds or is another of its choices. An excluded bound is
// approached to a thousandth of the way from the default.
std::vector<ParameterSet> bounds_of(const PluginDescription& description);

// Every number anywhere in its range, every choice any of its words.
ParameterSet random_set(const PluginDescription& description, std::mt19937_64& random);

// The manifest must give something: there is no set of defaults.
bool needs_values(const PluginDescription& description);

}  // namespace riffle::check
