#include "host/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace riffle {
namespace {

[[noreturn]] void fail(const char* what, const std::filesystem::path& path, int error) {
  throw std::runtime_error(std::string("cannot ") + what + " " + path.string() + ": " + std::strerror(error));
}

class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }
  // Closing can report a write that failed late (network file systems), so it is not left to the destructor.
  [[nodiscard]] bool close() { return ::close(std::exchange(number_, -1)) == 0; }

 private:
  int number_;
};

void flush_file(const std::filesystem::path& path) {
  const Descriptor file(path, O_RDONLY);
  if (file.number() < 0 || ::fsync(file.number()) != 0) fail("write", path, errno);
}

}  // namespace

PartFile::PartFile(std::filesystem::path final_path) : final_(std::move(final_path)), part_(final_) {
  part_ += ".part";
}

PartFile::~PartFile() {
  std::error_code ignored;
  if (!published_) std::filesystem::remove(part_, ignored);
}

void PartFile::write(std::string_view content) const {
  Descriptor out(part_, O_WRONLY | O_CREAT | O_TRUNC);
  if (out.number() < 0) fail("write", part_, errno);
  while (!content.empty()) {
    const ssize_t written = ::write(out.number(), content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail("write", part_, errno);
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  if (!out.close()) fail("write", part_, errno);
}

void PartFile::publish() {
  flush_file(part_);
  if (::rename(part_.c_str(), final_.c_str()) != 0) fail("write", final_, errno);
  published_ = true;
  flush_folder(final_.parent_path());
}

void PartFile::publish_keeping(const std::filesystem::path& older) {
  flush_file(part_);
  if (::renameat2(AT_FDCWD, part_.c_str(), AT_FDCWD, final_.c_str(), RENAME_EXCHANGE) == 0) {
    published_ = true;
    if (::rename(part_.c_str(), older.c_str()) != 0) fail("write", older, errno);
    return flush_folder(final_.parent_path());
  }
  // There was no file of that name, or the file system cannot exchange two: then `older` has it for a moment.
  if (::rename(final_.c_str(), older.c_str()) != 0 && errno != ENOENT) fail("write", older, errno);
  publish();
}

void write_atomically(const std::filesystem::path& path, std::string_view content) {
  PartFile file(path);
  file.write(content);
  file.publish();
}

void flush_folder(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder.empty() ? std::filesystem::path(".") : folder;
  const Descriptor handle(path, O_RDONLY | O_DIRECTORY);
  if (handle.number() < 0) fail("open the folder", path, errno);
  // Some network file systems cannot flush folders; the rename is atomic there all the same.
  if (::fsync(handle.number()) != 0 && errno != EINVAL && errno != ENOTSUP) fail("write to the folder", path, errno);
}

std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) fail("read", path, errno);
  std::string content{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad()) fail("read", path, errno);
  return content;
}

}  // namespace riffle
