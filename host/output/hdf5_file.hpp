// The little of HDF5 that Riffle needs: groups, datasets of numbers and text, attributes; closed by scope, and one
// sentence instead of a stack of messages when something fails. Not part of the public face of host/output.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace riffle::hdf5 {

class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Owns one HDF5 identifier of any kind.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(id), close_(close) {
    if (id < 0) throw Error(std::string("HDF5 cannot ") + what);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  [[nodiscard]] hid_t id() const { return id_; }
  // For what buffers writes: an error that shows only here is not lost.
  void close();

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// While one lives, HDF5 prints nothing; its errors arrive as exceptions.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

// A file in memory, written out in one go by the caller, so that a full disk is an ordinary error of ours and never
// HDF5's, which cannot close a file that it cannot flush.
class MemoryFile {
 public:
  MemoryFile();
  [[nodiscard]] hid_t id() const { return file_.id(); }
  // The bytes of the file, after `room` zero bytes for a header of the caller's.
  [[nodiscard]] std::string image(std::size_t room = 0) const;

 private:
  Handle file_;
};

// A file, read only, whose bytes are in memory.
Handle open_image(std::string_view bytes);
Handle create_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);

// `width` 0: a list of values; otherwise rows of `width`. `packed` compresses: for whole numbers that follow a pattern.
void write(hid_t group, const std::string& name, std::span<const double> values, hsize_t width = 0);
void write(hid_t group, const std::string& name, std::span<const std::int64_t> values, bool packed = false);
void write(hid_t group, const std::string& name, std::span<const std::uint8_t> values, bool packed = false);
void write_attribute(hid_t group, const std::string& name, std::span<const std::int64_t> values);
void write_attribute(hid_t group, const std::string& name, const std::string& text);  // fixed length, ASCII

// Throw Error when absent, of another type, of rank other than 1, or longer than `most` values.
std::vector<double> read_reals(hid_t group, const std::string& name, std::uintmax_t most);
std::vector<std::int64_t> read_integers(hid_t group, const std::string& name, std::uintmax_t most);
std::vector<std::uint8_t> read_bytes(hid_t group, const std::string& name, std::uintmax_t most);

// Names of all members of a group, in the order of the alphabet.
std::vector<std::string> names(hid_t group);

}  // namespace riffle::hdf5
