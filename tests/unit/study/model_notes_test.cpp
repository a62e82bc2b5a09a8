#include "host/study/advise/model_notes.hpp"

#include "host/manifest/mistakes.hpp"
#include "host/study/advise/uniform.hpp"
#include "tests/unit/study/scratch.hpp"

namespace riffle {
namespace model_notes_test {

class Catalogue : public PluginCatalogue {
 public:
  void add(const std::string& kind, const std::string& id, const std::filesystem::path& library) {
    PluginDescription plugin;
    plugin.kind = kind;
    plugin.id = id;
    plugin.library_path = library.string();
    plugins_.push_back(plugin);
  }
  [[nodiscard]] const PluginDescription* find(const std::string&, const std::string&) const override { return nullptr; }
  [[nodiscard]] std::vector<const PluginDescription*> all() const override {
    std::vector<const PluginDescription*> pointers;
    for (const auto& plugin : plugins_) pointers.push_back(&plugin);
    return pointers;
  }

 private:
  std::vector<PluginDescription> plugins_;
};

class ModelNotesOf : public Scratch {
 protected:
  void model(const std::string& id, const std::string& notes) {
    file(id + ".model.toml", notes);
    catalogue_.add("equations", id, home_ / (id + ".so"));
  }
  Catalogue catalogue_;
};

Case with_plugins(const std::vector<std::pair<std::string, std::string>>& slots_and_kinds) {
  Case scene;
  for (const auto& [slot, kind] : slots_and_kinds) {
    PluginChoice choice;
    choice.slot = slot;
    choice.kind = kind;
    scene.plugins.push_back(choice);
  }
  return scene;
}

TEST_F(ModelNotesOf, AreSortedByWhatTheyKeepThenByPreference) {
  model("rich", "keeps = [\"a\", \"b\"]\n");
  model("second", "keeps = [\"a\"]\npreference = 2\n");
  model("first", "keeps = [\"a\"]\npreference = 1\n");
  catalogue_.add("equations", "unknown", home_ / "unknown.so");
  const auto models = known_models(catalogue_);
  ASSERT_EQ(models.size(), 3U);
  EXPECT_EQ(models[0].plugin->id, "first");
  EXPECT_EQ(models[1].plugin->id, "second");
  EXPECT_EQ(models[2].plugin->id, "rich");
}

TEST_F(ModelNotesOf, BecomeOverridesOfTheTablesThatTheCaseHas) {
  model("one",
        "keeps = [\"a\"]\n[set]\nplugins.viscosity.id = \"none\"\ndomain.smoothing_ratio = 1.0\n"
        "[set_where_water_breaks]\nplugins.viscosity.alpha = 2.0\n");
  const auto models = known_models(catalogue_);
  const Case scene = with_plugins({{"flow", "equations"}, {"damping", "viscosity"}});
  EXPECT_EQ(overrides_for(models[0], scene, false),
            (Overrides{"plugins.flow.id=one", "plugins.damping.id=none", "domain.smoothing_ratio=1.0"}));
  EXPECT_EQ(overrides_for(models[0], scene, true).back(), "plugins.damping.alpha=2.0");
}

TEST_F(ModelNotesOf, ThatNobodyKnowsAreAMistakeAtTheirPlace) {
  model("odd", "keeps = [\"a\"]\nkepes = [\"b\"]\n");
  try {
    known_models(catalogue_);
    FAIL() << "an unknown key was taken";
  } catch (const ManifestError& error) {
    EXPECT_NE(error.lines().front().find("odd.model.toml:2:1"), std::string::npos) << error.lines().front();
  }
}

std::shared_ptr<const Function> along(double slope) {
  struct Line : Function::Implementation {
    explicit Line(double s) : slope(s) {}
    void evaluate(std::int64_t n, const double* x, const double*, const double* z, double, double* out) const override {
      for (std::int64_t k = 0; k < n; ++k) out[k] = z[k] + slope * x[k];
    }
    double slope;
  };
  return std::make_shared<Function>(std::make_shared<Line>(slope), "");
}

Case round_scene(double periodic, double slope) {
  Case scene = with_plugins({{"sides", "boundary"}, {"bed", "drag"}});
  scene.dimension = 2;
  scene.upper = {1, 1, 0};
  scene.plugins[0].values.push_back({"x", true, periodic, "", nullptr});
  scene.plugins[1].values.push_back({"bed_level", true, 0, "", along(slope)});
  return scene;
}

TEST(Uniform, IsASceneThatGoesRoundAndKnowsNoX) {
  EXPECT_TRUE(uniform_along_x(round_scene(1, 0)));
  EXPECT_FALSE(uniform_along_x(round_scene(0, 0)));    // walls
  EXPECT_FALSE(uniform_along_x(round_scene(1, 0.1)));  // the bed rises
}

}  // namespace model_notes_test
}  // namespace riffle
