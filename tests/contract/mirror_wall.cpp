// mirror-wall with an editor that records what it is asked to do.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "tests/contract/loaded.hpp"

namespace riffle::contract {
namespace {

struct Point {
  std::array<double, 3> x{}, u{};
  double reach = 1;
  std::uint32_t role = RIFFLE_FLUID;
};

// Particles followed by their images; positions and velocities only. Its arrays move when images are made, as those of
// a host may.
class FakeEditor {
 public:
  FakeEditor(int dim, std::vector<Point> points) : dim_(dim), count_(points.size()) {
    for (const Point& p : points) {
      for (std::size_t c = 0; c < 3; ++c) {
        x_[c].push_back(p.x[c]);
        u_[c].push_back(p.u[c]);
      }
      reach_.push_back(p.reach);
      role_.push_back(p.role);
    }
  }
  void edit(const Instance& wall) { call(wall, wall.table().edit); }
  void images(const Instance& wall) { call(wall, wall.table().images); }
  [[nodiscard]] double x(std::size_t k, std::size_t c = 0) const { return x_[c].at(k); }
  [[nodiscard]] double u(std::size_t k, std::size_t c = 0) const { return u_[c].at(k); }
  [[nodiscard]] std::size_t image_count() const { return x_[0].size() - count_; }
  // Positions of the images, in the order of their coordinates.
  [[nodiscard]] std::set<std::vector<double>> image_positions() const {
    std::set<std::vector<double>> found;
    for (std::size_t k = count_; k < x_[0].size(); ++k) {
      std::vector<double> position;
      for (int c = 0; c < dim_; ++c) position.push_back(x_[static_cast<std::size_t>(c)][k]);
      found.insert(position);
    }
    return found;
  }

 private:
  template <class Function>
  void call(const Instance& wall, Function function) {
    riffle_editor e{};
    e.size = sizeof e;
    e.dim = dim_;
    e.count = static_cast<std::int64_t>(count_);
    e.context = this;
    e.role = role_.data();
    e.read = [](void* self, const char* field, std::int32_t c) noexcept -> const double* {
      return static_cast<FakeEditor*>(self)->array(field, c);
    };
    e.write = [](void* self, const char* field, std::int32_t c) noexcept {
      return static_cast<FakeEditor*>(self)->array(field, c);
    };
    e.reach = reach_.data();
    e.image = [](void* self, std::int64_t origin, std::uint32_t how, std::int32_t axis, const double* a) noexcept {
      return static_cast<FakeEditor*>(self)->mirror(static_cast<std::size_t>(origin), how,
                                                    static_cast<std::size_t>(axis), a);
    };
    riffle_error error{sizeof(riffle_error), {}};
    if (function(wall.self(), &e, &error) != RIFFLE_OK) throw std::runtime_error(error.message);
  }
  double* array(const std::string& field, std::int32_t c) {
    const auto axis = static_cast<std::size_t>(c);
    return field == "position" ? x_[axis].data() : field == "velocity" ? u_[axis].data() : nullptr;
  }
  std::int64_t mirror(std::size_t origin, std::uint32_t how, std::size_t axis, const double* a) {
    EXPECT_EQ(how, static_cast<std::uint32_t>(RIFFLE_MIRROR));
    for (std::size_t c = 0; c < 3; ++c) {
      x_[c].push_back(c == axis ? 2 * a[c] - x_[c][origin] : x_[c][origin]);
      u_[c].push_back(c == axis ? -u_[c][origin] : u_[c][origin]);
    }
    return static_cast<std::int64_t>(x_[0].size()) - 1;
  }

  int dim_;
  std::size_t count_;
  std::array<std::vector<double>, 3> x_, u_;
  std::vector<double> reach_;
  std::vector<std::uint32_t> role_;
};

const riffle_plugin& table() {
  return plugin("boundary", "mirror-wall");
}
Point at(double x, double reach = 1, std::uint32_t role = RIFFLE_FLUID) {
  return {{x, 0, 0}, {}, reach, role};
}

TEST(MirrorWall, ImagesWhatIsWithinReachOfEachWallAndNothingElse) {
  const Instance wall(table(), 1, {{"x_min_position", 0}, {"x_max_position", 10}});
  FakeEditor editor(1, {at(0.25), at(0.75), at(1.25), at(5), at(8.75), at(9.5)});
  editor.images(wall);
  EXPECT_EQ(editor.image_positions(), (std::set<std::vector<double>>{{-0.25}, {-0.75}, {10.5}}));
}

TEST(MirrorWall, ImagesAParticleThatOnlyAFarSightedNeighbourCanSeeAcrossTheWall) {
  const Instance wall(table(), 1, {{"x_max", 0}, {"x_min_position", 0}});
  // The first sees 2 m, so the image of the second at -1.5 m, 1.75 m away, belongs to its neighbours; that of the
  // third, at -1.875 m and 2.125 m away, does not.
  FakeEditor editor(1, {at(0.25, 2), at(1.5, 0.5), at(1.875, 0.5)});
  editor.images(wall);
  EXPECT_EQ(editor.image_positions(), (std::set<std::vector<double>>{{-0.25}, {-1.5}}));
}

TEST(MirrorWall, ReversesOnlyTheNormalVelocityOfAnImage) {
  const Instance wall(table(), 2, {{"x_max", 0}, {"x_min_position", 0}});
  FakeEditor editor(2, {{{0.5, 3, 0}, {-2, 7, 0}}});
  editor.images(wall);
  ASSERT_EQ(editor.image_count(), 1u);
  EXPECT_EQ(editor.u(1, 0), 2);
  EXPECT_EQ(editor.u(1, 1), 7);
}

TEST(MirrorWall, FillsTheCornerWhereTwoWallsMeet) {
  const Instance wall(table(), 2, {{"x_max", 0}, {"z_min", 1}, {"x_min_position", 0}, {"z_min_position", -1}});
  FakeEditor editor(2, {{{0.5, -0.75, 0}, {}}});
  editor.images(wall);
  EXPECT_EQ(editor.image_positions(), (std::set<std::vector<double>>{{-0.5, -0.75}, {0.5, -1.25}, {-0.5, -1.25}}));
}

TEST(MirrorWall, MakesSevenImagesInACornerOfThreeDimensions) {
  const Instance wall(table(), 3,
                      {{"x_max", 0}, {"y_min", 1}, {"z_min", 1}, {"y_min_position", 0}, {"z_min_position", 0}});
  FakeEditor editor(3, {{{0.5, 0.25, 0.125}, {}}});
  editor.images(wall);
  EXPECT_EQ(editor.image_count(), 7u);
  EXPECT_EQ(editor.image_positions().size(), 7u);
}

TEST(MirrorWall, LeavesProbesAndParticlesBehindTheWallWithoutImages) {
  const Instance wall(table(), 1, {{"x_max", 0}, {"x_min_position", 0}});
  FakeEditor editor(1, {at(0.5, 1, RIFFLE_PROBE), at(-0.5, 1, RIFFLE_WALL)});
  editor.images(wall);
  EXPECT_EQ(editor.image_count(), 0u);
}

TEST(MirrorWall, TakesBackWaterThatHasCrossedWithItsVelocityReversed) {
  const Instance wall(table(), 1, {{"x_min_position", 0}, {"x_max_position", 10}});
  FakeEditor editor(1, {{{-0.25, 0, 0}, {-3, 0, 0}}, {{10.5, 0, 0}, {2, 0, 0}}, {{5, 0, 0}, {1, 0, 0}}});
  editor.edit(wall);
  EXPECT_EQ(editor.x(0), 0.25);
  EXPECT_EQ(editor.u(0), 3);
  EXPECT_EQ(editor.x(1), 9.5);
  EXPECT_EQ(editor.u(1), -2);
  EXPECT_EQ(editor.x(2), 5);
  EXPECT_EQ(editor.u(2), 1);
}

TEST(MirrorWall, LeavesOtherRolesWhereTheyAre) {
  const Instance wall(table(), 1, {{"x_min_position", 0}});
  FakeEditor editor(1, {at(-0.5, 1, RIFFLE_WALL), at(-0.5, 1, RIFFLE_INFLOW)});
  editor.edit(wall);
  EXPECT_EQ(editor.x(0), -0.5);
  EXPECT_EQ(editor.x(1), -0.5);
}

TEST(MirrorWall, RefusesAFaceThatTheDimensionDoesNotHave) {
  try {
    const Instance wall(table(), 1, {{"z_min", 1}});
    FAIL() << "accepted";
  } catch (const Refused& refused) {
    EXPECT_STREQ(refused.what(), "z_min = true, but there is no z in 1 dimension");
  }
}

TEST(MirrorWall, WantsToKnowWhereAWallStandsThatIsNotAcrossX) {
  try {
    const Instance wall(table(), 2, {{"z_min", 1}});
    FAIL() << "accepted";
  } catch (const Refused& refused) {
    EXPECT_STREQ(refused.what(), "z_min = true needs z_min_position, the place of that wall");
  }
}

TEST(MirrorWall, RefusesWallsInTheWrongOrder) {
  EXPECT_THROW(Instance(table(), 1, {{"x_min_position", 2}, {"x_max_position", 1}}), Refused);
}

}  // namespace
}  // namespace riffle::contract
