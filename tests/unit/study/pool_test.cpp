#include "host/study/pool.hpp"

#include <csignal>
#include <map>

#include "host/study/study_folder.hpp"
#include "tests/unit/study/scratch.hpp"

namespace riffle {
namespace {

Job shell(const std::string& script) {
  Job job;
  job.command = {"/bin/sh", "-c", script};
  return job;
}

std::map<std::size_t, JobEnd> ends_of(const std::vector<Job>& jobs, const PoolOptions& options) {
  std::map<std::size_t, JobEnd> ends;
  run_jobs(jobs, options, [&](std::size_t k, const JobEnd& end) { ends[k] = end; });
  return ends;
}

TEST(Pool, RunsAllJobsWhateverBecomesOfEach) {
  const auto ends = ends_of({shell("exit 0"), shell("exit 3"), shell("kill -SEGV $$"), shell("exit 0")}, {2, false});
  ASSERT_EQ(ends.size(), 4U);
  EXPECT_EQ(ends.at(1).exit_code, 3);
  EXPECT_EQ(ends.at(2).signal, SIGSEGV);
  EXPECT_EQ(ends.at(3).exit_code, 0);
}

TEST(Pool, SaysOfAProgramThatIsNotThereThatItIsNotThere) {
  Job job;
  job.command = {"/no/such/program"};
  EXPECT_EQ(ends_of({job}, {1, false}).at(0).exit_code, 127);
}

TEST(Pool, StopsAJobThatTakesTooLong) {
  Job job = shell("exec sleep 60");
  job.time_limit = 0.1;
  const JobEnd end = ends_of({job}, {1, false}).at(0);
  EXPECT_TRUE(end.too_slow);
  EXPECT_EQ(end.signal, SIGTERM);
  EXPECT_LT(end.wall_seconds, 30);  // far below its 60 s, on a machine however busy
}

class Together : public Scratch {
 protected:
  // The most of four jobs that were at work at the same time: each leaves a file while it is.
  [[nodiscard]] int most(int threads, const PoolOptions& options) const {
    const std::string script =
        "cd " + home_.string() + " && : > $$.at-work && ls *.at-work | wc -l >> counts && sleep 0.2; rm $$.at-work";
    std::vector<Job> jobs(4, shell(script));
    for (Job& job : jobs) job.threads = threads;
    ends_of(jobs, options);
    std::ifstream counts(home_ / "counts");
    int largest = 0;
    for (int count = 0; counts >> count;) largest = std::max(largest, count);
    return largest;
  }
};

TEST_F(Together, NeverMoreThanCores) {
  EXPECT_LE(most(1, {2, false}), 2);
}
TEST_F(Together, ThreadsCount) {
  EXPECT_EQ(most(2, {3, false}), 1);
}
TEST_F(Together, OneThatNeedsMoreThanAllCoresRunsAlone) {
  EXPECT_EQ(most(8, {2, false}), 1);
}
TEST_F(Together, ExclusiveMeansOneAtATime) {
  EXPECT_EQ(most(1, {4, true}), 1);
}

TEST(ShellWords, AreQuotedWhereNeeded) {
  EXPECT_EQ(shell_words({"riffle", "--set", "time.end=\"2 s\"", "it's", ""}),
            "riffle --set 'time.end=\"2 s\"' 'it'\\''s' ''");
}

class Folder : public Scratch {};

TEST_F(Folder, CountsARunAsEndedByItsRecord) {
  const StudyFolder folder(home_ / "study");
  EXPECT_EQ(folder.outcome("a").ending, Ending::missing);
  file("study/runs/a/run.json", R"({"status": "finished", "errors": {"depth": {"l1": 0.5}}})");
  EXPECT_EQ(folder.outcome("a").ending, Ending::good);
  EXPECT_EQ(folder.outcome("a").number("errors.depth.l1"), 0.5);
  EXPECT_TRUE(std::isnan(folder.outcome("a").number("errors.depth.l2")));
  file("study/runs/a/run.json", R"({"status": "failed", "message": "t = 3 s: NaN"})");
  EXPECT_EQ(folder.outcome("a").ending, Ending::blew_up);
  EXPECT_EQ(folder.outcome("a").message, "t = 3 s: NaN");
}

TEST_F(Folder, TakesHalfARecordForNone) {
  const StudyFolder folder(home_ / "study");
  file("study/runs/a/run.json", R"({"status": "fini)");
  EXPECT_EQ(folder.outcome("a").ending, Ending::missing);
}

TEST_F(Folder, NotesHowAProcessEndedThatLeftNoRecord) {
  const StudyFolder folder(home_ / "study");
  file("study/ended/a.txt", "first\nthe last word\n\n");
  folder.note_end("a", {2, 0, false, 1});
  EXPECT_EQ(folder.outcome("a").ending, Ending::crashed);
  EXPECT_EQ(folder.outcome("a").message, "the last word");
  folder.note_end("b", {0, SIGSEGV, false, 1});
  EXPECT_EQ(folder.outcome("b").message, "ended by signal 11 (Segmentation fault)");
  folder.note_end("c", {1, 0, true, 2.5});
  EXPECT_EQ(folder.outcome("c").ending, Ending::too_slow);
  folder.forget("c");
  EXPECT_EQ(folder.outcome("c").ending, Ending::missing);
}

TEST_F(Folder, IsForOneProgramAtATimeAndForNothingElse) {
  const StudyFolder folder(home_ / "study");
  EXPECT_THROW(StudyFolder(home_ / "study"), std::runtime_error);
  file("mine/notes.txt", "");
  EXPECT_THROW(StudyFolder(home_ / "mine"), std::runtime_error);
}

}  // namespace
}  // namespace riffle
