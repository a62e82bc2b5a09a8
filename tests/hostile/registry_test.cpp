// One bad library among good ones, and two of one name.
#include "host/plugins/registry.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/hostile/files.hpp"

namespace riffle {
namespace {

using hostile::Folder;

TEST(Registry, ABadLibraryDoesNotStopTheOthers) {
  const Folder folder;
  folder.take("good");
  folder.take("wrong-major");
  folder.write("notes.so", "not a library\n");
  folder.write("readme.txt", "no library at all, and not looked at\n");
  const Registry registry({folder.path()});
  EXPECT_NE(registry.find("drag", "good"), nullptr);
  EXPECT_EQ(registry.all().size(), 1U);
  ASSERT_EQ(registry.bad_libraries().size(), 2U);
  EXPECT_EQ(registry.bad_libraries()[0].path, folder.path() / "notes.so");
  EXPECT_EQ(registry.bad_libraries()[0].reasons.size(), 1U);
}

TEST(Registry, APluginThatOnlyABadLibraryWouldGiveIsMissingForItsReason) {
  const Folder folder;
  folder.take("default-out-of-range", "something-else");
  const Registry registry({folder.path()});
  EXPECT_EQ(registry.find("drag", "default-out-of-range"), nullptr);
  EXPECT_EQ(hostile::without_folder(registry.why_missing("drag", "default-out-of-range"), folder.path()),
            "something-else.so: drag \"default-out-of-range\": parameter \"coefficient\": default 3 is outside [0, 1]");
  EXPECT_EQ(registry.why_missing("viscosity", "default-out-of-range"), "") << "ids are unique per kind only";
}

TEST(Registry, ALibraryThatCouldNotBeReadIsRecognisedByItsFileName) {
  const Folder folder;
  folder.take("wrong-major", "drag-manning");
  const Registry registry({folder.path()});
  EXPECT_EQ(hostile::without_folder(registry.why_missing("drag", "manning"), folder.path()).substr(0, 50),
            "drag-manning.so: speaks version 1.0 of the plugin ");
  EXPECT_EQ(registry.why_missing("drag", "chezy"), "");
}

TEST(Registry, TwoPluginsOfOneNameInOneFolderAreAnErrorThatNamesBoth) {
  const Folder folder;
  folder.take("duplicate-one");
  folder.take("duplicate-two");
  folder.take("good");
  const Registry registry({folder.path()});
  EXPECT_EQ(registry.find("drag", "duplicate"), nullptr);
  EXPECT_NE(registry.find("drag", "good"), nullptr);
  EXPECT_EQ(hostile::without_folder(registry.why_missing("drag", "duplicate"), folder.path()),
            "duplicate-two.so: drag \"duplicate\" is also in duplicate-one.so; one directory may hold it once only, so "
            "neither is used");
  ASSERT_EQ(registry.bad_libraries().size(), 1U);
}

TEST(Registry, InTwoFoldersTheFirstWinsAndTheOtherIsNoted) {
  const Folder first, second;
  const auto used = first.take("duplicate-two");
  const auto hidden = second.take("duplicate-one");
  const Registry registry({first.path(), second.path()});
  ASSERT_NE(registry.find("drag", "duplicate"), nullptr);
  EXPECT_EQ(registry.find("drag", "duplicate")->library_path, used.string());
  ASSERT_EQ(registry.notes().size(), 1U);
  EXPECT_EQ(registry.notes()[0],
            "drag \"duplicate\" of " + hidden.string() + " is hidden by the one of " + used.string());
}

TEST(Registry, AFolderThatIsNamedTwiceIsSearchedOnce) {
  const Folder folder;
  folder.take("good");
  const Registry registry({folder.path(), folder.path() / ".", folder.path()});
  EXPECT_EQ(registry.all().size(), 1U);
  EXPECT_TRUE(registry.notes().empty());
}

TEST(Registry, AChangedArithmeticIsNoted) {
  const Folder folder;
  folder.take("fast-math");
  const Registry registry({folder.path()});
  EXPECT_NE(registry.find("drag", "fast-math"), nullptr);
  ASSERT_EQ(registry.notes().size(), 1U);
  EXPECT_NE(registry.notes()[0].find("-ffast-math"), std::string::npos);
}

TEST(Registry, FoldersAreSearchedInTheirOrder) {
  ASSERT_EQ(setenv("RIFFLE_PLUGIN_PATH", "/from/environment:/and/more:", 1), 0);
  const auto path = plugin_search_path({"/argument"}, "/manifest", "/program");
  unsetenv("RIFFLE_PLUGIN_PATH");
  EXPECT_EQ(path, (std::vector<std::filesystem::path>{"/argument", "/manifest", "/from/environment", "/and/more",
                                                      "/program"}));
}

}  // namespace
}  // namespace riffle
