// What `riffle check` finds in each hostile library, whose crashes must not be its own.
#include "host/plugins/check/check.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/hostile/files.hpp"

namespace riffle {
namespace {

// The address sanitizer reports a crash itself and then ends the process.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RIFFLE_UNDER_ADDRESS_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define RIFFLE_UNDER_ADDRESS_SANITIZER
#endif
#if defined(RIFFLE_UNDER_ADDRESS_SANITIZER)
const std::string crash = "ends the whole program with status 1";
constexpr int slower = 10;
#else
const std::string crash = "crashes: Segmentation fault";
constexpr int slower = 1;
#endif

struct Result {
  int status = 0;
  std::vector<std::string> failures;  // "check: reason"
  std::string text;
};

Result check(const std::filesystem::path& file) {
  std::ostringstream out;
  Result result;
  result.status = check_library(file, out, std::chrono::seconds(3 * slower));
  result.text = out.str();
  std::istringstream lines(result.text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  FAIL  ")) continue;
    const std::string name = line.substr(8, line.find(' ', 8) - 8);
    result.failures.push_back(name + ": " + hostile::without_folder(line.substr(20)));
  }
  return result;
}

// The first thing that is found; everything later may follow from it.
std::string first_failure(const std::string& name) {
  const Result result = check(hostile::library(name));
  EXPECT_EQ(result.status, 1) << result.text;
  return result.failures.empty() ? "nothing" : result.failures.front();
}

// The only check that fails.
std::string only_failure(const std::string& name) {
  const Result result = check(hostile::library(name));
  EXPECT_EQ(result.status, 1) << result.text;
  return result.failures.size() == 1 ? result.failures.front() : result.text;
}

TEST(Check, AGoodPluginPassesWithALineForEachCheck) {
  const Result result = check(hostile::library("good"));
  EXPECT_EQ(result.status, 0) << result.text;
  // the library may take its time to load, on a busy machine: a warning
  for (const char* name :
       {"creation", "contract", "bounds", "writes", "inputs", "blocks", "threads", "dimensions", "votes", "speed"}) {
    EXPECT_NE(result.text.find("  ok    " + std::string(name)), std::string::npos) << name << '\n' << result.text;
  }
}

TEST(Check, WhatCannotBeLoadedIsSaidInOneLine) {
  EXPECT_EQ(only_failure("missing-symbol"),
            "library: missing-symbol.so: is a shared library, but no plugin of Riffle: it does not export "
            "riffle_plugin_entry");
  EXPECT_EQ(only_failure("nobody"), "library: nobody.so: cannot be read");
}

TEST(Check, ACrashWhileLoadingIsAFailure) {
  EXPECT_EQ(only_failure("crashes-on-load"), "library: " + crash);
}

TEST(Check, ACrashInCreateIsAFailure) {
  EXPECT_EQ(first_failure("crashes-in-create"), "creation: " + crash);
}

TEST(Check, AnExitOfTheWholeProgramIsAFailure) {
  EXPECT_EQ(first_failure("exits-in-create"), "creation: ends the whole program with status 0");
}

TEST(Check, ALoopWithoutEndIsEnded) {
  std::ostringstream out;
  EXPECT_EQ(check_library(hostile::library("endless-run"), out, std::chrono::milliseconds(200 * slower)), 1);
  const std::string seconds = slower == 1 ? "0.2" : std::to_string(slower / 5);
  EXPECT_NE(out.str().find("  FAIL  contract    is not done after " + seconds + " s\n"), std::string::npos)
      << out.str();
}

TEST(Check, AnExceptionInRunIsAFailure) {
  EXPECT_EQ(
      first_failure("throws-in-run"),
      "contract: drag \"throws-in-run\": pass \"friction\": fails on made-up numbers: an exception left the plugin: "
      "particle 0 is not in the table of roughness in 1D");
}

TEST(Check, ChangedArithmeticIsAFailure) {
  EXPECT_TRUE(first_failure("fast-math").starts_with("library: fast-math.so: changes the floating-point arithmetic"));
  EXPECT_EQ(first_failure("changes-rounding"),
            "creation: drag \"changes-rounding\" changes the floating-point arithmetic of the whole program in create");
}

TEST(Check, AThreadOfItsOwnIsAFailure) {
  EXPECT_EQ(first_failure("starts-thread"), "library: starts a thread when loaded");
}

TEST(Check, MoreThanOneSymbolIsAFailure) {
  EXPECT_EQ(
      only_failure("exports-more"),
      "library: exports 1 symbol(s) besides riffle_plugin_entry (helper_of_mine); hidden visibility keeps them from "
      "mixing with those of other libraries");
}

TEST(Check, AWritePastTheBlockIsAFailure) {
  EXPECT_EQ(first_failure("writes-past-block"),
            "contract: drag \"writes-past-block\": pass \"friction\": writes past the end of \"drag_rate\" in 1D");
}

TEST(Check, AWriteToAnInputIsAFailure) {
  EXPECT_EQ(only_failure("writes-inputs"),
            "inputs: " + crash + "; its inputs are read-only here, so it probably writes to them");
}

TEST(Check, ALookAtOtherParticlesIsAFailure) {
  const std::string text = only_failure("peeks-at-others");
  EXPECT_TRUE(text.starts_with("blocks: pass \"friction\": \"drag_rate\" of one particle is ")) << text;
  EXPECT_TRUE(text.ends_with("; it must depend on nothing else in the block")) << text;
}

TEST(Check, StateBetweenCallsIsAFailure) {
  const std::string text = first_failure("remembers");
  EXPECT_TRUE(text.starts_with("blocks: pass \"friction\": \"drag_rate\" of one particle is ")) << text;
}

TEST(Check, AConstantWithAHiddenUnitIsAFailure) {
  const std::string text = only_failure("hidden-unit");
  EXPECT_TRUE(
      text.starts_with("dimensions: pass \"friction\": \"drag_rate\" [s-1] changes by a factor that its unit does "
                       "not explain when metres are rescaled (error "))
      << text;
}

TEST(Check, ABrokenContractIsAFailure) {
  EXPECT_EQ(first_failure("wrong-integral"),
            "contract: kernel \"wrong-integral\": its integral over space is 0.682092613251, but it says 1 in 1D");
  EXPECT_EQ(
      first_failure("negative-drag"),
      "contract: drag \"negative-drag\": pass \"friction\": \"drag_rate\" is -0.238847; it must not be negative in 1D");
}

}  // namespace
}  // namespace riffle
