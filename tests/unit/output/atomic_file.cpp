#include "host/output/atomic_file.hpp"

#include <sys/resource.h>

#include <csignal>

#include "temporary_folder.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

// Files longer than `bytes` cannot be written while one lives: a full disk, as far as a program can tell.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

TEST(AtomicFile, HoldsTheContentAndLeavesNothingAside) {
  const TemporaryFolder folder;
  const std::string content("one\0two", 7);
  write_atomically(folder.path() / "a", content);
  EXPECT_EQ(read_file(folder.path() / "a"), content);
  EXPECT_FALSE(fs::exists(folder.path() / "a.part"));
}

TEST(AtomicFile, ReplacesTheOldContentAltogether) {
  const TemporaryFolder folder;
  write_atomically(folder.path() / "a", "a long old content");
  write_atomically(folder.path() / "a", "new");
  EXPECT_EQ(read_file(folder.path() / "a"), "new");
}

TEST(AtomicFile, KeepsTheOldFileWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  write_atomically(folder.path() / "a", "old");
  std::string said;
  {
    const FullDisk disk(1000);
    said = refusal([&] { write_atomically(folder.path() / "a", std::string(5000, 'x')); });
  }
  EXPECT_TRUE(contains(said, "cannot write")) << said;
  EXPECT_EQ(read_file(folder.path() / "a"), "old");
  EXPECT_FALSE(fs::exists(folder.path() / "a.part"));
}

TEST(AtomicFile, SaysWhichFolderIsMissing) {
  const TemporaryFolder folder;
  const std::string said = refusal([&] { write_atomically(folder.path() / "no" / "a", "x"); });
  EXPECT_TRUE(contains(said, "no/a")) << said;
  EXPECT_TRUE(contains(said, "No such file")) << said;
}

TEST(AtomicFile, AnUnpublishedPartGoesAwayAndTheOldFileStays) {
  const TemporaryFolder folder;
  write_atomically(folder.path() / "a", "old");
  {
    const PartFile part(folder.path() / "a");
    part.write("half");
    EXPECT_TRUE(fs::exists(part.part()));
  }
  EXPECT_FALSE(fs::exists(folder.path() / "a.part"));
  EXPECT_EQ(read_file(folder.path() / "a"), "old");
}

TEST(AtomicFile, KeepsTheFileBeforeUnderItsOtherName) {
  const TemporaryFolder folder;
  for (const char* content : {"first", "second", "third"}) {
    PartFile part(folder.path() / "a");
    part.write(content);
    part.publish_keeping(folder.path() / "b");
  }
  EXPECT_EQ(read_file(folder.path() / "a"), "third");
  EXPECT_EQ(read_file(folder.path() / "b"), "second");
  EXPECT_FALSE(fs::exists(folder.path() / "a.part"));
}

}  // namespace
}  // namespace riffle
