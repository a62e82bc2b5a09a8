#include "host/output/checkpoint.hpp"

#include <hdf5.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <random>
#include <thread>

#include "host/output/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

Checkpoint sample() {
  Checkpoint c;
  c.meta = "{\"time\": 1.5}";
  c.reals["velocity.0"] = {1,
                           -0.0,
                           std::numeric_limits<double>::infinity(),
                           5e-324,
                           std::bit_cast<double>(std::uint64_t{0x7ff8'0000'dead'beef}),
                           std::bit_cast<double>(std::uint64_t{0xfff4'0000'0000'0001})};
  c.reals["empty"] = {};
  c.integers["id"] = {0, -1, std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max()};
  c.integers["none"] = {};
  return c;
}

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> all;
  for (const double v : values) all.push_back(std::bit_cast<std::uint64_t>(v));
  return all;
}

void expect_same(const Checkpoint& a, const Checkpoint& b) {
  EXPECT_EQ(a.meta, b.meta);
  EXPECT_EQ(a.integers, b.integers);
  ASSERT_EQ(a.reals.size(), b.reals.size());
  for (const auto& [name, values] : a.reals) {
    ASSERT_EQ(b.reals.count(name), 1U) << name;
    EXPECT_EQ(bits(values), bits(b.reals.at(name))) << name;
  }
}

TEST(Checkpoint, ComesBackBitForBit) {
  const TemporaryFolder folder;
  write_checkpoint(folder.path() / "c.h5", sample());
  expect_same(read_checkpoint(folder.path() / "c.h5"), sample());
}

TEST(Checkpoint, CanBeEmpty) {
  const TemporaryFolder folder;
  write_checkpoint(folder.path() / "c.h5", {});
  expect_same(read_checkpoint(folder.path() / "c.h5"), {});
}

TEST(Checkpoint, IsAnHdf5FileForEveryonesTools) {
  const TemporaryFolder folder;
  write_checkpoint(folder.path() / "c.h5", sample());
  const hid_t file = H5Fopen((folder.path() / "c.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  EXPECT_GT(H5Lexists(file, "/reals/velocity.0", H5P_DEFAULT), 0);
  H5Fclose(file);
}

TEST(Checkpoint, AnyChangedByteIsFound) {
  const TemporaryFolder folder;
  write_checkpoint(folder.path() / "c.h5", sample());
  const std::string good = read_file(folder.path() / "c.h5");
  std::mt19937 random(3);
  for (int trial = 0; trial < 300; ++trial) {
    std::string bad = good;
    // Every byte of the header's text, then anywhere.
    const std::size_t place = trial < 70 ? static_cast<std::size_t>(trial) : 512 + random() % (bad.size() - 512);
    bad[place] = static_cast<char>(bad[place] ^ (1 << random() % 8));
    std::ofstream(folder.path() / "c.h5", std::ios::binary) << bad;
    EXPECT_THROW(read_checkpoint(folder.path() / "c.h5"), std::runtime_error) << "byte " << place;
  }
}

TEST(Checkpoint, AnyTruncationIsFound) {
  const TemporaryFolder folder;
  write_checkpoint(folder.path() / "c.h5", sample());
  const std::string good = read_file(folder.path() / "c.h5");
  for (const std::size_t size : {std::size_t{0}, std::size_t{5}, std::size_t{100}, std::size_t{512}, good.size() - 1}) {
    write_atomically(folder.path() / "c.h5", good.substr(0, size));
    const std::string said = refusal([&] { read_checkpoint(folder.path() / "c.h5"); });
    EXPECT_TRUE(contains(said, "c.h5 is damaged: it ")) << size << ": " << said;
  }
  write_atomically(folder.path() / "c.h5", good + "x");
  EXPECT_TRUE(contains(refusal([&] { read_checkpoint(folder.path() / "c.h5"); }), "is damaged"));
}

TEST(Checkpoint, WhatIsNoneIsToldFromADamagedOne) {
  const TemporaryFolder folder;
  write_atomically(folder.path() / "text", "[case]\nname = \"x\"\n");
  EXPECT_TRUE(contains(refusal([&] { read_checkpoint(folder.path() / "text"); }), "is not a checkpoint of riffle"));
  EXPECT_TRUE(contains(refusal([&] { read_checkpoint(folder.path()); }), "is not a checkpoint of riffle"));
  EXPECT_TRUE(contains(refusal([&] { read_checkpoint(folder.path() / "no"); }), "there is no checkpoint"));
}

TEST(Checkpoint, OfANewerFormatIsRefusedWithBothNumbers) {
  const TemporaryFolder folder;
  write_checkpoint(folder.path() / "c.h5", sample());
  std::string newer = read_file(folder.path() / "c.h5");
  newer.replace(newer.find("format 1"), 8, "format 9");
  write_atomically(folder.path() / "c.h5", newer);
  const std::string said = refusal([&] { read_checkpoint(folder.path() / "c.h5"); });
  EXPECT_TRUE(contains(said, "has format 9, and this riffle reads formats up to 1")) << said;
}

TEST(Checkpoint, NamesThatHdf5WouldTakeForPathsAreOurMistake) {
  const TemporaryFolder folder;
  for (const char* name : {"", ".", "a/b"}) {
    Checkpoint c;
    c.reals[name] = {1};
    EXPECT_THROW(write_checkpoint(folder.path() / "c.h5", c), std::logic_error) << name;
  }
  EXPECT_FALSE(fs::exists(folder.path() / "c.h5"));
}

TEST(Checkpoints, TheLastTwoAreKept) {
  const TemporaryFolder folder;
  for (const char* meta : {"1", "2", "3"}) save_checkpoint(folder.path(), {meta, {}, {}});
  EXPECT_EQ(read_checkpoint(folder.path() / "checkpoint.h5").meta, "3");
  EXPECT_EQ(read_checkpoint(folder.path() / "checkpoint.previous.h5").meta, "2");
  EXPECT_EQ(load_checkpoint(folder.path()).checkpoint.meta, "3");
  EXPECT_EQ(load_checkpoint(folder.path()).warning, "");
}

TEST(Checkpoints, TheOneBeforeServesWhenTheNewestIsDamagedOrMissing) {
  const TemporaryFolder folder;
  for (const char* meta : {"1", "2"}) save_checkpoint(folder.path(), {meta, {}, {}});
  fs::resize_file(folder.path() / "checkpoint.h5", 700);
  LoadedCheckpoint loaded = load_checkpoint(folder.path());
  EXPECT_EQ(loaded.checkpoint.meta, "1");
  EXPECT_EQ(loaded.file, folder.path() / "checkpoint.previous.h5");
  EXPECT_TRUE(contains(loaded.warning, "is damaged") && contains(loaded.warning, "using the one before it"));
  fs::remove(folder.path() / "checkpoint.h5");
  loaded = load_checkpoint(folder.path());
  EXPECT_EQ(loaded.checkpoint.meta, "1");
  EXPECT_TRUE(contains(loaded.warning, "there is no checkpoint")) << loaded.warning;
}

TEST(Checkpoints, WithoutAGoodOneEveryReasonIsGiven) {
  const TemporaryFolder folder;
  EXPECT_TRUE(contains(refusal([&] { load_checkpoint(folder.path()); }), "there is no checkpoint"));
  for (const char* meta : {"1", "2"}) save_checkpoint(folder.path(), {meta, {}, {}});
  fs::resize_file(folder.path() / "checkpoint.h5", 700);
  fs::resize_file(folder.path() / "checkpoint.previous.h5", 20);
  const std::string said = refusal([&] { load_checkpoint(folder.path()); });
  EXPECT_TRUE(contains(said, "checkpoint.h5 is damaged")) << said;
  EXPECT_TRUE(contains(said, "checkpoint.previous.h5 is damaged")) << said;
}

TEST(Checkpoints, AProgramKilledAtAnyMomentLeavesAGoodOne) {
  const TemporaryFolder folder;
  const auto state = [](std::int64_t n) {
    return Checkpoint{std::to_string(n), {}, {{"n", std::vector<std::int64_t>(20000, n)}}};
  };
  save_checkpoint(folder.path(), state(0));
  std::mt19937 random(11);
  std::int64_t last = 0;
  unsigned most = 4000;  // microseconds; grows until the child gets something done, on a slow machine
  for (int trial = 0; trial < 25; ++trial) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (std::int64_t n = last + 1;; ++n) save_checkpoint(folder.path(), state(n));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % most));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    const LoadedCheckpoint loaded = load_checkpoint(folder.path());
    const std::int64_t n = std::stoll(loaded.checkpoint.meta);
    EXPECT_GE(n, last);
    EXPECT_EQ(loaded.checkpoint.integers.at("n"), state(n).integers.at("n"));
    if (n == last) most = std::min(2 * most, 200000U);
    last = n;
  }
  EXPECT_GT(last, 0);
}

}  // namespace
}  // namespace riffle
