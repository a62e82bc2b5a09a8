#include "host/study/results.hpp"

#include <gtest/gtest.h>

#include "host/study/relative.hpp"
#include "host/study/tables.hpp"

namespace riffle {
namespace {

PointResult point(const std::string& closure, const std::string& kernel, const std::string& count, double error,
                  double cost) {
  PointResult result;
  result.point.case_name = result.point.case_title = "dam";
  result.point.closure = closure;
  result.point.varied = {{"kernel", kernel}};
  result.point.line = closure + ", kernel = " + kernel;
  result.point.resolution = count;
  result.point.resolution_name = "count";
  result.ending = Ending::good;
  result.errors = {error};
  result.cost = result.cost_low = result.cost_high = cost;
  result.repeats_done = 1;
  result.spacing = 1 / std::stod(count);
  return result;
}

StudyResults two_closures_with_two_kernels() {
  StudyResults results;
  results.name = results.title = "s";
  results.cost = "cpu_seconds";
  results.errors = {"errors.depth.l1"};
  results.baseline = "a";
  for (const char* closure : {"a", "b"}) {
    for (const char* kernel : {"cubic", "quintic"}) {
      const double factor = closure[0] == 'a' ? 1 : 0.5;  // b has half the error at the same cost
      results.points.push_back(point(closure, kernel, "100", factor * 0.04, 1));
      results.points.push_back(point(closure, kernel, "200", factor * 0.02, 4));
      results.points.push_back(point(closure, kernel, "400", factor * 0.01, 16));
    }
  }
  return results;
}

TEST(Lines, RunOverResolutionAndShowClosuresByColourAndTheRestByMark) {
  const StudyResults results = two_closures_with_two_kernels();
  const auto lines = lines_of(results);
  ASSERT_EQ(lines.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(lines[k].points.size(), 3U);
    EXPECT_EQ(lines[k].colour, k / 2);
    EXPECT_EQ(lines[k].mark, k % 2);
  }
}

TEST(Lines, AreMeasuredAgainstTheBaselineWithTheSameKernel) {
  const StudyResults results = two_closures_with_two_kernels();
  const auto lines = lines_of(results);
  const ResultLine* const base = baseline_of(lines[3], lines, results.baseline);
  ASSERT_EQ(base, &lines[1]);
  const auto relative = relative_to(*base, lines[3], 0);
  ASSERT_EQ(relative.size(), 3U);
  EXPECT_FALSE(relative[0].cost.has_value());  // b has no resolution as coarse as that
  EXPECT_NEAR(relative[1].cost.value(), 0.25, 1e-12);
  EXPECT_NEAR(relative[1].error.value(), 0.5, 1e-12);
}

TEST(Lines, ConvergeAtTheOrderOfTheirErrors) {
  const StudyResults results = two_closures_with_two_kernels();
  EXPECT_NEAR(order_of(lines_of(results)[0], 0), 1, 1e-12);
}

TEST(Front, LeavesOutWhatIsBeatenAndWhatDidNotFinish) {
  StudyResults results = two_closures_with_two_kernels();
  results.points.push_back(point("c", "cubic", "100", 1e-9, 1e-9));
  results.points.back().ending = Ending::blew_up;
  const auto front = front_of(results, "dam", 0);
  ASSERT_EQ(front.size(), 3U);
  for (const PointResult* best : front) EXPECT_EQ(best->point.closure, "b");
}

TEST(Tables, QuoteWhatHoldsAComma) {
  StudyResults results = two_closures_with_two_kernels();
  results.points.resize(1);
  results.points[0].message = "t = 3 s, a \"word\"";
  const std::string csv = results_in_csv(results);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "case,closure,kernel,count,state,message,time_s,errors.depth.l1,cpu_seconds,cpu_seconds.min,cpu_seconds."
            "max,repeats,"
            "same_bits,particles,steps,command");
  EXPECT_NE(csv.find("dam,a,cubic,100,finished,\"t = 3 s, a \"\"word\"\"\",0,0.04,1,1,1,1,yes,0,0,"), std::string::npos)
      << csv;
}

}  // namespace
}  // namespace riffle
