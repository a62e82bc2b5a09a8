#include "host/study/plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace riffle {
namespace {

Choice choice(const std::string& label, const std::vector<std::string>& overrides, int line) {
  Choice made{label, {}, {"s.toml", line, 1}};
  for (const std::string& text : overrides) {
    made.overrides.push_back({text.substr(0, text.find('=')), text, {"s.toml", line, 5}});
  }
  return made;
}

bool has(const std::vector<std::string>& overrides, const std::string& text) {
  return std::find(overrides.begin(), overrides.end(), text) != overrides.end();
}

// A case whose viscosity "none" has no alpha, and which knows no other keys.
Trial attempt_made_up(const std::filesystem::path& manifest, const std::vector<std::string>& overrides) {
  Trial trial;
  trial.case_name = manifest.stem().string();
  trial.error_fields = {"depth", "velocity"};
  trial.identity = trial.case_name;
  for (const std::string& text : overrides) {
    trial.identity += ' ' + text;
    if (text.rfind("alpha=", 0) == 0 && has(overrides, "viscosity=none")) {
      trial.refusals.push_back("--set " + text + ": viscosity \"none\" has no parameter \"alpha\"");
    }
    if (text.rfind("alfa=", 0) == 0) trial.refusals.push_back("--set " + text + ": unknown key \"alfa\"");
    if (text == "kernel=odd" && has(overrides, "viscosity=none"))
      trial.refusals.emplace_back("nobody writes depth_rate");
  }
  return trial;
}

Study study_of_viscosities() {
  Study study;
  study.file = "s.toml";
  study.cases = {"dam.toml"};
  study.case_places = {{"s.toml", 3, 9}};
  study.vary.push_back(
      {"viscosity", {choice("none", {"viscosity=none"}, 5), choice("monaghan", {"viscosity=monaghan"}, 6)}});
  study.vary.push_back({"alpha", {choice("1", {"alpha=1"}, 7), choice("2", {"alpha=2"}, 8)}});
  return study;
}

std::string mistakes_of(const Study& study, bool many = false) {
  try {
    plan_study(study, attempt_made_up, many);
  } catch (const ManifestError& error) {
    return error.what();
  }
  return "";
}

TEST(Plan, IsTheProductWithoutWhatIsMeaningless) {
  const StudyPlan plan = plan_study(study_of_viscosities(), attempt_made_up, false);
  ASSERT_EQ(plan.points.size(), 2U);
  EXPECT_EQ(plan.points[1].line, "viscosity = monaghan, alpha = 2");
  EXPECT_EQ(plan.points[1].overrides, (std::vector<std::string>{"viscosity=monaghan", "alpha=2"}));
  ASSERT_EQ(plan.skipped.size(), 2U);
  EXPECT_EQ(plan.skipped[0].combination, "dam, viscosity = none, alpha = 1");
  EXPECT_EQ(plan.skipped[0].reason, "viscosity \"none\" has no parameter \"alpha\"");
}

TEST(Plan, TakesARefusalByTheScheduleAsAReasonToo) {
  Study study = study_of_viscosities();
  study.vary[1] = {"kernel", {choice("odd", {"kernel=odd"}, 7), choice("even", {"kernel=even"}, 8)}};
  const StudyPlan plan = plan_study(study, attempt_made_up, false);
  EXPECT_EQ(plan.points.size(), 3U);
  ASSERT_EQ(plan.skipped.size(), 1U);
  EXPECT_EQ(plan.skipped[0].reason, "nobody writes depth_rate");
}

TEST(Plan, ThatVariesAnUnknownKeyIsAMistakeAtItsPlace) {
  Study study = study_of_viscosities();
  study.vary[1] = {"alfa", {choice("1", {"alfa=1"}, 7)}};
  EXPECT_EQ(mistakes_of(study), "s.toml:7:5: unknown key \"alfa\"");
}

TEST(Plan, GivesEveryRepeatAndNumberOfThreadsAFolderOfItsOwn) {
  Study study = study_of_viscosities();
  study.repeats = 3;
  study.threads = {1, 2};
  const StudyPlan plan = plan_study(study, attempt_made_up, false);
  std::vector<std::string> folders;
  for (const StudyPoint& point : plan.points) folders.insert(folders.end(), point.folders.begin(), point.folders.end());
  EXPECT_EQ(folders.size(), 12U);
  std::sort(folders.begin(), folders.end());
  EXPECT_EQ(std::unique(folders.begin(), folders.end()), folders.end());
  EXPECT_EQ(plan.points[1].line, "viscosity = monaghan, alpha = 1, threads = 2");
}

TEST(Plan, OfTheSameStudyHasTheSameFolders) {
  const StudyPlan a = plan_study(study_of_viscosities(), attempt_made_up, false);
  const StudyPlan b = plan_study(study_of_viscosities(), attempt_made_up, false);
  EXPECT_EQ(a.points[0].folders, b.points[0].folders);
}

TEST(Plan, OfMoreRunsThanAllowedNeedsYes) {
  Study study = study_of_viscosities();
  study.runs_at_most = 3;
  EXPECT_EQ(
      mistakes_of(study),
      "s.toml: the study would have 4 runs (1 cases x 2 of viscosity x 2 of alpha), more than study.runs_at_most = 3; "
      "--yes runs them all the same");
  EXPECT_EQ(mistakes_of(study, true), "");
}

TEST(Plan, KnowsItsBaseline) {
  Study study = study_of_viscosities();
  study.baseline = "viscosity = monaghan, alpha = 3";
  study.baseline_place = {"s.toml", 4, 12};
  EXPECT_EQ(
      mistakes_of(study),
      "s.toml:4:12: the baseline \"viscosity = monaghan, alpha = 3\" is not in the study; did you mean \"viscosity = "
      "monaghan, alpha = 1\"?");
  study.baseline = "viscosity = monaghan, alpha = 2";
  EXPECT_EQ(mistakes_of(study), "");
}

TEST(Plan, JudgesByTheFirstErrorUnlessTheStudyNamesOne) {
  Study study = study_of_viscosities();
  EXPECT_EQ(plan_study(study, attempt_made_up, false).errors, std::vector<std::string>{"errors.depth.l1"});
  study.errors = {"errors.velocity.l2", "extrema.depth.max"};
  study.error_places = {{"s.toml", 4, 9}, {"s.toml", 4, 20}};
  EXPECT_EQ(plan_study(study, attempt_made_up, false).errors, study.errors);
  study.errors = {"errors.dpeth.l2"};
  EXPECT_EQ(mistakes_of(study), "s.toml:4:9: no case has \"errors.dpeth.l2\"; did you mean \"errors.depth.l2\"?");
}

}  // namespace
}  // namespace riffle
