#include "host/manifest/nearest.hpp"

#include <gtest/gtest.h>

namespace riffle {
namespace {

TEST(Nearest, ASlipOfTheFingerIsOneEdit) {
  EXPECT_EQ(edit_distance("alpha", "alpha"), 0);
  EXPECT_EQ(edit_distance("alpah", "alpha"), 1);  // swapped
  EXPECT_EQ(edit_distance("alph", "alpha"), 1);   // left out
  EXPECT_EQ(edit_distance("alphaa", "alpha"), 1);
  EXPECT_EQ(edit_distance("alfa", "alpha"), 2);
  EXPECT_EQ(edit_distance("Cubic_Spline", "cubic-spline"), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(Nearest, TheNearestSpellingIsFoundAndFarOnesAreNot) {
  EXPECT_EQ(nearest("alfa", {"beta", "alpha", "epsilon"}), "alpha");
  EXPECT_EQ(nearest("smothing_ratio", {"x", "smoothing_ratio"}), "smoothing_ratio");
  EXPECT_EQ(nearest("colour", {"alpha", "beta"}), "");
  EXPECT_EQ(nearest("a", {"b", "c"}), "");
  EXPECT_EQ(nearest("anything", {}), "");
}

TEST(Nearest, AmongEquallyNearWordsTheOneThatBeginsAlikeWins) {
  EXPECT_EQ(nearest("sinn", {"sign", "sin"}), "sin");
}

TEST(Nearest, APartOfAWordFindsTheWord) {
  EXPECT_EQ(nearest("spline", {"wendland-c2", "cubic-spline"}), "cubic-spline");
}

TEST(Nearest, ListsReadAsEnglish) {
  EXPECT_EQ(any_of({"a"}), "\"a\"");
  EXPECT_EQ(any_of({"a", "b"}), "\"a\" or \"b\"");
  EXPECT_EQ(any_of({"a", "b", "c"}), "\"a\", \"b\" or \"c\"");
  EXPECT_EQ(did_you_mean("alfa", {"alpha"}), "; did you mean \"alpha\"?");
  EXPECT_EQ(did_you_mean("alfa", {"x"}), "");
}

}  // namespace
}  // namespace riffle
