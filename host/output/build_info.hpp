// What ran, how it was built, and on what: recorded with every run.
#pragma once

#include <string>

namespace riffle {

std::string riffle_version();  // "0.1.0"
std::string riffle_build();    // "GCC 12.2.0, Release, native vector width"

struct Machine {
  std::string processor;  // model name, or "unknown"
  int cores = 0;          // that this process may use: fewer than the machine has, under a batch system
};
Machine this_machine();

}  // namespace riffle
