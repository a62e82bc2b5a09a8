// What the host says to libraries that it must not load, or not believe.
#include <gtest/gtest.h>

#include <cfenv>
#include <limits>

#include "host/plugins/instance.hpp"
#include "host/plugins/library.hpp"
#include "tests/hostile/files.hpp"

namespace riffle {
namespace {

using hostile::Folder;
using hostile::library;
using hostile::without_folder;

// The one sentence with which loading fails.
std::string refusal(const std::filesystem::path& file) {
  try {
    const Library loaded(file);
  } catch (const LibraryError& error) {
    EXPECT_EQ(error.lines().size(), 1U) << error.what();
    return without_folder(without_folder(error.what()), file.parent_path());
  }
  return "loaded";
}

TEST(Load, AGoodLibraryInPlainCIsLoadedAndDescribed) {
  const Library good(library("good"));
  ASSERT_EQ(good.plugins().size(), 1U);
  EXPECT_TRUE(good.warnings().empty());
  const PluginDescription& d = good.plugins().front().description;
  EXPECT_EQ(d.kind, "drag");
  EXPECT_EQ(d.id, "good");
  EXPECT_EQ(d.dimensions, (std::vector<int>{1, 2, 3}));
  ASSERT_EQ(d.parameters.size(), 1U);
  EXPECT_EQ(d.parameters[0].name, "coefficient");
  EXPECT_EQ(d.parameters[0].fallback, 0.01);
  EXPECT_EQ(d.library_hash.size(), 64U);
  EXPECT_EQ(d.library_path, library("good").string());
  EXPECT_EQ(d.build, "tests");
}

TEST(Load, AnotherMajorVersionIsRefusedWithBothNumbers) {
  EXPECT_EQ(
      refusal(library("wrong-major")),
      "wrong-major.so: speaks version 1.0 of the plugin boundary, this program 0.2; another major version is another "
      "language: rebuild it with this program's SDK");
}

TEST(Load, ANewerMinorVersionIsRefusedWithBothNumbers) {
  EXPECT_EQ(refusal(library("newer-minor")),
            "newer-minor.so: needs version 0.8 of the plugin boundary, this program speaks 0.2; use a newer Riffle, or "
            "rebuild it with this program's SDK");
}

TEST(Load, AnOlderMinorVersionIsCompletedWithWhatItLacks) {
  const Library old(library("older-minor"));
  ASSERT_EQ(old.plugins().size(), 1U);
  const riffle_plugin& table = *old.plugins().front().table;
  EXPECT_EQ(table.size, sizeof(riffle_plugin));
  EXPECT_EQ(table.state_size, 0) << "a member behind the end of the old struct was believed";
  EXPECT_EQ(table.passes[0]->run_global, nullptr);
  EXPECT_NE(table.passes[0]->run, nullptr);
}

TEST(Load, ABuildWithOtherNumbersIsRefused) {
  EXPECT_EQ(refusal(library("float-build")), "float-build.so: works with numbers of 4 bytes, this program with 8");
}

TEST(Load, StructsOfAnotherSizeAreRefused) {
  EXPECT_EQ(refusal(library("wrong-size")),
            "wrong-size.so: a riffle_pass has size 88, but it has 96 in version 0.2 of the boundary");
}

TEST(Load, ALibraryWithoutTheSymbolIsNeverLoaded) {
  // Loading it would end this test with status 77.
  EXPECT_EQ(refusal(library("missing-symbol")),
            "missing-symbol.so: is a shared library, but no plugin of Riffle: it does not export riffle_plugin_entry");
}

TEST(Load, AStrippedLibraryIsAsGoodAsAnyOther) {
  const Folder folder;
  const auto file = folder.take("good", "stripped");
  ASSERT_EQ(std::system(("strip " + file.string()).c_str()), 0);
  EXPECT_EQ(Library(file).plugins().size(), 1U);
}

TEST(Load, ATextFileIsNoLibrary) {
  const Folder folder;
  EXPECT_EQ(refusal(folder.write("notes.so", "this is not a library\n")),
            "notes.so: is not a shared library (no ELF file)");
  EXPECT_EQ(refusal(folder.write("empty.so", "")), "empty.so: is not a shared library (no ELF file)");
}

TEST(Load, AProgramIsNoLibrary) {
  // The tests' own executable is position-independent, hence of the same ELF type; it just exports nothing.
  EXPECT_EQ(refusal("/proc/self/exe"),
            "exe: is a shared library, but no plugin of Riffle: it does not export riffle_plugin_entry");
}

TEST(Load, AFileThatIsNotThereIsSaidSo) {
  EXPECT_EQ(refusal(library("nobody")), "nobody.so: cannot be read");
}

TEST(Load, ACutOffLibraryIsRefusedAtEveryLength) {
  const Folder folder;
  const std::string whole = hostile::contents(library("good"));
  ASSERT_GT(whole.size(), 4096U);
  for (std::size_t length = 64; length < whole.size(); length += whole.size() / 50) {
    const std::string text = refusal(folder.write("cut.so", whole.substr(0, length)));
    EXPECT_EQ(text, "cut.so: is cut off: the file ends before its own tables say") << length << " bytes";
  }
}

TEST(Load, ALibraryForAnotherProcessorIsRefused) {
  const Folder folder;
  std::string bytes = hostile::contents(library("good"));
  bytes[18] = 40;  // e_machine: 32-bit ARM
  bytes[19] = 0;
  EXPECT_EQ(refusal(folder.write("arm.so", bytes)), "arm.so: is built for another processor than this one");
}

TEST(Load, WrongOffsetsInTheFileDoNoHarm) {
  const Folder folder;
  const std::string good = hostile::contents(library("good"));
  // e_phoff, e_shoff, and in turn every byte of the section headers' last part, set to the largest value.
  for (std::size_t at = 32; at < 48; ++at) {
    std::string bytes = good;
    bytes[at] = '\xff';
    EXPECT_THROW(Library(folder.write("bent.so", bytes)), LibraryError) << "byte " << at;
  }
}

TEST(Load, AMissingFunctionIsNamedAsTheLinkerNamesIt) {
  const std::string text = refusal(library("undefined-symbol"));
  EXPECT_EQ(text, "undefined-symbol.so: cannot be loaded: undefined-symbol.so: undefined symbol: nobody_has_this");
}

TEST(Load, ADefaultOutOfItsRangeIsRefused) {
  EXPECT_EQ(refusal(library("default-out-of-range")),
            "default-out-of-range.so: drag \"default-out-of-range\": parameter \"coefficient\": default 3 is outside "
            "[0, 1]");
}

TEST(Load, ANameOfTheDictionaryMeansWhatTheDictionarySays) {
  EXPECT_EQ(
      refusal(library("wrong-unit")),
      "wrong-unit.so: drag \"wrong-unit\": pass \"friction\" writes \"drag_rate\": is a scalar in s here, but the "
      "dictionary has a scalar in s-1");
}

TEST(Load, APassNeedsAFunction) {
  EXPECT_EQ(refusal(library("null-run")), "null-run.so: drag \"null-run\": pass \"friction\": has no run function");
}

TEST(Load, ArithmeticIsAsBeforeAfterALibraryBuiltWithFastMath) {
  const Library loaded(library("fast-math"));
  ASSERT_EQ(loaded.warnings().size(), 1U);
  EXPECT_EQ(
      without_folder(loaded.warnings().front()),
      "fast-math.so: changes the floating-point arithmetic of the whole program when loaded, which has been undone; "
      "it was probably built with -ffast-math, so its own results may differ from what its source says");
  volatile double smallest = std::numeric_limits<double>::min();
  EXPECT_GT(smallest / 2, 0) << "subnormal numbers are flushed to zero";
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

// ---- create ----

std::string failure_to_create(const std::string& name) {
  const Library loaded(library(name));
  const Plugin& plugin = loaded.plugins().front();
  try {
    const PluginInstance instance(plugin, 1, default_values(plugin.description));
  } catch (const PluginError& error) {
    return error.what();
  }
  return "created";
}

TEST(Create, AnExceptionBecomesAnErrorWithItsText) {
  EXPECT_EQ(failure_to_create("throws-in-create"),
            "drag \"throws-in-create\" cannot be created: an exception left the plugin: no memory for the table of "
            "roughness");
}

TEST(Create, ThePluginsOwnReasonIsPassedOn) {
  EXPECT_EQ(failure_to_create("refuses-create"),
            "drag \"refuses-create\" cannot be created: coefficient = 0.01 does not suit this bed");
}

TEST(Create, AChangedRoundingModeIsPutBackAndRefused) {
  EXPECT_EQ(failure_to_create("changes-rounding"),
            "drag \"changes-rounding\" changes the floating-point arithmetic of the whole program in create");
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

}  // namespace
}  // namespace riffle
