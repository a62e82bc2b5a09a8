#include "host/study/read_study.hpp"

#include "tests/unit/study/scratch.hpp"

namespace riffle {
namespace {

struct NoPlugins : PluginCatalogue {
  [[nodiscard]] const PluginDescription* find(const std::string&, const std::string&) const override { return nullptr; }
  [[nodiscard]] std::vector<const PluginDescription*> all() const override { return {}; }
};

class ReadStudy : public Scratch {
 protected:
  void SetUp() override {
    Scratch::SetUp();
    file("dam.toml", "");
  }

  [[nodiscard]] Study read(const std::string& text, StudyPurpose purpose = StudyPurpose::compare) const {
    return read_study(file("s.toml", text), purpose, NoPlugins());
  }

  // What is wrong with a study, without the name of its file.
  [[nodiscard]] std::string mistakes_of(const std::string& text, StudyPurpose purpose = StudyPurpose::compare) const {
    try {
      static_cast<void>(read(text, purpose));
    } catch (const ManifestError& error) {
      std::string all;
      const std::string file_name = (home_ / "s.toml").string() + ":";
      for (const std::string& line : error.lines()) {
        all += (all.empty() ? "" : "\n") + (line.rfind(file_name, 0) == 0 ? line.substr(file_name.size()) : line);
      }
      return all;
    }
    return "";
  }

  static constexpr const char* head = "[study]\nname = \"s\"\ncases = \"dam.toml\"\n";
};

TEST_F(ReadStudy, TakesClosuresOfSeveralKeysAndOfNone) {
  const Study study = read(std::string(head) + R"([closures."as it is"]
[closures.inviscid]
plugins.viscosity.id = "none"
time.cfl = 0.25
)");
  ASSERT_TRUE(study.closures.has_value());
  const auto& choices = study.closures->choices;
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_EQ(choices[0].label, "as it is");
  EXPECT_TRUE(choices[0].overrides.empty());
  EXPECT_EQ(choices[1].overrides[0].text, "plugins.viscosity.id=\"none\"");
  EXPECT_EQ(choices[1].overrides[1].text, "time.cfl=0.25");
}

TEST_F(ReadStudy, VariesByHeadersAndDottedKeysAndTakesTablesInBracesAsValues) {
  const Study study = read(std::string(head) + R"([vary]
initial.depth = ["1 m", { x = [5], values = ["2 m", 1] }]
[vary.plugins.kernel]
id = ["a", "b"]
)");
  ASSERT_EQ(study.vary.size(), 2U);
  EXPECT_EQ(study.vary[0].name, "depth");
  EXPECT_EQ(study.vary[0].choices[1].overrides[0].text, "initial.depth={x = [5], values = [\"2 m\", 1]}");
  EXPECT_EQ(study.vary[1].name, "kernel");
  EXPECT_EQ(study.vary[1].choices[0].overrides[0].key, "plugins.kernel.id");
}

TEST_F(ReadStudy, KeepsWholeKeysAsNamesWhereShortOnesAreTheSame) {
  const Study study = read(std::string(head) + "[vary]\nplugins.a.alpha = [1]\nplugins.b.alpha = [2]\n");
  EXPECT_EQ(study.vary[0].name, "plugins.a.alpha");
}

TEST_F(ReadStudy, LetsKeysOfAResolutionGoInStep) {
  const Study study =
      read(std::string(head) + "[resolution]\ninitial.particles.count = [10, 20]\ntime.max_step = [2.0, 1.0]\n");
  ASSERT_TRUE(study.resolution.has_value());
  EXPECT_EQ(study.resolution->name, "count");
  EXPECT_EQ(study.resolution->choices[1].label, "20");
  EXPECT_EQ(study.resolution->choices[1].overrides[1].text, "time.max_step=1.0");
}

TEST_F(ReadStudy, SaysEveryMistakeAtItsPlace) {
  EXPECT_EQ(
      mistakes_of(
          "[study]\nname = \"A b\"\ncases = [\"dam.toml\", \"no.toml\"]\nrepeats = 0\nbasline = \"x\"\n[varry]\n"),
      "2:8: study.name must be a word of a-z, 0-9, - and . that begins with a letter or digit, got \"A b\"\n"
      "3:22: study.cases: there is no manifest " +
          (home_ / "no.toml").string() +
          "\n"
          "4:11: study.repeats must be an integer from 1 to 1000, got 0\n"
          "5:1: unknown key \"basline\" in [study]; did you mean \"baseline\"?\n"
          "6:2: unknown table \"varry\"; did you mean \"vary\"?");
}

TEST_F(ReadStudy, RefusesWhatWouldHaveNoRuns) {
  EXPECT_EQ(mistakes_of(std::string(head) + "[vary]\ntime.cfl = []\n"),
            "5:6: time.cfl in [vary] must be an array of at least one value, got an empty array: the study would have "
            "no runs");
  EXPECT_EQ(mistakes_of("[study]\nname = \"s\"\ncases = []\n"),
            "3:9: study.cases is empty: the study would have no runs");
}

TEST_F(ReadStudy, SaysWhereASingleValueBelongs) {
  EXPECT_EQ(mistakes_of(std::string(head) + "[vary]\ntime.cfl = 0.5\n"),
            "5:6: time.cfl in [vary] must be an array of at least one value, got 0.5; a value that all runs share "
            "belongs into "
            "[set]");
}

TEST_F(ReadStudy, RefusesAKeyThatVariesInTwoWays) {
  EXPECT_EQ(mistakes_of(std::string(head) + "[vary]\ntime.cfl = [0.5]\n[closures.a]\ntime.cfl = 0.2\n"),
            "7:6: time.cfl varies in [vary] already");
}

TEST_F(ReadStudy, RefusesResolutionsThatAreNotInStep) {
  EXPECT_EQ(mistakes_of(std::string(head) + "[resolution]\ntime.cfl = [1, 2]\ntime.end = [1]\n"),
            "6:6: time.end has 1 values and time.cfl has 2; keys of [resolution] go in step and need as many each");
}

TEST_F(ReadStudy, OfAMapTakesTwoAxes) {
  const Study study = read(std::string(head) + R"([map]
error_bound = 0.05
x = { key = "time.cfl", from = 0.1, to = 10, points = 3, scale = "logarithmic" }
y = { key = "plugins.viscosity.alpha", from = 0, to = 4 }
)",
                           StudyPurpose::stability);
  ASSERT_TRUE(study.map.has_value());
  EXPECT_EQ(study.map->axes[0].name, "cfl");
  EXPECT_DOUBLE_EQ(study.map->axes[0].value(1), 1);
  EXPECT_DOUBLE_EQ(study.map->axes[1].value(19), 4);
}

TEST_F(ReadStudy, OfAMapWantsTwoKeysAndARisingRange) {
  EXPECT_EQ(mistakes_of(std::string(head) + R"([map]
x = { key = "time.cfl", from = 2, to = 1 }
y = { key = "time.cfl", from = 0, to = 1, scale = "logarithmic" }
)",
                        StudyPurpose::stability),
            "4:1: map.error_bound is missing; it must be a number above 0\n"
            "5:40: map.x.to must be above map.x.from = 2, got 1\n"
            "6:1: map.y must have another key than map.x, got time.cfl for both\n"
            "6:32: map.y.from must be above 0 on a logarithmic scale, got 0");
}

TEST_F(ReadStudy, SaysWhichCommandATableIsFor) {
  EXPECT_EQ(mistakes_of(std::string(head) + "[map]\n"),
            "4:2: [map] is for riffle stability; riffle compare varies with [vary]");
}

TEST_F(ReadStudy, ThatIsNotThereIsOneLine) {
  EXPECT_THROW(
      try { read_study(home_ / "none.toml", StudyPurpose::compare, NoPlugins()); } catch (const ManifestError& error) {
        EXPECT_EQ(error.lines(), std::vector<std::string>{(home_ / "none.toml").string() + ": no such study"});
        throw;
      },
      ManifestError);
}

}  // namespace
}  // namespace riffle
