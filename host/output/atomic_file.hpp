// Files that are complete under their final name or not there at all: written aside as `<name>.part` in the same
// folder, flushed to the disk, then renamed. A program killed, or a disk full, at any moment leaves the old file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace riffle {

// A file under construction, for writers that open files by name (HDF5, gnuplot). Write to part(), close, publish().
// Without publish() the destructor removes what was written.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path final_path);
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  [[nodiscard]] const std::filesystem::path& part() const { return part_; }
  // Makes `content` the content of part(). This and the next throw std::runtime_error with one sentence.
  void write(std::string_view content) const;
  // Flushes part() to the disk and renames it to the final name.
  void publish();
  // The same, and the file that had the name so far gets the name `older`, without a moment at which none has it.
  void publish_keeping(const std::filesystem::path& older);

 private:
  std::filesystem::path final_, part_;
  bool published_ = false;
};

// Throws std::runtime_error: one sentence with the file and the system's reason; the old file is then untouched.
void write_atomically(const std::filesystem::path& path, std::string_view content);

// Makes the names in a folder durable, that is, the renames done in it.
void flush_folder(const std::filesystem::path& folder);

// The whole file. Throws std::runtime_error with one sentence.
std::string read_file(const std::filesystem::path& path);

}  // namespace riffle
