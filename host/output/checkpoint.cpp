#include "host/output/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cinttypes>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "host/output/atomic_file.hpp"
#include "host/output/hdf5_file.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

constexpr int format_version = 1;
constexpr std::size_t header_size = 512;  // HDF5 looks for its own beginning at 0, 512, 1024, ...
constexpr std::string_view magic = "riffle checkpoint\n";
constexpr const char* newest = "checkpoint.h5";
constexpr const char* previous = "checkpoint.previous.h5";

std::uint64_t crc64(std::string_view bytes) {
  // CRC-64/XZ (ECMA-182)
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0xFFFFFFFFFFFFFFFF, 0xFFFFFFFFFFFFFFFF, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

std::string header_of(std::string_view content) {
  std::string header =
      fmt::format("{}format {}\nbytes {}\ncrc64 {:016x}\n", magic, format_version, content.size(), crc64(content));
  header.resize(header_size, '\0');
  return header;
}

template <class T>
void write_lists(hid_t file, const char* group_name, const std::map<std::string, std::vector<T>>& lists) {
  const hdf5::Handle group = hdf5::create_group(file, group_name);
  for (const auto& [name, values] : lists) {
    if (name.empty() || name == "." || name.find('/') != std::string::npos) {
      throw std::logic_error("\"" + name + "\" cannot name a list of a checkpoint");
    }
    hdf5::write(group.id(), name, std::span<const T>(values));
  }
}

std::string bytes_of(const Checkpoint& checkpoint) {
  const hdf5::Silence silence;
  const hdf5::MemoryFile file;
  const auto* meta = reinterpret_cast<const std::uint8_t*>(checkpoint.meta.data());
  hdf5::write(file.id(), "meta", std::span<const std::uint8_t>(meta, checkpoint.meta.size()));
  write_lists(file.id(), "reals", checkpoint.reals);
  write_lists(file.id(), "integers", checkpoint.integers);
  std::string bytes = file.image(header_size);
  header_of(std::string_view(bytes).substr(header_size)).copy(bytes.data(), header_size);
  return bytes;
}

Checkpoint content_of(std::string_view image) {
  const hdf5::Silence silence;
  const hdf5::Handle file = hdf5::open_image(image);
  Checkpoint checkpoint;
  const auto meta = hdf5::read_bytes(file.id(), "meta", image.size());
  checkpoint.meta.assign(meta.begin(), meta.end());
  const hdf5::Handle reals = hdf5::open_group(file.id(), "reals");
  for (const std::string& name : hdf5::names(reals.id())) {
    checkpoint.reals[name] = hdf5::read_reals(reals.id(), name, image.size() / sizeof(double));
  }
  const hdf5::Handle integers = hdf5::open_group(file.id(), "integers");
  for (const std::string& name : hdf5::names(integers.id())) {
    checkpoint.integers[name] = hdf5::read_integers(integers.id(), name, image.size() / sizeof(std::int64_t));
  }
  return checkpoint;
}

[[noreturn]] void damaged(const fs::path& path, const std::string& how) {
  throw std::runtime_error(fmt::format("the checkpoint {} is damaged: {}", path.string(), how));
}

}  // namespace

void write_checkpoint(const fs::path& path, const Checkpoint& checkpoint) {
  write_atomically(path, bytes_of(checkpoint));
}

Checkpoint read_checkpoint(const fs::path& path) {
  if (!fs::exists(path)) throw std::runtime_error("there is no checkpoint " + path.string());
  if (!fs::is_regular_file(path)) throw std::runtime_error(path.string() + " is not a checkpoint of riffle");
  const std::string bytes = read_file(path);
  const auto known = std::min(bytes.size(), magic.size());
  if (bytes.compare(0, known, magic.substr(0, known)) != 0) {
    throw std::runtime_error(path.string() + " is not a checkpoint of riffle");
  }
  if (bytes.size() < header_size) damaged(path, fmt::format("it ends after {} bytes", bytes.size()));
  int format = 0;
  std::uint64_t size = 0, crc = 0;
  const std::string numbers = bytes.substr(magic.size(), header_size - magic.size());
  if (std::sscanf(numbers.c_str(), "format %d bytes %" SCNu64 " crc64 %" SCNx64, &format, &size, &crc) < 1) {
    damaged(path, "its header is not readable");
  }
  if (format > format_version) {
    throw std::runtime_error(
        fmt::format("the checkpoint {} has format {}, and this riffle reads formats up to {}: use the "
                    "riffle that wrote it, or a newer one",
                    path.string(), format, format_version));
  }
  const std::string_view content = std::string_view(bytes).substr(header_size);
  if (content.size() != size) {
    damaged(path, fmt::format("it holds {} bytes where {} were written", content.size(), size));
  }
  if (bytes.compare(0, header_size, header_of(content)) != 0) {
    damaged(path, "it has changed since it was written (its checksum does not fit)");
  }
  try {
    return content_of(content);
  } catch (const hdf5::Error& error) {
    damaged(path, error.what());
  }
}

void save_checkpoint(const fs::path& folder, const Checkpoint& checkpoint) {
  PartFile fresh(folder / newest);
  fresh.write(bytes_of(checkpoint));
  fresh.publish_keeping(folder / previous);
}

LoadedCheckpoint load_checkpoint(const fs::path& folder) {
  std::string why;
  try {
    return {read_checkpoint(folder / newest), folder / newest, ""};
  } catch (const std::runtime_error& error) {
    why = error.what();
  }
  if (!fs::exists(folder / previous)) throw std::runtime_error(why);
  try {
    return {read_checkpoint(folder / previous), folder / previous, why + "; using the one before it"};
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(why + "; " + error.what());
  }
}

}  // namespace riffle
