#include "host/output/run_folder.hpp"

#include <thread>
#include <vector>

#include "host/output/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

// A folder with the run of somebody who has gone.
void leave_run(const fs::path& folder, bool ended) {
  const RunFolder run = RunFolder::create_at(folder, false);
  write_atomically(run.log(), "log");
  if (ended) write_atomically(run.record(), R"({"status": "finished"})");
}

TEST(RunFolder, NumbersGoUpFromTheLargestInUse) {
  const TemporaryFolder here;
  fs::create_directories(here.path() / "runs" / "wet-0.5-7");
  fs::create_directories(here.path() / "runs" / "wet-0.5-old");
  fs::create_directories(here.path() / "runs" / "wet-12");
  EXPECT_EQ(RunFolder::create_numbered(here.path() / "runs", "wet-0.5").path(), here.path() / "runs" / "wet-0.5-8");
  EXPECT_EQ(RunFolder::create_numbered(here.path() / "runs", "wet-0.5").path(), here.path() / "runs" / "wet-0.5-9");
}

TEST(RunFolder, RunsStartedAtOnceGetAFolderEach) {
  const TemporaryFolder here;
  std::vector<fs::path> folders(8);
  std::vector<std::thread> starts;
  for (auto& folder : folders) {
    starts.emplace_back([&] { folder = RunFolder::create_numbered(here.path(), "case").path(); });
  }
  for (auto& start : starts) start.join();
  std::sort(folders.begin(), folders.end());
  EXPECT_EQ(std::unique(folders.begin(), folders.end()), folders.end());
}

TEST(RunFolder, ACaseNameCannotLeadOutOfTheFolder) {
  const TemporaryFolder here;
  EXPECT_EQ(RunFolder::create_numbered(here.path(), "../a b/c").path(), here.path() / "case..-a-b-c-1");
}

TEST(RunFolder, AGivenFolderIsMadeWithItsParents) {
  const TemporaryFolder here;
  const RunFolder run = RunFolder::create_at(here.path() / "a" / "b", false);
  EXPECT_TRUE(fs::is_directory(here.path() / "a" / "b"));
  EXPECT_EQ(run.record(), here.path() / "a" / "b" / "run.json");
}

TEST(RunFolder, RefusesARunThatHasEndedUnlessToldToOverwrite) {
  const TemporaryFolder here;
  leave_run(here.path() / "r", true);
  const std::string said = refusal([&] { RunFolder::create_at(here.path() / "r", false); });
  EXPECT_TRUE(contains(said, "holds a run that has ended (status \"finished\")")) << said;
  EXPECT_TRUE(contains(said, "--overwrite")) << said;
  EXPECT_TRUE(fs::exists(here.path() / "r" / "run.json"));
}

TEST(RunFolder, OffersToResumeARunThatHasNotEnded) {
  const TemporaryFolder here;
  leave_run(here.path() / "r", false);
  const std::string said = refusal([&] { RunFolder::create_at(here.path() / "r", false); });
  EXPECT_TRUE(contains(said, "--resume")) << said;
}

TEST(RunFolder, OverwritingRemovesTheOldRunAndNothingElse) {
  const TemporaryFolder here;
  leave_run(here.path() / "r", true);
  write_atomically(here.path() / "r" / "my-notes.md", "mine");
  fs::create_directories(here.path() / "r" / "snapshots");
  write_atomically(here.path() / "r" / "snapshots" / "000000.hdf", "x");
  const RunFolder run = RunFolder::create_at(here.path() / "r", true);
  EXPECT_FALSE(fs::exists(run.record()));
  EXPECT_FALSE(fs::exists(run.log()));
  EXPECT_FALSE(fs::exists(here.path() / "r" / "snapshots"));
  EXPECT_TRUE(fs::exists(here.path() / "r" / "my-notes.md"));
}

TEST(RunFolder, NeverWritesAmongOtherPeoplesFiles) {
  const TemporaryFolder here;
  write_atomically(here.path() / "thesis.tex", "years of work");
  const std::string said = refusal([&] { RunFolder::create_at(here.path(), true); });
  EXPECT_TRUE(contains(said, "not of a riffle run")) << said;
  EXPECT_FALSE(fs::exists(here.path() / ".riffle-run"));
}

TEST(RunFolder, RefusesAFileInPlaceOfAFolder) {
  const TemporaryFolder here;
  write_atomically(here.path() / "f", "x");
  EXPECT_TRUE(contains(refusal([&] { RunFolder::create_at(here.path() / "f", true); }), "needs a folder"));
}

TEST(RunFolder, TwoProgramsCannotWriteToOneFolder) {
  const TemporaryFolder here;
  const RunFolder first = RunFolder::create_at(here.path() / "r", false);
  const std::string said = refusal([&] { RunFolder::reopen(here.path() / "r"); });
  EXPECT_TRUE(contains(said, "another riffle is writing")) << said;
}

TEST(RunFolder, CanBeReopenedWhenItsProgramHasGone) {
  const TemporaryFolder here;
  leave_run(here.path() / "r", true);
  const RunFolder run = RunFolder::reopen(here.path() / "r");
  EXPECT_EQ(recorded_status(run.path()), "finished");
  run.forget_record();
  EXPECT_EQ(recorded_status(run.path()), std::nullopt);
}

TEST(RunFolder, ReopenRefusesWhatIsNoRun) {
  const TemporaryFolder here;
  EXPECT_TRUE(contains(refusal([&] { RunFolder::reopen(here.path() / "no"); }), "there is no such folder"));
  EXPECT_TRUE(contains(refusal([&] { RunFolder::reopen(here.path()); }), "this is not one"));
}

}  // namespace
}  // namespace riffle
