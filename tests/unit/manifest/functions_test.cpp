// Functions of position and time, as [initial] and function parameters take them.
#include <cmath>
#include <numbers>
#include <thread>

#include "tests/unit/manifest/fake_catalogue.hpp"

namespace riffle::test {
namespace {

class Functions : public ManifestTest {
 protected:
  // initial.bed_level = <toml>
  std::string manifest(const std::string& toml) const {
    return with(dam_break, "depth =", "bed_level = " + toml + "\ndepth =");
  }
  Function bed(const std::string& toml) const { return read(manifest(toml)).initial.at("bed_level")[0]; }
  Lines wrong(const std::string& toml) const { return mistakes(manifest(toml)); }
};

TEST_F(Functions, AConstantIsANumberOrAQuantity) {
  EXPECT_EQ(bed("3")(7), 3);
  EXPECT_EQ(bed("\"15 cm\"")(7), 0.15);
  EXPECT_EQ(bed("\"15 cm\"").text(), "15 cm");
}

TEST_F(Functions, AFormulaKnowsPositionTimePiAndTheGravityOfTheManifest) {
  EXPECT_EQ(bed("\"2*x + 1\"")(3), 7);
  EXPECT_EQ(bed("\"x < 5 ? 1 : 2\"")(5), 2);
  EXPECT_EQ(bed("\"max(0, 1 - x^2)\"")(0.5), 0.75);
  EXPECT_EQ(bed("\"t\"")(0, 0, 0, 4), 4);
  EXPECT_EQ(bed("\"sqrt(g)\"")(0), std::sqrt(9.81));
  EXPECT_EQ(bed("\"pi*x\"")(1), std::numbers::pi);
  EXPECT_EQ(bed("\"5\"")(1), 5);
  const Case moon = read(manifest("\"g\""), {"fluid.gravity=1.62"});
  EXPECT_EQ(moon.initial.at("bed_level")[0](0), 1.62);
}

TEST_F(Functions, PiecewiseValuesHoldFromTheirBreakOnwards) {
  const Function f = bed("{ x = [0, \"2 m\"], values = [1, \"x + 10\", \"30 cm\"] }");
  EXPECT_EQ(f(-1e-300), 1);
  EXPECT_EQ(f(0), 10);
  EXPECT_EQ(f(1.5), 11.5);
  EXPECT_EQ(f(2), 0.3);
}

TEST_F(Functions, ATableIsLinearBetweenItsRowsAndConstantBeyond) {
  write("bed.csv", "# surveyed\n\n x , level,note\n0,1,a\n# a comment\n2, 3,b\n4,2,c\r\n");
  const Function f = bed("{ csv = \"bed.csv\", x = \"x\", value = \"level\" }");
  EXPECT_EQ(f(0), 1);
  EXPECT_EQ(f(1), 2);
  EXPECT_EQ(f(2), 3);
  EXPECT_EQ(f(3), 2.5);
  EXPECT_EQ(f(-1), 1);
  EXPECT_EQ(f(100), 2);
}

TEST_F(Functions, ATableMayBeUndefinedOutsideButMustThenCoverTheDomain) {
  write("long.csv", "\"x [m]\",\"level\"\n-1,1\n201,1\n");
  const Function f = bed("{ csv = \"long.csv\", x = \"x [m]\", value = \"level\", outside = \"error\" }");
  EXPECT_EQ(f(200), 1);
  EXPECT_TRUE(std::isnan(f(202)));
  write("short.csv", "x,level\n0,1\n150,1\n");
  EXPECT_EQ(
      wrong("{ csv = \"short.csv\", x = \"x\", value = \"level\", outside = \"error\" }"),
      (Lines{"case.toml:10:21: initial.bed_level: with outside = \"error\" the table must reach from x = 0 to 200, it "
             "goes from 0 to 150"}));
}

TEST_F(Functions, TablesAndPiecesMayRunOverTime) {
  write("q.csv", "time,q\n0,0\n10,5\n");
  const Function table = bed("{ csv = \"q.csv\", t = \"time\", value = \"q\" }");
  EXPECT_EQ(table(0, 0, 0, 4), 2);
  const Function pieces = bed("{ t = [\"1 min\"], values = [0, 1] }");
  EXPECT_EQ(pieces(0, 0, 0, 59), 0);
  EXPECT_EQ(pieces(0, 0, 0, 60), 1);
}

TEST_F(Functions, ManyPointsAreEvaluatedAtOnceAndMissingCoordinatesAreZero) {
  const Case c = read(
      dam_break + "\n[plugins.inlet]\nkind = \"boundary\"\nid = \"inflow\"\ndischarge = \"x + 10*y + 100*z + t\"\n");
  const Function& f = *c.plugins.back().values[0].function;
  const std::array<double, 3> x{1, 2, 3}, z{4, 5, 6};
  std::array<double, 3> out{};
  f.evaluate(3, x.data(), nullptr, z.data(), 0.5, out.data());
  EXPECT_EQ(out, (std::array<double, 3>{401.5, 502.5, 603.5}));
  f.evaluate(3, x.data(), x.data(), nullptr, 0, out.data());
  EXPECT_EQ(out, (std::array<double, 3>{11, 22, 33}));
}

TEST_F(Functions, ThreadsEvaluateOneFormulaAtOnceWithoutMixingTheirPoints) {
  const Function f = bed("{ x = [0], values = [\"-x\", \"x*x\"] }");
  std::vector<std::thread> threads;
  std::vector<int> wrong_values(4);
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&, thread] {
      for (int k = 0; k < 2000; ++k) {
        const double x = thread * 10000 + k;
        if (f(x) != x * x || f(-x - 1) != x + 1) ++wrong_values[static_cast<std::size_t>(thread)];
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong_values, (std::vector<int>{0, 0, 0, 0}));
}

TEST_F(Functions, AWrongFormulaIsPointedAtByColumnAndCharacter) {
  EXPECT_EQ(wrong("\"10*xx\""), (Lines{"case.toml:10:17: initial.bed_level: the formula \"10*xx\" does not parse at "
                                       "character 4: unexpected token \"xx\"; did you mean \"x\"?"}));
  EXPECT_EQ(wrong("\"sinn(x)\""),
            (Lines{"case.toml:10:14: initial.bed_level: the formula \"sinn(x)\" does not parse at "
                   "character 1: unexpected token \"sinn\"; did you mean \"sin\"?"}));
  EXPECT_EQ(wrong("\"(x + 1\""), (Lines{"case.toml:10:20: initial.bed_level: the formula \"(x + 1\" does not parse at "
                                        "character 7: missing parenthesis"}));
  EXPECT_EQ(wrong("\"x = 3 ? 1 : 2\""),
            (Lines{"case.toml:10:16: initial.bed_level: the formula \"x = 3 ? 1 : 2\" does not "
                   "parse at character 3: \"=\" assigns; a comparison is written \"==\""}));
  EXPECT_EQ(wrong("\"x, 2\""),
            (Lines{"case.toml:10:13: initial.bed_level: the formula \"x, 2\" does not parse: one value is "
                   "wanted, not several with commas"}));
  EXPECT_EQ(wrong("\"\""),
            (Lines{"case.toml:10:13: initial.bed_level: the formula \"\" does not parse: expression is empty"}));
}

TEST_F(Functions, ATextThatBeginsLikeAQuantityIsJudgedAsOne) {
  EXPECT_EQ(wrong("\"15 kg\""),
            (Lines{"case.toml:10:13: initial.bed_level must be a length [m], got \"15 kg\", which is a mass"}));
  EXPECT_EQ(wrong("\"2 x\""),
            (Lines{"case.toml:10:13: initial.bed_level must be a length [m], got \"2 x\": unknown unit \"x\""}));
}

TEST_F(Functions, OtherTypesAreNoFunctions) {
  EXPECT_EQ(
      wrong("true"),
      (Lines{
          "case.toml:10:13: initial.bed_level must be a quantity [m], a formula in x, y, z and t, { x = [...], values "
          "= [...] } or { csv = \"...\", x = \"...\", value = \"...\" }, got true"}));
}

TEST_F(Functions, AFormulaOverAnAxisThatTheDomainDoesNotHaveIsRefused) {
  EXPECT_EQ(wrong("\"x + z\""),
            (Lines{"case.toml:10:13: initial.bed_level uses z, but with domain.dimension = 1 there is only x"}));
}

TEST_F(Functions, PiecewiseValuesMustMatchTheirBreaks) {
  EXPECT_EQ(
      wrong("{ x = [1, 2], values = [1, 2] }"),
      (Lines{"case.toml:10:36: initial.bed_level.values must have one value more than x has breaks, so 3, got 2"}));
  EXPECT_EQ(wrong("{ x = [2, \"1 m\"], values = [1, 2, 3] }"),
            (Lines{"case.toml:10:23: initial.bed_level.x must increase, got \"1 m\" after 2"}));
  EXPECT_EQ(
      wrong("{ x = [], values = [1] }"),
      (Lines{"case.toml:10:19: initial.bed_level.x must be an array as in { x = [0, 5], values = [10, \"x\", 5] }, got "
             "an empty array"}));
  EXPECT_EQ(
      wrong("{ x = [1], values = [1, true] }"),
      (Lines{"case.toml:10:37: initial.bed_level.values[1] must be a quantity [m], a formula in x, y, z and t, { x = "
             "[...], values = [...] } or { csv = \"...\", x = \"...\", value = \"...\" }, got true"}));
  EXPECT_EQ(wrong("{ x = [1], values = [1, { x = [2], values = [1, 2] }] }"),
            (Lines{"case.toml:10:37: initial.bed_level.values[1] must be a quantity or a formula, got a table"}));
  EXPECT_EQ(
      wrong("{ x = [\"1 s\"], values = [1, \"2 kg\"] }"),
      (Lines{"case.toml:10:20: initial.bed_level.x[0] must be a length [m], got \"1 s\", which is a time",
             "case.toml:10:41: initial.bed_level.values[1] must be a length [m], got \"2 kg\", which is a mass"}));
  EXPECT_EQ(
      wrong("{ values = [1, 2] }"),
      (Lines{
          "case.toml:10:13: initial.bed_level must run over exactly one of x, y, z and t, as in { x = [0, 5], values "
          "= [10, \"x\", 5] }"}));
  EXPECT_EQ(wrong("{ x = [1], valeus = [1, 2] }"),
            (Lines{"case.toml:10:24: unknown key \"valeus\" in initial.bed_level; did you mean \"values\"?"}));
}

TEST_F(Functions, ATableInCsvIsCheckedLineByLine) {
  const std::string toml = "{ csv = \"bed.csv\", x = \"x\", value = \"b\" }";
  EXPECT_EQ(wrong(toml), (Lines{"case.toml:10:21: initial.bed_level.csv: no such file \"bed.csv\""}));
  write("bed.csv", "# c\nx,b\n0,1\n\n1,two\n");
  EXPECT_EQ(wrong(toml),
            (Lines{"case.toml:10:21: initial.bed_level.csv: bed.csv:5: column \"b\" must hold numbers, got \"two\""}));
  write("bed.csv", "x,b\n0,1\n2,1\n2,1\n");
  EXPECT_EQ(wrong(toml), (Lines{"case.toml:10:21: initial.bed_level.csv: bed.csv:4: column \"x\" must increase from "
                                "row to row, got 2 after 2"}));
  write("bed.csv", "x,b\n0,1\n2\n");
  EXPECT_EQ(wrong(toml),
            (Lines{"case.toml:10:21: initial.bed_level.csv: bed.csv:3: 1 of 2 columns are given, \"b\" is missing"}));
  write("bed.csv", "x,bed\n0,1\n2,1\n");
  EXPECT_EQ(wrong(toml),
            (Lines{"case.toml:10:49: initial.bed_level.value: bed.csv has no column \"b\"; it has \"x\" and \"bed\""}));
  write("bed.csv", "x,b\n0,1\n");
  EXPECT_EQ(wrong(toml), (Lines{"case.toml:10:21: initial.bed_level.csv: bed.csv: a table must have a header and at "
                                "least two rows, this one has one row"}));
  write("bed.csv", "x,b\n0,1\n1,inf\n");
  EXPECT_EQ(wrong(toml),
            (Lines{"case.toml:10:21: initial.bed_level.csv: bed.csv:3: column \"b\" must hold numbers, got \"inf\""}));
}

TEST_F(Functions, ATableInCsvNeedsItsColumnsNamed) {
  write("bed.csv", "x,b\n0,1\n1,1\n");
  EXPECT_EQ(
      wrong("{ csv = \"bed.csv\", x = 1, value = \"b\", outside = \"linear\" }"),
      (Lines{
          "case.toml:10:36: initial.bed_level.x must be a text in quotes, as in { csv = \"bed.csv\", x = \"x\", value "
          "= \"level\" }, got 1",
          "case.toml:10:62: initial.bed_level.outside must be \"constant\" or \"error\", got \"linear\""}));
  EXPECT_EQ(
      wrong("{ csv = \"bed.csv\", x = \"x\" }"),
      (Lines{"case.toml:10:13: initial.bed_level.value is missing; it names a column, as in { csv = \"bed.csv\", x = "
             "\"x\", value = \"level\" }"}));
}

}  // namespace
}  // namespace riffle::test
