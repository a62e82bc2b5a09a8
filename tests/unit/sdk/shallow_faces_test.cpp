#include "riffle/shallow_faces.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "riffle/limiters.hpp"

namespace riffle::test {
namespace {

constexpr double g = 9.81;

// One face: water h_left with velocity u_left on the bed b_left, and nothing on the bed b_right.
ShallowFaces face(double h_left, double u_left, double b_left, double b_right, double h_right = 0) {
  ShallowFaces faces{};
  faces.left.h[0] = h_left;
  faces.left.u[0] = u_left;
  faces.left.b[0] = b_left;
  faces.right.h[0] = h_right;
  faces.right.b[0] = b_right;
  return faces;
}

double head(double h, double u) {
  return h + u * u / (2 * g);
}

TEST(CommonBed, HeadAndDischargeAreKeptOverAStep) {
  for (const double u : {0.1, 1.4, -1.4, 11.0, -14.0}) {  // sub- and supercritical, both ways
    for (const double step : {0.01, 0.5, 0.9}) {
      ShallowFaces faces = face(3.4, u, 0, step);
      head_to_common_bed(g, 1, faces);
      const double h = faces.left.h_star[0], v = faces.left.u_star[0];
      EXPECT_NEAR(h * v, 3.4 * u, 1e-14 * 3.4 * std::abs(u));
      EXPECT_NEAR(step + head(h, v), head(3.4, u), 1e-14 * head(3.4, u));
      EXPECT_EQ(v * v < g * h, u * u < g * 3.4) << "stays sub- or supercritical";
    }
  }
}

TEST(CommonBed, ThePapersStepHasTheDepthsOfTheTheory) {
  ShallowFaces faces = face(3.4, 4.8246 / 3.4, 0, 1);
  head_to_common_bed(g, 1, faces);
  EXPECT_NEAR(faces.left.h_star[0], 2.27300, 5e-6);  // head-conserving step, five figures
}

TEST(CommonBed, AStepThatTheHeadCannotClimbIsAWeir) {
  ShallowFaces faces = face(2, 2, 0, 1.5);  // head 2.204 m: 0.704 m are left for the crest
  head_to_common_bed(g, 1, faces);
  const double left = head(2, 2) - 1.5;
  EXPECT_NEAR(faces.left.h_star[0], 2 * left / 3, 1e-15);
  EXPECT_NEAR(head(faces.left.h_star[0], faces.left.u_star[0]), left, 1e-15);
  EXPECT_LT(faces.left.h_star[0] * faces.left.u_star[0], 2 * 2);
  faces = face(2, 2, 0, 3);
  head_to_common_bed(g, 1, faces);
  EXPECT_EQ(faces.left.h_star[0], 0);
  EXPECT_EQ(faces.left.u_star[0], 0);
}

TEST(CommonBed, AtRestBothWaysAreTheSameAndOnEqualBedsNothingChanges) {
  for (const auto& bring : {+[](ShallowFaces& f) { head_to_common_bed(g, 1, f); },
                            +[](ShallowFaces& f) { still_water_to_common_bed(1, f); }}) {
    ShallowFaces faces = face(3, 0, 0, 1, 2);
    bring(faces);
    EXPECT_EQ(faces.left.h_star[0], 2);
    EXPECT_EQ(faces.right.h_star[0], 2);
    EXPECT_EQ(faces.left.u_star[0], 0);
    faces = face(0.3, 1.7, 0.7, 0.7, 0.1);
    bring(faces);
    EXPECT_EQ(faces.left.h_star[0], 0.3);
    EXPECT_EQ(faces.left.u_star[0], 1.7);
    faces = face(0.3, 0, 0, 1);  // the step stands out of the water
    bring(faces);
    EXPECT_EQ(faces.left.h_star[0], 0);
  }
}

TEST(CommonBed, TheLastBitsOfAFaceDoNotDependOnTheOthers) {
  ShallowFaces alone = face(3.4, 1.419, 0, 1), together = alone;
  for (int k = 1; k < 40; ++k) {
    together.left.h[k] = 1 + 0.05 * k;
    together.left.u[k] = 2 + 0.11 * k;
    together.left.b[k] = 0;
    together.right.b[k] = 0.02 * k;
  }
  head_to_common_bed(g, 1, alone);
  head_to_common_bed(g, 40, together);
  EXPECT_EQ(alone.left.h_star[0], together.left.h_star[0]);
  EXPECT_EQ(alone.left.u_star[0], together.left.u_star[0]);
}

// Two particles one metre apart, i on the left or on the right, in a field with the given slopes.
ShallowFaces between(bool i_is_left, double slope) {
  const double sign = i_is_left ? 1 : -1;
  const double dx[] = {-sign}, h_i[] = {2}, h_j[] = {2 + sign * slope}, u_i[] = {1}, u_j[] = {1 - sign * slope};
  const double b_i[] = {0}, b_j[] = {-0.5 * sign * slope}, one[] = {1};
  const double level[] = {0.5 * slope}, velocity[] = {-slope}, rise[] = {-0.5 * slope};
  const ShallowPairs pairs{dx, h_i, h_j, u_i, u_j, b_i, b_j, one, one, level, level, velocity, velocity, rise, rise};
  ShallowFaces faces{};
  reconstruct<true>(pairs, 0, 1, VanLeer{}, faces);
  return faces;
}

TEST(Reconstruction, OfLinearFieldsMeetsInTheMiddleOfThePair) {
  for (const bool i_is_left : {true, false}) {
    const ShallowFaces faces = between(i_is_left, 0.25);
    const double away = i_is_left ? 0.5 : -0.5;
    for (const auto* side : {&faces.left, &faces.right}) {
      EXPECT_DOUBLE_EQ(side->h[0], 2 + 0.25 * away);
      EXPECT_DOUBLE_EQ(side->u[0], 1 - 0.25 * away);
      EXPECT_DOUBLE_EQ(side->b[0], -0.125 * away);
    }
    EXPECT_DOUBLE_EQ(faces.rise[0], 0.125 * away);
  }
}

}  // namespace
}  // namespace riffle::test
