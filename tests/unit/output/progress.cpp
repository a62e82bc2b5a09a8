#include "host/output/progress.hpp"

#include <algorithm>
#include <sstream>

#include "temporary_folder.hpp"

namespace riffle {
namespace {

struct Fixture {
  double now = 100;
  std::ostringstream out;
  std::function<double()> clock = [this] { return now; };
};

TEST(Progress, WritesALineEveryFewSecondsWhenNobodyWatches) {
  Fixture f;
  Progress progress(ProgressStyle::lines, {0, 10, 0, 0}, f.out, f.clock);
  for (int step = 1; step <= 80; ++step) {
    f.now += 0.125;
    progress.update(0.0625 * step, step, 0.0625, "courant");
  }
  const std::string text = f.out.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_TRUE(contains(text, "50.0 %  t = 5 / 10 s  step 80  dt = 6.25e-02 s (courant)  0:10 left")) << text;
}

TEST(Progress, RedrawsTheBarTenTimesASecondAtMost) {
  Fixture f;
  Progress progress(ProgressStyle::bar, {0, 1, 0, 0}, f.out, f.clock);
  for (int step = 1; step <= 1000; ++step) {
    f.now += 0.001;
    progress.update(0.001 * step, step, 0.001, "courant");
  }
  const std::string text = f.out.str();
  const auto redrawn = std::count(text.begin(), text.end(), '\r');
  EXPECT_LE(redrawn, 10);
  EXPECT_GE(redrawn, 8);
  EXPECT_FALSE(contains(text, "\n"));
}

TEST(Progress, EndsTheLineOfTheBar) {
  Fixture f;
  {
    Progress progress(ProgressStyle::bar, {0, 1, 0, 0}, f.out, f.clock);
    f.now += 1;
    progress.update(0.5, 1, 0.5, "courant");
  }
  EXPECT_EQ(f.out.str().back(), '\n');
}

TEST(Progress, SaysAtTheEndHowLongItTook) {
  Fixture f;
  Progress progress(ProgressStyle::lines, {0, 1, 0, 0}, f.out, f.clock);
  f.now += 3725;
  progress.update(1, 1, 1, "end");
  progress.finish();
  EXPECT_TRUE(contains(f.out.str(), "100.0 %")) << f.out.str();
  EXPECT_TRUE(contains(f.out.str(), "in 1:02:05")) << f.out.str();
}

TEST(Progress, OfAResumedRunIsThatOfWhatIsLeftToDo) {
  Fixture f;
  Progress progress(ProgressStyle::lines, {8, 10, 800, 0}, f.out, f.clock);
  f.now += 10;
  progress.update(9, 900, 0.01, "courant");
  EXPECT_TRUE(contains(f.out.str(), " 50.0 %")) << f.out.str();
  EXPECT_TRUE(contains(f.out.str(), "0:10 left")) << f.out.str();
}

TEST(Progress, CountsStepsWhereTheyAreWhatEndsTheRun) {
  Fixture f;
  Progress progress(ProgressStyle::lines, {0, 1e9, 0, 200}, f.out, f.clock);
  f.now += 10;
  progress.update(0.1, 50, 0.01, "courant");
  EXPECT_TRUE(contains(f.out.str(), " 25.0 %")) << f.out.str();
}

TEST(Progress, IsSilentWhenAskedToBe) {
  Fixture f;
  {
    Progress progress(ProgressStyle::silent, {0, 1, 0, 0}, f.out, f.clock);
    f.now += 100;
    progress.update(0.5, 1, 0.5, "courant");
    progress.finish();
  }
  EXPECT_EQ(f.out.str(), "");
  EXPECT_EQ(progress_style(true), ProgressStyle::silent);
}

}  // namespace
}  // namespace riffle
