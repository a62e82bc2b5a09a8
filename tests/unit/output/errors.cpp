#include "host/output/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "host/output/sum.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

struct Sample {
  std::vector<double> computed, exact, scale, measure;
  std::vector<std::uint8_t> counts;
  [[nodiscard]] FieldErrors errors() const { return field_errors({computed, exact, scale, measure, counts}); }
};

TEST(Errors, AreThoseOfTheFormulas) {
  // Differences 1, 0, -2; relative to the scale 0.5, 0, -0.5.
  const Sample s{{3, 1, 2}, {2, 1, 4}, {2, 1, 4}, {0.5, 1, 0.25}, {1, 1, 1}};
  const FieldErrors e = s.errors();
  EXPECT_DOUBLE_EQ(e.l2, std::sqrt((0.25 + 0 + 0.25) / 3));
  EXPECT_DOUBLE_EQ(e.l1, (1 * 0.5 + 2 * 0.25) / (2 * 0.5 + 1 * 1 + 4 * 0.25));
  EXPECT_DOUBLE_EQ(e.linf, 0.5);
  EXPECT_DOUBLE_EQ(e.mean, 0);  // what is too much here is missing there
  const Sample less{{1, 1}, {2, 1}, {2, 1}, {0.5, 1}, {1, 1}};
  EXPECT_DOUBLE_EQ(less.errors().mean, 1 * 0.5 / (2 * 0.5 + 1 * 1));
  EXPECT_EQ(e.count, 3);
  EXPECT_EQ(e.ignored, 0);
  EXPECT_EQ(e.normalisation, "exact");
}

TEST(Errors, AParticleLeftOutChangesNothingButTheCount) {
  const Sample s{{3, 99, 1, 2}, {2, 0, 1, 4}, {2, 1, 1, 4}, {0.5, 9, 1, 0.25}, {1, 0, 1, 1}};
  const Sample t{{3, 1, 2}, {2, 1, 4}, {2, 1, 4}, {0.5, 1, 0.25}, {1, 1, 1}};
  EXPECT_EQ(s.errors().l1, t.errors().l1);
  EXPECT_EQ(s.errors().l2, t.errors().l2);
  EXPECT_EQ(s.errors().linf, t.errors().linf);
  EXPECT_EQ(s.errors().count, 3);
  EXPECT_EQ(s.errors().ignored, 1);
}

TEST(Errors, WithoutAScaleAParticleIsIgnored) {
  const Sample s{{1, 1, 1}, {0, 1, 1}, {0, 1, std::nan("")}, {1, 1, 1}, {1, 1, 1}};
  EXPECT_EQ(s.errors().count, 1);
  EXPECT_EQ(s.errors().ignored, 2);
  EXPECT_EQ(s.errors().l2, 0);
}

TEST(Errors, OfAFieldThatIsExactlyZeroAreDividedByTheScale) {
  const Sample s{{0.1, -0.1}, {0, 0}, {2, 2}, {1, 1}, {1, 1}};
  EXPECT_EQ(s.errors().normalisation, "scale");
  EXPECT_DOUBLE_EQ(s.errors().l1, 0.2 / 4);
}

TEST(Errors, RoundOffIsNoReasonToDivideByIt) {
  const Sample s{{0.1, -0.1}, {1e-16, -1e-16}, {2, 2}, {1, 1}, {1, 1}};
  EXPECT_EQ(s.errors().normalisation, "scale");
}

TEST(Errors, ANotANumberIsNeverHidden) {
  const double nan = std::nan("");
  const Sample s{{1, nan, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  EXPECT_TRUE(std::isnan(s.errors().l1));
  EXPECT_TRUE(std::isnan(s.errors().l2));
  EXPECT_TRUE(std::isnan(s.errors().linf));
}

TEST(Errors, OfNoParticleAreNotANumber) {
  const Sample s{{1}, {1}, {1}, {1}, {0}};
  EXPECT_TRUE(std::isnan(s.errors().l1));
  EXPECT_TRUE(std::isnan(s.errors().l2));
  EXPECT_TRUE(std::isnan(s.errors().linf));
}

TEST(Errors, DoNotDependOnTheOrderOfTheParticles) {
  // 100 000 terms: a plain sum would differ by up to n eps = 2e-11 between orders, the compensated one by eps at most.
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.5, 1.5);
  Sample s;
  for (int i = 0; i < 100000; ++i) {
    s.exact.push_back(10 * part(random));
    s.computed.push_back(s.exact.back() * part(random));
    s.scale.push_back(s.exact.back());
    s.measure.push_back(1e-3 * part(random));
  }
  s.counts.assign(s.exact.size(), 1);
  Sample r = s;
  for (auto* v : {&r.computed, &r.exact, &r.scale, &r.measure}) std::reverse(v->begin(), v->end());
  EXPECT_NEAR(s.errors().l1, r.errors().l1, 1e-15 * s.errors().l1);
  EXPECT_NEAR(s.errors().l2, r.errors().l2, 1e-15 * s.errors().l2);
}

TEST(CompensatedSum, KeepsWhatAPlainSumLoses) {
  CompensatedSum sum;
  for (const double term : {1.0, 1e100, 1.0, -1e100}) sum.add(term);
  EXPECT_EQ(sum.value(), 2);
}

TEST(CompensatedSum, OfAnInfinityIsInfinite) {
  CompensatedSum sum;
  for (const double term : {1.0, std::numeric_limits<double>::infinity(), 1.0}) sum.add(term);
  EXPECT_EQ(sum.value(), std::numeric_limits<double>::infinity());
}

TEST(Extrema, AreThoseOfTheValues) {
  const std::vector<double> values{1, -3, 2};
  EXPECT_EQ(extrema(values).min, -3);
  EXPECT_EQ(extrema(values).max, 2);
  EXPECT_EQ(extrema(values).max_abs, 3);
}

TEST(Extrema, OfNothingAndOfANotANumberAreNotANumber) {
  EXPECT_TRUE(std::isnan(extrema({}).max_abs));
  const std::vector<double> values{1, std::nan(""), 2};
  EXPECT_TRUE(std::isnan(extrema(values).min));
}

}  // namespace
}  // namespace riffle
