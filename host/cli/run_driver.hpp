// `riffle run`: from a manifest to a run folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace riffle {

struct RunRequest {
  std::filesystem::path manifest;
  std::filesystem::path out;     // empty: runs/<case>-<n>
  std::filesystem::path resume;  // a run folder; then `manifest` is empty
  std::vector<std::filesystem::path> plugin_path;
  std::vector<std::string> overrides;
  int threads = 0;
  long block = 0, chunk = 0;  // 0: as the program chooses; results do not depend on them
  bool overwrite = false, quiet = false, strict = false;
};

// Returns the exit code; all messages are printed.
int run_case(const RunRequest& request);

}  // namespace riffle
