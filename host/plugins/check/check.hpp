// `riffle check`: everything about a plugin library that can be seen without knowing its physics.
#pragma once

#include <chrono>
#include <filesystem>
#include <iosfwd>

namespace riffle {

// Runs all checks on all plugins of the library, each in a child process with a limit of its own, and writes a line per
// check: "ok", "FAIL" with the reason, or "slow" and the like as a warning. 0 when none failed, else 1. The library is
// never loaded into this process, which must have one thread. `limit` is the longest that one check may take.
int check_library(const std::filesystem::path& file, std::ostream& out,
                  std::chrono::milliseconds limit = std::chrono::seconds(20));

}  // namespace riffle
