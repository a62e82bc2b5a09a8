#include "host/output/picture.hpp"

#include <cmath>
#include <cstdlib>

#include "host/output/atomic_file.hpp"
#include "host/output/gnuplot.hpp"
#include "temporary_folder.hpp"

namespace riffle {
namespace {

namespace fs = std::filesystem;

LinePicture dam_break(int particles) {
  Series computed{"computed", SeriesStyle::computed, {}, {}}, exact{"exact", SeriesStyle::exact, {}, {}};
  Series initial{"initial", SeriesStyle::initial, {0, 100, 100, 200}, {10, 10, 5, 5}};
  for (int i = 0; i < particles; ++i) {
    const double x = 200.0 * i / particles;
    computed.x.push_back(x);
    computed.y.push_back(x < 150 ? 7 : 5);
  }
  exact.x = computed.x;
  exact.y = computed.y;
  return {"Dam break", "x [m]", {{"depth [m]", {initial, exact, computed}}, {"velocity [m/s]", {exact, computed}}}};
}

// The environment's PATH while one lives
class Path {
 public:
  explicit Path(const char* path) : before_(std::getenv("PATH")) { setenv("PATH", path, 1); }
  ~Path() { setenv("PATH", before_.c_str(), 1); }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

 private:
  std::string before_;
};

class Picture : public testing::Test {
 protected:
  void SetUp() override {
    if (!find_gnuplot()) GTEST_SKIP() << "gnuplot is not on PATH: nothing can be drawn here";
  }
  void expect_drawn(const PictureResult& result) const {
    EXPECT_TRUE(result.drawn) << result.message;
    EXPECT_EQ(read_file(folder_.path() / "picture.png").substr(0, 4), "\x89PNG");
    EXPECT_TRUE(contains(read_file(folder_.path() / "picture.svg"), "</svg>"));
    EXPECT_FALSE(fs::exists(folder_.path() / "picture.svg.part"));
    EXPECT_FALSE(fs::exists(folder_.path() / "picture.png.part"));
  }
  TemporaryFolder folder_;
};

TEST_F(Picture, OfLinesIsDrawnAsSvgAndPng) {
  expect_drawn(draw(folder_.path(), dam_break(500)));
  const std::string svg = read_file(folder_.path() / "picture.svg");
  for (const char* text : {"Dam break", "x [m]", "depth [m]", "velocity [m/s]", "computed", "exact", "initial"}) {
    EXPECT_TRUE(contains(svg, std::string("<text>") + text)) << text;
  }
}

TEST_F(Picture, OfWaterOverGroundFillsTheGroundAndHasOneLegend) {
  LinePicture picture = dam_break(50);
  picture.panels[1].series = picture.panels[0].series;
  ASSERT_TRUE(draw(folder_.path(), picture).drawn);
  const std::string without = read_file(folder_.path() / "picture.svg");
  picture.panels[0].series.insert(picture.panels[0].series.begin(),
                                  {"bed", SeriesStyle::ground, {0, 50, 100, 200}, {0, 1, 0, 0}});
  expect_drawn(draw(folder_.path(), picture));
  const std::string with = read_file(folder_.path() / "picture.svg");
  EXPECT_TRUE(contains(read_file(folder_.path() / "picture.gp"), "filledcurves"));
  EXPECT_FALSE(contains(with, "<text>bed"));
  const auto height = [](const std::string& svg) { return svg.substr(svg.find("height="), 20); };
  EXPECT_EQ(height(with), height(without)) << "no second legend";
}

TEST_F(Picture, OfManyParticlesStaysSmallAndKeepsWhatStandsOut) {
  LinePicture picture = dam_break(20000);
  picture.panels[0].series[2].y[12345] = 9.25;  // one particle far off
  expect_drawn(draw(folder_.path(), picture));
  EXPECT_LT(fs::file_size(folder_.path() / "picture.svg"), 300000U);
  EXPECT_TRUE(contains(read_file(folder_.path() / "picture.dat"), " 9.25\n"));
}

TEST_F(Picture, OfAFieldIsDrawnForFewAndForManyParticles) {
  for (const int side : {20, 300}) {
    FieldPicture picture{"Still water", "x [m]", "z [m]", "pressure [Pa]", {}, {}, {}, 1.0 / side};
    for (int i = 0; i < side * side; ++i) {
      picture.x.push_back((i % side + 0.5) / side);
      picture.z.push_back((i / side + 0.5) / side);
      picture.value.push_back(9810 * (1 - picture.z.back()));
    }
    expect_drawn(draw(folder_.path(), picture));
    EXPECT_LT(fs::file_size(folder_.path() / "picture.svg"), 5000000U);
  }
}

TEST_F(Picture, CanBeDrawnAgainByItsReader) {
  ASSERT_TRUE(draw(folder_.path(), dam_break(50)).drawn);
  fs::remove(folder_.path() / "picture.svg");
  fs::remove(folder_.path() / "picture.png");
  const std::string command = "cd '" + folder_.path().string() + "' && gnuplot picture.gp";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_TRUE(fs::exists(folder_.path() / "picture.svg"));
  EXPECT_TRUE(fs::exists(folder_.path() / "picture.png"));
}

TEST_F(Picture, TextIsOnlyEverText) {
  LinePicture picture = dam_break(50);
  const std::string file = (folder_.path() / "made-by-a-title").string();
  picture.title = "`touch " + file + "` it's \"quoted\" \\n $x @y {z}_1^2\nset output";
  picture.panels[0].y_label = "'; system('touch " + file + "') #";
  picture.panels[0].series[0].name = "\\";
  expect_drawn(draw(folder_.path(), picture));
  EXPECT_FALSE(fs::exists(file));
  EXPECT_TRUE(contains(read_file(folder_.path() / "picture.svg"), "{z}_1^2 set output"));
}

TEST_F(Picture, ValuesThatCannotBeDrawnAreLeftOut) {
  LinePicture picture = dam_break(50);
  picture.panels[0].series[2].y.assign(50, std::nan(""));
  picture.panels[1].series[1].y[3] = INFINITY;
  picture.panels[1].series[0].x.clear();
  picture.panels[1].series[0].y.clear();
  expect_drawn(draw(folder_.path(), picture));
  expect_drawn(draw(folder_.path(), FieldPicture{"Nothing", "x", "z", "v", {}, {}, {}, 0}));
  expect_drawn(draw(folder_.path(), FieldPicture{"One", "x", "z", "v", {1}, {2}, {std::nan("")}, 0}));
}

TEST_F(Picture, AComplaintOfGnuplotIsPassedOnAndLeavesNoHalfPicture) {
  const TemporaryFolder bin;
  write_atomically(bin.path() / "gnuplot",
                   "#!/bin/sh\necho half > picture.svg.part\necho 'no font found' >&2\nexit 1\n");
  fs::permissions(bin.path() / "gnuplot", fs::perms::owner_all);
  const Path path(bin.path().c_str());
  const PictureResult result = draw(folder_.path(), dam_break(50));
  EXPECT_FALSE(result.drawn);
  EXPECT_EQ(result.message, "no picture is drawn, gnuplot failed: no font found");
  EXPECT_FALSE(fs::exists(folder_.path() / "picture.svg"));
  EXPECT_FALSE(fs::exists(folder_.path() / "picture.svg.part"));
}

TEST(PictureWithoutGnuplot, SaysSoAndLeavesTheScript) {
  const TemporaryFolder folder;
  const Path path(folder.path().c_str());
  const PictureResult result = draw(folder.path(), dam_break(50));
  EXPECT_FALSE(result.drawn);
  EXPECT_TRUE(contains(result.message, "gnuplot is not installed")) << result.message;
  EXPECT_TRUE(fs::exists(folder.path() / "picture.gp"));
}

}  // namespace
}  // namespace riffle
