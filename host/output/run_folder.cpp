#include "host/output/run_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "host/output/atomic_file.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

constexpr const char* marker_name = ".riffle-run";

// Every name that a run writes; overwriting removes these and nothing else.
constexpr std::array names_of_a_run{
    "run.json",    "log.txt",       "manifest.toml",         "snapshots.hdf.series", "snapshots",
    "profile.csv", "profiles",      "picture.svg",           "picture.png",          "picture.gp",
    "picture.dat", "checkpoint.h5", "checkpoint.previous.h5"};

std::string safe_name(const std::string& name) {
  std::string safe;
  for (const char c : name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_';
    safe += plain ? c : '-';
  }
  // Not hidden, and neither "." nor ".."
  if (safe.empty() || safe.front() == '.') safe.insert(0, "case");
  return safe;
}

// Number of the folder "<stem>-<n>", or 0
std::int64_t number_of(const std::string& folder, const std::string& stem) {
  if (folder.size() < stem.size() + 2 || folder.compare(0, stem.size(), stem) != 0 || folder[stem.size()] != '-')
    return 0;
  std::int64_t n = 0;
  const char* last = folder.data() + folder.size();
  const auto [end, error] = std::from_chars(folder.data() + stem.size() + 1, last, n);
  return error == std::errc() && end == last ? n : 0;
}

// Descriptor of the locked marker, which is made if needed. The lock goes with the process, however it dies.
int lock(const fs::path& folder) {
  const fs::path marker = folder / marker_name;
  const int descriptor = ::open(marker.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) {
    throw std::runtime_error(fmt::format("cannot write to the folder {}: {}", folder.string(), std::strerror(errno)));
  }
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(descriptor);
    throw std::runtime_error(
        fmt::format("{}: another riffle is writing to this folder; wait for it or give --out "
                    "another folder",
                    folder.string()));
  }
  return descriptor;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
}

void remove_run(const fs::path& folder) {
  // The record goes first: it says that the rest is complete.
  for (const char* name : names_of_a_run) {
    fs::remove_all(folder / name);
    fs::remove(folder / (std::string(name) + ".part"));
  }
}

}  // namespace

RunFolder RunFolder::create_numbered(const fs::path& parent, const std::string& case_name) {
  make_folder(parent);
  const std::string stem = safe_name(case_name);
  std::int64_t n = 0;
  for (const auto& entry : fs::directory_iterator(parent)) {
    n = std::max(n, number_of(entry.path().filename().string(), stem));
  }
  for (;;) {
    const fs::path folder = parent / fmt::format("{}-{}", stem, ++n);
    std::error_code error;
    // False, without an error, when another run took the number between our look and now.
    if (fs::create_directory(folder, error)) return {folder, lock(folder)};
    if (error) throw std::runtime_error(fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  }
}

RunFolder RunFolder::create_at(const fs::path& folder, bool overwrite) {
  if (fs::exists(folder) && !fs::is_directory(folder)) {
    throw std::runtime_error(fmt::format("{}: --out needs a folder, this is a file", folder.string()));
  }
  make_folder(folder);
  const bool ours = fs::exists(folder / marker_name);
  if (!ours && !fs::is_empty(folder)) {
    throw std::runtime_error(
        fmt::format("{}: this folder holds files that are not of a riffle run; give --out a new or "
                    "an empty folder",
                    folder.string()));
  }
  const int descriptor = lock(folder);
  RunFolder run(folder, descriptor);
  const auto status = recorded_status(folder);
  if (ours && !overwrite && status) {
    throw std::runtime_error(
        fmt::format("{}: this folder holds a run that has ended (status \"{}\"); give --out another "
                    "folder, or --overwrite to replace it",
                    folder.string(), *status));
  }
  const bool begun = std::any_of(names_of_a_run.begin(), names_of_a_run.end(),
                                 [&](const char* name) { return fs::exists(folder / name); });
  if (ours && !overwrite && begun) {
    throw std::runtime_error(
        fmt::format("{}: this folder holds a run that has not ended; continue it with --resume, give "
                    "--out another folder, or --overwrite to replace it",
                    folder.string()));
  }
  remove_run(folder);
  return run;
}

RunFolder RunFolder::reopen(const fs::path& folder) {
  if (!fs::is_directory(folder)) {
    throw std::runtime_error(
        fmt::format("{}: --resume needs the folder of a run, there is no such folder", folder.string()));
  }
  if (!fs::exists(folder / marker_name)) {
    throw std::runtime_error(fmt::format("{}: --resume needs the folder of a run, this is not one", folder.string()));
  }
  return {folder, lock(folder)};
}

void RunFolder::forget_record() const {
  std::error_code error;
  fs::remove(record(), error);
  if (error) throw std::runtime_error(fmt::format("cannot remove {}: {}", record().string(), error.message()));
}

RunFolder::RunFolder(RunFolder&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

RunFolder::~RunFolder() {
  if (lock_ >= 0) ::close(lock_);
}

fs::path RunFolder::profile(std::int64_t number) const {
  make_folder(path_ / "profiles");
  return path_ / "profiles" / fmt::format("{:06}.csv", number);
}

std::optional<std::string> recorded_status(const fs::path& folder) {
  if (!fs::exists(folder / "run.json")) return std::nullopt;
  const auto record = nlohmann::json::parse(read_file(folder / "run.json"), nullptr, false);
  if (!record.is_object() || !record.contains("status") || !record["status"].is_string()) return std::nullopt;
  return record["status"].get<std::string>();
}

}  // namespace riffle
