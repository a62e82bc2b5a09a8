#include "host/output/log.hpp"

#include <spdlog/spdlog.h>

#include "host/output/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

TEST(Log, TheFileHasEveryLineAtOnceAndTheConsoleWhatMatters) {
  const TemporaryFolder folder;
  testing::internal::CaptureStderr();
  const auto log = open_log(folder.path() / "log.txt", false);
  log->debug("detail");
  log->info("started");
  log->warn("odd");
  const std::string file = read_file(folder.path() / "log.txt"), console = testing::internal::GetCapturedStderr();
  EXPECT_TRUE(contains(file, "debug: detail\n")) << file;
  EXPECT_TRUE(contains(file, "info: started\n")) << file;
  EXPECT_EQ(console, "info: started\nwarning: odd\n");
}

TEST(Log, QuietLeavesWarningsOnTheConsoleAndEverythingInTheFile) {
  const TemporaryFolder folder;
  testing::internal::CaptureStderr();
  const auto log = open_log(folder.path() / "log.txt", true);
  log->info("started");
  log->error("broken");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "error: broken\n");
  EXPECT_TRUE(contains(read_file(folder.path() / "log.txt"), "info: started\n"));
}

TEST(Log, GoesOnInTheFileOfARunThatIsResumed) {
  const TemporaryFolder folder;
  open_log(folder.path() / "log.txt", true)->info("first");
  open_log(folder.path() / "log.txt", true)->info("second");
  const std::string file = read_file(folder.path() / "log.txt");
  EXPECT_TRUE(contains(file, "first") && contains(file, "second")) << file;
}

TEST(Log, SaysWhyItCannotBeOpened) {
  const TemporaryFolder folder;
  write_atomically(folder.path() / "f", "x");
  EXPECT_TRUE(contains(refusal([&] { open_log(folder.path() / "f" / "log.txt", true); }), "cannot write"));
}

}  // namespace
}  // namespace riffle
