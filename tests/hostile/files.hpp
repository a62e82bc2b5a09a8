// Finding the hostile libraries, and folders of the test's own.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace riffle::hostile {

inline std::filesystem::path library(const std::string& name) {
  return std::filesystem::path(RIFFLE_HOSTILE_PLUGINS) / (name + ".so");
}

// What a message says without the folders: paths differ from machine to machine.
inline std::string without_folder(std::string text, const std::filesystem::path& folder = RIFFLE_HOSTILE_PLUGINS) {
  const std::string prefix = folder.string() + "/";
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
    text.erase(at, prefix.size());
  return text;
}

// A new folder, removed with everything in it at the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "riffle-XXXXXX").string();
    path_ = std::filesystem::canonical(mkdtemp(name.data()));
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  // Copies a hostile library here, under another name if given; returns its new path.
  std::filesystem::path take(const std::string& name, const std::string& as = "") const {
    const std::filesystem::path to = path_ / ((as.empty() ? name : as) + ".so");
    std::filesystem::copy_file(library(name), to);
    return to;
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace riffle::hostile
