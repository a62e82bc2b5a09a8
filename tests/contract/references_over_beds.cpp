// References that know the bed and the width of the scene.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/contract/csv.hpp"
#include "tests/contract/reference_case.hpp"

namespace riffle::contract {
namespace {

constexpr double g = 9.81;

Channel with_step(double position, double height) {
  return {0, 2 * position, [=](double x) { return x < position ? 0.0 : height; }, [](double) { return 1.0; }};
}

struct StepRow {
  std::vector<std::string> cells;
  [[nodiscard]] double number(std::size_t k) const { return std::stod(cells[k]); }
};
void PrintTo(const StepRow& row, std::ostream* out) {
  *out << row.cells[0] << ", " << row.cells[4];
}
std::vector<StepRow> step_rows() {
  std::vector<StepRow> all;
  for (auto& cells : rows("riemann_over_step.csv")) all.push_back({cells});
  return all;
}

class RiemannOverStep : public testing::TestWithParam<StepRow> {
 protected:
  const StepRow& row = GetParam();
  [[nodiscard]] std::map<std::string, double> given(double left, double right) const {
    return {{"dam_position", 10},
            {"depth_left", left},
            {"depth_right", right},
            {"conserves", row.cells[4] == "momentum" ? 1 : 0}};
  }
};

TEST_P(RiemannOverStep, IsTheSolutionTabulated) {  // to the digits printed
  const ReferenceCase exact("riemann-over-step", given(row.number(1), row.number(2)), with_step(10, row.number(3)));
  EXPECT_NEAR(exact.at(9.9999, 1).depth, row.number(5), 5.1e-7);
  EXPECT_NEAR(exact.at(9.9999, 1).velocity, row.number(6), 5.1e-7);
  EXPECT_NEAR(exact.at(10.0001, 1).depth, row.number(7), 5.1e-7);
  EXPECT_NEAR(exact.at(10.0001, 1).velocity, row.number(8), 5.1e-7);
  const double front = 10 + row.number(9);
  EXPECT_GT(exact.at(front - 1e-6, 1).velocity, 0);
  EXPECT_EQ(exact.at(front + 1e-6, 1).velocity, 0);
  EXPECT_EQ(exact.at(front + 1e-6, 1).depth, row.number(2));
}

TEST_P(RiemannOverStep, IsTheSameSeenFromTheOtherSide) {
  const ReferenceCase one("riemann-over-step", given(row.number(1), row.number(2)), with_step(10, row.number(3)));
  Channel mirrored{0, 20, [&](double x) { return x < 10 ? row.number(3) : 0.0; }, [](double) { return 1.0; }};
  const ReferenceCase other("riemann-over-step", given(row.number(2), row.number(1)), mirrored);
  for (double x = 0.05; x < 20; x += 0.1) {
    EXPECT_NEAR(other.at(20 - x, 1).depth, one.at(x, 1).depth, 1e-12);
    EXPECT_NEAR(other.at(20 - x, 1).velocity, -one.at(x, 1).velocity, 1e-12);
  }
}
INSTANTIATE_TEST_SUITE_P(Rows, RiemannOverStep, testing::ValuesIn(step_rows()));

// The dam break of cases/step: figures found independently, to the digits given.
TEST(RiemannOverAStep, HasTheStatesOfTheCase) {
  const ReferenceCase head("riemann-over-step", {{"dam_position", 10}, {"depth_left", 5}, {"depth_right", 2}},
                           with_step(10, 1));
  EXPECT_NEAR(head.at(9.99, 1).depth, 4.04225, 5.1e-6);
  EXPECT_NEAR(head.at(9.99, 1).velocity, 1.41278, 5.1e-6);
  EXPECT_NEAR(head.at(10.01, 1).depth, 2.95341, 5.1e-6);
  EXPECT_NEAR(head.at(10.01, 1).velocity, 1.93364, 5.1e-6);
  EXPECT_EQ(head.at(10.01 + 5.99, 1).depth, 2);
  EXPECT_GT(head.at(10 + 5.989, 1).depth, 2.9);
}

// On a step down the head-conserving states must solve the equations that define them.
TEST(RiemannOverAStep, KeepsMassAndHeadOverAStepDown) {
  const ReferenceCase exact("riemann-over-step", {{"dam_position", 10}, {"depth_left", 3}, {"depth_right", 2.5}},
                            with_step(10, -0.5));
  const WaterState up = exact.at(9.9999, 1), down = exact.at(10.0001, 1);
  EXPECT_NEAR(up.depth * up.velocity, down.depth * down.velocity, 1e-13);
  EXPECT_NEAR(up.depth + up.velocity * up.velocity / (2 * g),
              down.depth + down.velocity * down.velocity / (2 * g) - 0.5, 1e-13);
}

TEST(RiemannOverAStep, IsStokersOnALevelBed) {
  const std::map<std::string, double> given{{"dam_position", 10}, {"depth_left", 3}, {"depth_right", 2}};
  const ReferenceCase step("riemann-over-step", given, with_step(10, 0)), stoker("stoker", given);
  for (double x = 0.05; x < 20; x += 0.1) {
    EXPECT_NEAR(step.at(x, 1).depth, stoker.at(x, 1).depth, 1e-12) << x;
    EXPECT_NEAR(step.at(x, 1).velocity, stoker.at(x, 1).velocity, 1e-12) << x;
  }
}

TEST(RiemannOverAStep, IsALakeWhereTheLevelsAreEqual) {
  const ReferenceCase lake("riemann-over-step", {{"dam_position", 10}, {"depth_left", 3}, {"depth_right", 2}},
                           with_step(10, 1));
  for (double x = 0.05; x < 20; x += 0.1) {
    EXPECT_NEAR(lake.at(x, 1).depth, x < 10 ? 3 : 2, 1e-12);
    EXPECT_NEAR(lake.at(x, 1).velocity, 0, 1e-7);  // a difference of square roots of depths that agree to 1e-15
  }
}

TEST(RiemannOverAStep, RefusesCriticalFlowOverTheStep) {
  try {
    const ReferenceCase exact("riemann-over-step", {{"dam_position", 10}, {"depth_left", 5}, {"depth_right", 0.3}},
                              with_step(10, 1));
    FAIL() << "critical flow was accepted";
  } catch (const Refused& refused) {
    EXPECT_STREQ(refused.what(),
                 "riemann-over-step has no answer for depths of 5 m and 0.3 m here: the flow would become critical at "
                 "the step");
  }
}

TEST(SteadyFlow, TakesBedWidthAndEndsFromTheScene) {
  const ReferenceCase step("steady-flow", {{"discharge", 4.8246}, {"depth_downstream", 2.273}}, with_step(10, 1));
  EXPECT_NEAR(step.at(5, 0).depth, 3.4, 5e-6);
  EXPECT_NEAR(step.at(5, 99).velocity, 1.419, 5e-5);
  EXPECT_DOUBLE_EQ(step.at(15, 0).velocity_scale, std::sqrt(g * 2.273));
  Channel narrow{0, 10, [](double) { return 0.0; }, [](double x) { return x < 5 ? 2.0 : 1.0; }};
  const ReferenceCase pipe("steady-flow", {{"discharge", 2}, {"depth_downstream", 2}}, narrow);
  EXPECT_DOUBLE_EQ(pipe.at(9, 0).velocity, 1);
  EXPECT_NEAR(pipe.at(1, 0).velocity * pipe.at(1, 0).depth, 1, 1e-14);
}

// The 1 ft flume at 0.0145 m3/s: critical at the entrance of the throat, h_c = 0.0613 m, and 0.0901 m of water upstream,
// where the theory leaves out the losses that make the standard rating 0.0791 m at the gauge.
TEST(SteadyFlow, GivesCriticalFlowInAParshallFlume) {
  const Instance bed(plugin("bed", "parshall"), 1, {{"crest", 3}}),
      width(plugin("width", "parshall"), 1, {{"crest", 3}});
  const auto of = [](const Instance& shape, double x) {
    double value = 0;
    riffle_error error{sizeof(riffle_error), {}};
    shape.table().evaluate_profile(shape.self(), 1, &x, nullptr, &value, nullptr, nullptr, &error);
    return value;
  };
  Channel flume{0, 6, [&](double x) { return of(bed, x); }, [&](double x) { return of(width, x); }};
  const ReferenceCase flow("steady-flow", {{"discharge", 0.0145}}, flume);
  EXPECT_NEAR(flow.at(0, 0).depth, 0.0901, 1e-4);
  EXPECT_NEAR(flow.at(3, 0).depth, 0.0613, 1e-4);
  EXPECT_NEAR(flow.at(3, 0).velocity / std::sqrt(g * flow.at(3, 0).depth), 1, 1e-6);
  for (const double x : {3.3, 3.61, 4.0, 4.525, 6.0}) EXPECT_LT(flow.at(x, 0).depth, 0.04) << "supercritical at " << x;
}

TEST(SteadyFlow, SaysWhatCannotBe) {
  try {
    const ReferenceCase flow("steady-flow", {{"discharge", 0.18}, {"depth_downstream", 0.05}}, with_step(10, 0));
    FAIL() << "a supercritical outflow was given a depth";
  } catch (const Refused& refused) {
    EXPECT_STREQ(refused.what(),
                 "depth_downstream is below the critical depth there, and a supercritical outflow takes its depth from "
                 "upstream; leave it out");
  }
}

TEST(StillWater, IsLevelOverAStepAndNowhereWhereTheBedStandsOutOfIt) {
  const ReferenceCase lake("still-water", {{"level", 3}}, with_step(10, 1));
  EXPECT_EQ(lake.at(9.9, 5).depth, 3);
  EXPECT_EQ(lake.at(10, 5).depth, 2);
  EXPECT_EQ(lake.at(12, 5).velocity, 0);
  EXPECT_DOUBLE_EQ(lake.at(12, 5).velocity_scale, std::sqrt(2 * g));
  const ReferenceCase pond("still-water", {{"level", 0.5}}, with_step(10, 1));
  EXPECT_TRUE(pond.at(1, 0).defined);
  EXPECT_FALSE(pond.at(11, 0).defined);
}

}  // namespace
}  // namespace riffle::contract
