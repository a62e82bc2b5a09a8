// The folder of one run: everything that the run writes is in it, and nothing that the run does not own is touched.
//
//   runs/<case>-<n>/        or the folder given by --out
//     run.json              the record (docs/run-record.md); written last, so its presence means that the run ended
//     log.txt  manifest.toml
//     snapshots.hdf.series  the index that ParaView opens;  snapshots/000000.hdf ... the states
//     profile.csv           the last state along x;         profiles/000000.csv ... those asked for in between
//     picture.svg .png      with picture.gp and picture.dat, which draw them again
//     checkpoint.h5, checkpoint.previous.h5
//     .riffle-run           marks the folder as ours, and is locked while a program writes to it
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace riffle {

class RunFolder {
 public:
  // A new folder <parent>/<case>-<n> with n one above the largest in use; two runs started at once get two folders.
  static RunFolder create_numbered(const std::filesystem::path& parent, const std::string& case_name);

  // The given folder, made if needed. Refused with one sentence (std::runtime_error) when it holds a run and
  // `overwrite` is false, when it holds other people's files (always), or when a program is writing to it.
  // With `overwrite` the files of the old run go, others in the folder stay.
  static RunFolder create_at(const std::filesystem::path& folder, bool overwrite);

  // The folder of a run to continue (--resume). Changes nothing in it.
  static RunFolder reopen(const std::filesystem::path& folder);

  RunFolder(RunFolder&& other) noexcept;
  RunFolder& operator=(RunFolder&&) = delete;
  ~RunFolder();  // gives up the lock

  // Removes run.json: a run that goes on has not ended. To be called once the checkpoint has been read.
  void forget_record() const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path record() const { return path_ / "run.json"; }
  [[nodiscard]] std::filesystem::path log() const { return path_ / "log.txt"; }
  [[nodiscard]] std::filesystem::path manifest() const { return path_ / "manifest.toml"; }
  [[nodiscard]] std::filesystem::path profile() const { return path_ / "profile.csv"; }
  [[nodiscard]] std::filesystem::path profile(std::int64_t number) const;  // makes profiles/ when first asked

 private:
  RunFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

  std::filesystem::path path_;
  int lock_;
};

// `status` in the folder's run.json, or nothing when there is no (readable) record, that is, the run has not ended.
std::optional<std::string> recorded_status(const std::filesystem::path& folder);

}  // namespace riffle
