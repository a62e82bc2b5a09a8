// What a study leaves: <folder>/runs/<run>/ as `riffle run` writes it, and for runs that left no record of their own
// (crashed, refused, too slow) <folder>/ended/<run>.json. A run counts as ended when it has either, complete or not at all,
// so a study may be killed at any moment and goes on with what is missing.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "host/study/pool.hpp"

namespace riffle {

enum class Ending { missing, good, suspect, blew_up, crashed, too_slow };
std::string in_words(Ending ending);  // "finished", "suspect", "blew up", "crashed", "too slow", "not run"

struct Outcome {
  Ending ending = Ending::missing;
  std::string message;      // why it is not good, in one sentence
  double wall_seconds = 0;  // where there is no record
  nlohmann::json record;    // run.json, or null
  // The number under a dotted key such as "errors.depth.l1"; NaN when there is none.
  [[nodiscard]] double number(const std::string& key) const;
};

class StudyFolder {
 public:
  // Made if needed, and locked: a second program that works on the same study is refused (std::runtime_error), and so is
  // a folder of other people's files.
  explicit StudyFolder(std::filesystem::path folder);
  ~StudyFolder();
  StudyFolder(const StudyFolder&) = delete;
  StudyFolder& operator=(const StudyFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path run(const std::string& name) const { return path_ / "runs" / name; }
  [[nodiscard]] std::filesystem::path said(const std::string& name) const { return path_ / "ended" / (name + ".txt"); }
  [[nodiscard]] std::filesystem::path ended(const std::string& name) const {
    return path_ / "ended" / (name + ".json");
  }
  [[nodiscard]] Outcome outcome(const std::string& name) const;
  // Notes how a process ended that left no record, and tidies up what it said.
  void note_end(const std::string& name, const JobEnd& end) const;
  // Forgets a run that was not good, so that it is done again.
  void forget(const std::string& name) const;

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace riffle
