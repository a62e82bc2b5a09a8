// Where runs go that nobody keeps.
#pragma once

#include <filesystem>

namespace riffle {

// A folder of its own, gone with its contents when the runs have been read.
class TemporaryFolder {
 public:
  // Throws std::runtime_error when none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace riffle
