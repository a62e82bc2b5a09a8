// A run that cannot go on: one sentence that names the culprit. Everything already written stays.
#pragma once

#include <stdexcept>
#include <string>

namespace riffle {

class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace riffle
