// The whole program with a hostile plugin in a case: what it says, how it ends, and what it leaves behind.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>

#include "tests/hostile/files.hpp"

namespace riffle {
namespace {

using hostile::Folder;

struct Outcome {
  int code = -1;
  std::string text;  // both streams
};

Outcome riffle_program(const std::string& arguments) {
  Outcome outcome;
  FILE* pipe = popen((std::string(RIFFLE_PROGRAM) + " " + arguments + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return outcome;
  std::array<char, 4096> part{};
  while (const std::size_t n = fread(part.data(), 1, part.size(), pipe)) outcome.text.append(part.data(), n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  return outcome;
}

// Still water in a closed channel for 2 s with this drag; the plugin lies beside the manifest.
std::string case_with(const std::string& drag, const std::string& parameters = "") {
  return "[case]\nname = \"hostile\"\n\n"
         "[domain]\nx = [0, 10]\nsmoothing_ratio = 1.3\n\n"
         "[initial]\nparticles = { count = 50 }\ndepth = \"1 + 0.1 * cos(0.314159265 * x)\"\n\n"
         "[plugins.equations]\nid = \"swe-standard\"\n\n[plugins.kernel]\nid = \"cubic-spline\"\n\n"
         "[plugins.boundary]\nid = \"mirror-wall\"\n\n"
         "[plugins.drag]\nid = \"" +
         drag + "\"\n" + parameters + "\n[time]\nend = 2\n\n[output]\npicture = false\n";
}

struct CaseRun {
  Folder folder;
  Outcome outcome;

  explicit CaseRun(const std::string& drag, const std::string& library = "") {
    folder.take(library.empty() ? drag : library);
    const auto manifest = folder.write("case.toml", case_with(drag));
    outcome = riffle_program("run " + manifest.string() + " --threads 1 --quiet --out " + out().string());
    outcome.text = hostile::without_folder(outcome.text, folder.path());
  }
  [[nodiscard]] std::filesystem::path out() const { return folder.path() / "out"; }
  [[nodiscard]] bool says(const std::string& text) const { return outcome.text.find(text) != std::string::npos; }
};

TEST(Program, AGoodPluginInPlainCRunsToItsEnd) {
  const CaseRun run("good");
  EXPECT_EQ(run.outcome.code, 0) << run.outcome.text;
  EXPECT_TRUE(std::filesystem::exists(run.out() / "run.json"));
}

// ---- what is found before the run: exit 2, nothing written ----

struct Refused {
  std::string library, line;
};
void PrintTo(const Refused& refused, std::ostream* out) {
  *out << refused.library;
}
class ProgramRefuses : public testing::TestWithParam<Refused> {};

TEST_P(ProgramRefuses, WithOneLineAndExitTwo) {
  const CaseRun run(GetParam().library);
  EXPECT_EQ(run.outcome.code, 2) << run.outcome.text;
  EXPECT_TRUE(run.says(GetParam().line)) << run.outcome.text;
  EXPECT_FALSE(std::filesystem::exists(run.out())) << "something was written";
}

INSTANTIATE_TEST_SUITE_P(
    All, ProgramRefuses,
    testing::Values(
        Refused{"wrong-major",
                "wrong-major.so: speaks version 1.0 of the plugin boundary, this program 0.2; another major "
                "version is another language: rebuild it with this program's SDK\n"},
        Refused{"newer-minor",
                "newer-minor.so: needs version 0.8 of the plugin boundary, this program speaks 0.2; use a "
                "newer Riffle, or rebuild it with this program's SDK\n"},
        Refused{"missing-symbol",
                "missing-symbol.so: is a shared library, but no plugin of Riffle: it does not export "
                "riffle_plugin_entry\n"},
        Refused{"default-out-of-range",
                "default-out-of-range.so: drag \"default-out-of-range\": parameter "
                "\"coefficient\": default 3 is outside [0, 1]\n"},
        Refused{"throws-in-create",
                "case.toml: drag \"throws-in-create\" cannot be created: an exception left the "
                "plugin: no memory for the table of roughness\n"},
        Refused{"refuses-create",
                "case.toml: drag \"refuses-create\" cannot be created: coefficient = 0.01 does not suit "
                "this bed\n"},
        Refused{"throws-in-run",
                "case.toml: drag \"throws-in-run\": pass \"friction\": fails on made-up numbers: an "
                "exception left the plugin: particle 0 is not in the table of roughness\n"},
        Refused{"nan-in-run",
                "case.toml: drag \"nan-in-run\": pass \"friction\": \"drag_rate\" is no number, or not "
                "written\n"},
        Refused{"writes-past-block",
                "case.toml: drag \"writes-past-block\": pass \"friction\": writes past the end of "
                "\"drag_rate\"\n"},
        Refused{"negative-drag",
                "case.toml: drag \"negative-drag\": pass \"friction\": \"drag_rate\" is -0.238847; it "
                "must not be negative\n"}),
    [](const auto& info) {
      std::string name = info.param.library;
      for (char& c : name) c = c == '-' ? '_' : c;
      return name;
    });

TEST(Program, ATextFileInsteadOfALibraryIsNamed) {
  const Folder folder;
  folder.write("roughness.so", "this is not a library\n");
  const auto manifest = folder.write("case.toml", case_with("roughness"));
  const Outcome outcome = riffle_program("run " + manifest.string() + " --out " + (folder.path() / "out").string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(hostile::without_folder(outcome.text, folder.path())
                .find("roughness.so: is not a shared library (no ELF file)\n"),
            std::string::npos)
      << outcome.text;
}

TEST(Program, OneIdTwiceInAFolderIsAnErrorThatNamesBoth) {
  const Folder folder;
  folder.take("duplicate-one");
  folder.take("duplicate-two");
  const auto manifest = folder.write("case.toml", case_with("duplicate"));
  const Outcome outcome = riffle_program("run " + manifest.string() + " --out " + (folder.path() / "out").string());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(
      hostile::without_folder(outcome.text, folder.path())
          .find("duplicate-two.so: drag \"duplicate\" is also in duplicate-one.so; one directory may hold it once "
                "only, so neither is used\n"),
      std::string::npos)
      << outcome.text;
}

TEST(Program, FastMathIsUndoneAndTheRunGoesOn) {
  const CaseRun run("fast-math");
  EXPECT_EQ(run.outcome.code, 0) << run.outcome.text;
}

// ---- what only shows while it runs: exit 1, what is there is kept ----

struct Stopped {
  std::string library, line;
};
void PrintTo(const Stopped& stopped, std::ostream* out) {
  *out << stopped.library;
}
class ProgramStops : public testing::TestWithParam<Stopped> {};

TEST_P(ProgramStops, NamesThePluginAndKeepsTheLastState) {
  const CaseRun run(GetParam().library);
  EXPECT_EQ(run.outcome.code, 1) << run.outcome.text;
  EXPECT_TRUE(run.says(GetParam().line)) << run.outcome.text;
  EXPECT_NE(hostile::contents(run.out() / "run.json").find("\"status\": \"failed\""), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(run.out() / "failed.hdf"));
}

INSTANTIATE_TEST_SUITE_P(
    All, ProgramStops,
    testing::Values(Stopped{"late-error", "drag late-error: friction: the table of roughness ends at 1 s\n"},
                    Stopped{"late-throw",
                            "drag late-throw: friction: an exception left the plugin: particle 0 is not in "
                            "the table of roughness\n"},
                    Stopped{"late-negative", "drag late-negative: friction: drag_rate = -0.9"},
                    Stopped{"late-nan", "drag late-nan: friction: drag_rate is no number at particle 3\n"}),
    [](const auto& info) { return info.param.library.substr(5); });

// ---- the other commands ----

TEST(Program, ListShowsTheGoodAndTellsWhyTheBadAreLeftOut) {
  const Folder folder;
  folder.take("good");
  folder.take("wrong-major");
  const Outcome outcome = riffle_program("list --plugin-path " + folder.path().string());
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.text.find("a plugin of the tests"), std::string::npos) << outcome.text;
  EXPECT_NE(outcome.text.find("wrong-major.so: speaks version 1.0"), std::string::npos) << outcome.text;
}

TEST(Program, CheckEndsWithOneForABadLibraryAndTwoForNone) {
  EXPECT_EQ(riffle_program("check " + hostile::library("good").string()).code, 0);
  EXPECT_EQ(riffle_program("check " + hostile::library("crashes-on-load").string()).code, 1);
  EXPECT_EQ(riffle_program("check " + hostile::library("nobody").string()).code, 2);
}

TEST(Program, NewRefusesInOneLine) {
  const Folder folder;
  const std::string here = " --folder " + (folder.path() / "made").string();
  const Outcome kind = riffle_program("new drog my-drag" + here);
  EXPECT_EQ(kind.code, 2);
  EXPECT_EQ(kind.text,
            "there is no kind \"drog\"; kinds are equations, kernel, viscosity, drag, turbulence, boundary, filter, "
            "bed, width, porosity, reference; did you mean \"drag\"?\n");
  const Outcome id = riffle_program("new drag My_Drag" + here);
  EXPECT_EQ(id.code, 2);
  EXPECT_EQ(id.text, "\"My_Drag\" is no name for a plugin: small letters, digits and hyphens, such as my-drag\n");
  const Outcome taken = riffle_program("new viscosity monaghan" + here);
  EXPECT_EQ(taken.code, 2);
  EXPECT_NE(taken.text.find("there is a viscosity \"monaghan\" already ("), std::string::npos) << taken.text;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "made"));
  EXPECT_EQ(riffle_program("new drag my-drag" + here).code, 0);
  EXPECT_EQ(riffle_program("new drag my-drag" + here).text, (folder.path() / "made").string() + " exists already\n");
}

}  // namespace
}  // namespace riffle
