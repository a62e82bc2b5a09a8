// What stopped a group of pair passes.
#pragma once

#include <string>

namespace riffle {

struct GroupFailure {
  int node = -1;        // the pass, -1: none in particular
  std::string message;  // empty: all is well
};

}  // namespace riffle
