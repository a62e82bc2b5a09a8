// What is in the files is read back by VTK's own reader in vtk/; here: the series, resuming and refusals.
#include "host/output/snapshots.hpp"

#include <nlohmann/json.hpp>

#include "host/output/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

ParticleStore particles() {
  ParticleStore store(1);
  store.add_field({"position", "m", "", Shape::vector}, FieldUse::evolved);
  store.add_field({"depth", "m", "", Shape::scalar}, FieldUse::derived);
  store.resize_owned({3, 0, 0, 0, 0, 0});
  store.ids() = {0, 1, 2};
  return store;
}

nlohmann::json index_of(const SnapshotWriter& writer) {
  return nlohmann::json::parse(read_file(writer.index()));
}

TEST(Snapshots, TheIndexListsEveryFileWithItsExactTime) {
  const TemporaryFolder folder;
  SnapshotWriter writer(folder.path(), {"depth"});
  const ParticleStore store = particles();
  writer.write(store, 0, 0);
  const fs::path second = writer.write(store, 0.1 + 0.2, 17);
  EXPECT_EQ(second, folder.path() / "snapshots" / "000001.hdf");
  const auto index = index_of(writer);
  EXPECT_EQ(index["file-series-version"], "1.0");
  ASSERT_EQ(index["files"].size(), 2U);
  EXPECT_EQ(index["files"][1]["name"], "snapshots/000001.hdf");
  EXPECT_EQ(index["files"][1]["time"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(writer.written(), 2);
}

TEST(Snapshots, AResumedRunGoesOnWhereTheCheckpointWas) {
  const TemporaryFolder folder;
  const ParticleStore store = particles();
  {
    SnapshotWriter writer(folder.path(), {});
    for (const double time : {0.0, 1.0, 2.0, 3.0}) writer.write(store, time, 0);
  }
  SnapshotWriter writer(folder.path(), {});
  writer.resume(2);
  EXPECT_FALSE(fs::exists(folder.path() / "snapshots" / "000002.hdf"));
  EXPECT_EQ(index_of(writer)["files"].size(), 2U);
  EXPECT_EQ(writer.write(store, 2.5, 0), folder.path() / "snapshots" / "000002.hdf");
  EXPECT_EQ(index_of(writer)["files"][2]["time"], 2.5);
}

TEST(Snapshots, CannotResumeWhatIsNotThere) {
  const TemporaryFolder folder;
  SnapshotWriter writer(folder.path(), {});
  EXPECT_TRUE(contains(refusal([&] { writer.resume(3); }), "lists 0 snapshots, the checkpoint was written after 3"));
}

TEST(Snapshots, AFieldThatIsNotThereIsOurMistakeAndLeavesNoFile) {
  const TemporaryFolder folder;
  SnapshotWriter writer(folder.path(), {"no_such_field"});
  EXPECT_THROW(writer.write(particles(), 0, 0), std::logic_error);
  EXPECT_TRUE(fs::is_empty(folder.path() / "snapshots"));
  EXPECT_EQ(writer.written(), 0);
}

TEST(Snapshots, TheSameStateGivesTheSameBytes) {
  const TemporaryFolder folder;
  write_snapshot(folder.path() / "a", particles(), {"depth"}, 1, 2);
  write_snapshot(folder.path() / "b", particles(), {"depth"}, 1, 2);
  EXPECT_EQ(read_file(folder.path() / "a"), read_file(folder.path() / "b"));
}

}  // namespace
}  // namespace riffle
