// Fields that the host offers, on lattices where each is known: by counting, and by formula.
#include "host/schedule/host_fields.hpp"

#include "tests/unit/schedule/world.hpp"

namespace riffle::test {
namespace {

constexpr std::int64_t side = 10;
constexpr double dx = 0.1;

// side^dim particles at the middles of cells of the unit cube. The world makes the images when lists are built, hence
// positions are put right before anything is computed.
struct Lattice {
  HostFields host;
  World world;

  Lattice(int dim, const std::string& wanted, std::int64_t walls = 0, const Toys* more = nullptr,
          std::vector<std::string> given = {}, bool mirror = false)
      : world(toys_of(dim, more, host), options_of(dim, wanted, walls, std::move(given), mirror)) {
    host.connect(world.store, world.kernel().support, world.neighbourhood.images());
    for (std::int64_t i = 0; i < world.store.owned(); ++i) {
      std::int64_t rest = i;
      for (int c = 0; c < dim; ++c, rest /= side) world.store.data("position", c)[i] = (0.5 + rest % side) * dx;
      world.store.data("smoothing_length")[i] = 0.6 * dx;  // a support of 1.2 spacings: 2 dim neighbours, no diagonal
    }
    world.evaluator->everything_changed();
  }
  static Toys toys_of(int dim, const Toys* more, const HostFields& host) {
    Toys all = more != nullptr ? *more : Toys(dim);
    all.add<ToyKernel>();
    all.active.push_back(host.plugin(dim));
    return all;
  }
  static WorldOptions options_of(int dim, const std::string& wanted, std::int64_t walls, std::vector<std::string> given,
                                 bool mirror) {
    WorldOptions options;
    options.dim = dim;
    const std::int64_t all = dim == 1 ? side : dim == 2 ? side * side : side * side * side;
    options.per_role = {all - walls, walls, 0, 0, 0, 0};
    options.wanted = {wanted};
    options.given = std::move(given);
    options.uniform_length = true;
    if (mirror)
      options.images = [](ParticleStore& store, std::vector<Image>& images) {
        for (std::int64_t i = 0; i < store.owned(); ++i) {
          if (store.data("position")[i] < 2 * dx) images.push_back({i, true, 0, {0, 0, 0}});
        }
      };
    return options;
  }
  [[nodiscard]] double x(std::int64_t i, int c) const { return world.value("position", i, c); }
  [[nodiscard]] int walls_touched(std::int64_t i) const {
    int touched = 0;
    for (int c = 0; c < world.store.dim(); ++c) touched += x(i, c) < dx || x(i, c) > 1 - dx ? 1 : 0;
    return touched;
  }
};

class HostFieldsOnALattice : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Dimensions, HostFieldsOnALattice, testing::Values(1, 2, 3));

TEST_P(HostFieldsOnALattice, NeighboursAreCountedWithoutTheParticleItself) {
  Lattice lattice(GetParam(), "neighbour_count");
  lattice.world.compute({"neighbour_count"});
  for (std::int64_t i = 0; i < lattice.world.store.owned(); ++i)
    ASSERT_EQ(lattice.world.value("neighbour_count", i), 2 * GetParam() - lattice.walls_touched(i)) << i;
}

TEST_P(HostFieldsOnALattice, TheNearestNeighbourIsOneSpacingAway) {
  Lattice lattice(GetParam(), "nearest_spacing");
  lattice.world.compute({"nearest_spacing"});
  for (const double r : lattice.world.values("nearest_spacing")) ASSERT_NEAR(r, dx, 1e-15);  // differences below 1
}

TEST_P(HostFieldsOnALattice, AloneAParticleHasNoNeighbourAndTheNearestIsInfinitelyFar) {
  for (const auto* name : {"neighbour_count", "nearest_spacing"}) {
    Lattice lattice(GetParam(), name);
    for (std::int64_t i = 0; i < lattice.world.store.owned(); ++i)
      lattice.world.store.data("smoothing_length")[i] = 0.4 * dx;
    lattice.world.evaluator->everything_changed();
    lattice.world.compute({name});
    for (const double found : lattice.world.values(name))
      ASSERT_EQ(found, std::string(name) == "neighbour_count" ? 0 : infinity);
  }
}

// The sum of the kernel with itself in, by the kernel's own values at 0 and at one spacing. Round-off of some ten terms.
TEST_P(HostFieldsOnALattice, TheKernelSumTakesTheVolumeFromTheCellWhereNothingElseGivesIt) {
  Lattice lattice(GetParam(), "kernel_sum");
  lattice.world.compute({"kernel_sum"});
  const double l = 0.6 * dx, volume = std::pow(dx, GetParam());
  const double own = lattice.world.kernel_value(0, 0, l), other = lattice.world.kernel_value(0, dx, l);
  for (std::int64_t i = 0; i < lattice.world.store.owned(); ++i) {
    const double expected = volume * (own + (2 * GetParam() - lattice.walls_touched(i)) * other);
    ASSERT_NEAR(lattice.world.value("kernel_sum", i), expected, 1e-13 * expected) << i;
  }
}

TEST_P(HostFieldsOnALattice, TheKernelSumTakesTheVolumeFromMassAndDensityWhereBothAreKnown) {
  Lattice lattice(GetParam(), "kernel_sum", 0, nullptr, {"mass", "density"});
  for (std::int64_t i = 0; i < lattice.world.store.owned(); ++i) {
    lattice.world.store.data("mass")[i] = 3;
    lattice.world.store.data("density")[i] = 2;
  }
  lattice.world.evaluator->everything_changed();
  lattice.world.compute({"kernel_sum"});
  const double l = 0.6 * dx;
  const double own = lattice.world.kernel_value(0, 0, l), other = lattice.world.kernel_value(0, dx, l);
  for (std::int64_t i = 0; i < lattice.world.store.owned(); ++i) {
    const double expected = 1.5 * (own + (2 * GetParam() - lattice.walls_touched(i)) * other);
    ASSERT_NEAR(lattice.world.value("kernel_sum", i), expected, 1e-13 * expected) << i;
  }
}

// Walls are the last particles, so the last row (1D: the last three points).
TEST_P(HostFieldsOnALattice, TheWallIsAsFarAsItsNearestParticle) {
  const std::int64_t walls = GetParam() == 1 ? 3 : GetParam() == 2 ? side : side * side;
  Lattice lattice(GetParam(), "wall_distance", walls);
  lattice.world.compute({"wall_distance"});
  const double wall = GetParam() == 1 ? 0.75 : 0.95;
  for (std::int64_t i = 0; i < lattice.world.store.role_begin(1); ++i)
    ASSERT_NEAR(lattice.world.value("wall_distance", i), wall - lattice.x(i, GetParam() - 1), 1e-15) << i;
}

TEST_P(HostFieldsOnALattice, AMirrorPlaneIsAWall) {
  Lattice lattice(GetParam(), "wall_distance", 0, nullptr, {}, true);
  lattice.world.compute({"wall_distance"});
  for (std::int64_t i = 0; i < lattice.world.store.owned(); ++i)
    ASSERT_EQ(lattice.world.value("wall_distance", i), lattice.x(i, 0)) << i;
}

TEST_P(HostFieldsOnALattice, WithoutAWallItIsInfinitelyFar) {
  Lattice lattice(GetParam(), "wall_distance");
  lattice.world.compute({"wall_distance"});
  for (const double distance : lattice.world.values("wall_distance")) ASSERT_EQ(distance, infinity);
}

TEST(HostFields, WaterStandsAsDeepAsItsColumnIsHigh) {
  for (const int dim : {2, 3}) {
    Lattice lattice(dim, "local_depth");
    ParticleStore& store = lattice.world.store;
    // The right half is squeezed to half its height, from the top down.
    for (std::int64_t i = 0; i < store.owned(); ++i)
      if (lattice.x(i, 0) > 0.6) store.data("position", dim - 1)[i] = 0.5 + 0.5 * lattice.x(i, dim - 1);
    lattice.world.evaluator->everything_changed();
    lattice.world.compute({"local_depth"});
    // The half spacing at the ends is that of the cell as placed, so 0.5 - dx/2 + dx.
    for (std::int64_t i = 0; i < store.owned(); ++i)
      ASSERT_NEAR(lattice.world.value("local_depth", i), lattice.x(i, 0) > 0.6 ? 0.55 : 1.0, 1e-14) << i;
  }
}

TEST(HostFields, WaterStandsOnTheBedWhereThereIsOne) {
  Lattice lattice(2, "local_depth", 0, nullptr, {"bed_level"});
  for (std::int64_t i = 0; i < lattice.world.store.owned(); ++i)
    lattice.world.store.data("bed_level")[i] = -lattice.x(i, 0);
  lattice.world.evaluator->everything_changed();
  lattice.world.compute({"local_depth"});
  for (std::int64_t i = 0; i < lattice.world.store.owned(); ++i)
    ASSERT_NEAR(lattice.world.value("local_depth", i), 1 + lattice.x(i, 0), 1e-14) << i;
}

TEST(HostFields, WhoWritesOneHimselfHasTheLastWord) {
  struct Own : ToyOf<'o', Scale<fields::neighbour_count, fields::cell_measure, 0>> {
    using ToyOf::ToyOf;
  };
  Toys toys(2);
  toys.add<Own>();
  Lattice lattice(2, "neighbour_count", 0, &toys);
  lattice.world.compute({"neighbour_count"});
  for (const double count : lattice.world.values("neighbour_count")) ASSERT_EQ(count, 0);
}

TEST(HostFields, NobodyPaysForWhatNobodyReads) {
  Lattice lattice(2, "neighbour_count");
  for (const auto& node : lattice.world.graph.nodes()) EXPECT_EQ(node.label, "host: neighbour count");
}

}  // namespace
}  // namespace riffle::test
