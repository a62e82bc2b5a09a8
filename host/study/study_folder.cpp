#include "host/study/study_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "host/output/atomic_file.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

constexpr const char* marker = ".riffle-study";

nlohmann::json json_in(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return nullptr;
  return nlohmann::json::parse(stream, nullptr, false);
}

std::string last_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string last;
  for (std::string line; std::getline(stream, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return last;
}

std::string text_at(const nlohmann::json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

}  // namespace

std::string in_words(Ending ending) {
  switch (ending) {
    case Ending::good: return "finished";
    case Ending::suspect: return "suspect";
    case Ending::blew_up: return "blew up";
    case Ending::crashed: return "crashed";
    case Ending::too_slow: return "too slow";
    case Ending::missing: break;
  }
  return "not run";
}

double Outcome::number(const std::string& key) const {
  const nlohmann::json* at = &record;
  std::istringstream parts(key);
  for (std::string part; std::getline(parts, part, '.');) {
    if (!at->is_object()) return std::numeric_limits<double>::quiet_NaN();
    const auto found = at->find(part);
    if (found == at->end()) return std::numeric_limits<double>::quiet_NaN();
    at = &*found;
  }
  return at->is_number() ? at->get<double>() : std::numeric_limits<double>::quiet_NaN();
}

StudyFolder::StudyFolder(fs::path folder) : path_(std::move(folder)) {
  std::error_code error;
  const bool fresh = !fs::exists(path_, error) || (fs::is_directory(path_, error) && fs::is_empty(path_, error));
  if (!fresh && !fs::exists(path_ / marker, error)) {
    throw std::runtime_error(
        fmt::format("{}: this folder holds files that are not of a riffle study; give --out a new or an "
                    "empty folder",
                    path_.string()));
  }
  for (const char* name : {"runs", "ended"}) {
    fs::create_directories(path_ / name, error);
    if (error)
      throw std::runtime_error(fmt::format("cannot make the folder {}: {}", (path_ / name).string(), error.message()));
  }
  lock_ = ::open((path_ / marker).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (lock_ < 0)
    throw std::runtime_error(fmt::format("cannot write to the folder {}: {}", path_.string(), std::strerror(errno)));
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock_);
    throw std::runtime_error(fmt::format(
        "{}: another riffle is working on this study; wait for it or give --out another folder", path_.string()));
  }
}

StudyFolder::~StudyFolder() {
  if (lock_ >= 0) ::close(lock_);
}

Outcome StudyFolder::outcome(const std::string& name) const {
  Outcome outcome;
  const nlohmann::json record = json_in(run(name) / "run.json");
  if (record.is_object()) {
    const std::string status = text_at(record, "status");
    outcome.ending = status == "failed" ? Ending::blew_up : status == "suspect" ? Ending::suspect : Ending::good;
    outcome.message = text_at(record, "message");
    outcome.record = record;
    return outcome;
  }
  const nlohmann::json end = json_in(ended(name));
  if (!end.is_object()) return outcome;
  outcome.ending = text_at(end, "ending") == "too slow" ? Ending::too_slow : Ending::crashed;
  outcome.message = text_at(end, "message");
  if (end.contains("wall_seconds") && end["wall_seconds"].is_number())
    outcome.wall_seconds = end["wall_seconds"].get<double>();
  return outcome;
}

void StudyFolder::note_end(const std::string& name, const JobEnd& end) const {
  std::error_code ignored;
  if (fs::exists(run(name) / "run.json", ignored)) {
    fs::remove(said(name), ignored);
    return;
  }
  const std::string last = last_line(said(name));
  std::string message;
  if (end.too_slow) {
    message = fmt::format("stopped after {:.3g} s", end.wall_seconds);
  } else if (end.signal != 0) {
    message = fmt::format("ended by signal {} ({})", end.signal, strsignal(end.signal));
  } else {
    message = last.empty() ? fmt::format("ended with code {} and no record", end.exit_code) : last;
  }
  const nlohmann::json json{{"ending", in_words(end.too_slow ? Ending::too_slow : Ending::crashed)},
                            {"message", message},
                            {"exit_code", end.exit_code},
                            {"signal", end.signal},
                            {"wall_seconds", end.wall_seconds}};
  write_atomically(ended(name), json.dump(2) + "\n");
}

void StudyFolder::forget(const std::string& name) const {
  std::error_code ignored;
  fs::remove(ended(name), ignored);
  fs::remove(run(name) / "run.json", ignored);
}

}  // namespace riffle
