// When a run whose numbers are all finite is given up.
#include "host/time/blow_up.hpp"

#include <gtest/gtest.h>

#include "host/time/scene_rules.hpp"
#include "tests/unit/schedule/world.hpp"

namespace riffle::test::blow_up {
namespace {

namespace f = riffle::fields;

class Water {
 public:
  explicit Water(FieldUse waves) {
    const auto field = [](const char* name, Shape shape) {
      return FieldDescription{name, "m", "", shape, false, false, false, false};
    };
    store_.add_field(field("position", Shape::vector), FieldUse::evolved);
    store_.add_field(field("velocity", Shape::vector), FieldUse::evolved);
    store_.add_field(field("wave_speed", Shape::scalar), waves);
    store_.resize_owned({3, 0, 0, 0, 0, 0});
    for (std::int64_t i = 0; i < 3; ++i) store_.ids()[static_cast<std::size_t>(i)] = i;
    for (int i = 0; i < 3; ++i) store_.data("wave_speed")[i] = 10;
  }
  // What is said of particle 1 at this speed and of a step; empty: nothing.
  std::string said(double speed, double dt = 1e-3) {
    store_.data("velocity", 1)[1] = speed;
    try {
      judge_.look(store_, {dt, "toy: acoustic"}, 0);
    } catch (const RunError& error) {
      return error.what();
    }
    return "";
  }
  ParticleStore& store() { return store_; }

 private:
  ParticleStore store_{2};
  BlowUp judge_;
};

TEST(BlowUp, water_three_times_as_fast_as_sound_is_no_water) {
  Water water(FieldUse::attribute);
  EXPECT_EQ(water.said(-29.9), "");
  const std::string said = water.said(-30.1);
  EXPECT_NE(said.find("blown up: the water moves at 30.1 m/s at particle 1"), std::string::npos) << said;
  EXPECT_NE(said.find("toy: acoustic"), std::string::npos) << said;
}

TEST(BlowUp, waves_that_follow_from_the_depth_may_be_much_slower_than_the_water) {
  Water water(FieldUse::derived);
  EXPECT_EQ(water.said(300), "");
}

TEST(BlowUp, a_step_that_shrinks_a_million_times_does_not_come_to_an_end) {
  Water water(FieldUse::attribute);
  EXPECT_EQ(water.said(0, 1e-3), "");
  EXPECT_EQ(water.said(0, 2e-9), "");
  EXPECT_NE(water.said(0, 0.9e-9).find("shrunk from 0.001 s to 9e-10 s, limited by toy: acoustic"), std::string::npos);
}

// The deepest column, with half a spacing at either end, whatever stands beside it.
TEST(SceneRules, water_is_as_deep_as_its_deepest_column) {
  Water water(FieldUse::attribute);
  const double x[] = {0.05, 0.06, 0.9}, z[] = {0.1, 0.4, 2.0};
  for (int i = 0; i < 3; ++i) water.store().data("position", 0)[i] = x[i], water.store().data("position", 1)[i] = z[i];
  EXPECT_NEAR(deepest_water(water.store(), 0.1), 0.4, 1e-12);
}

struct Pull {  // u' = 1
  static constexpr auto pass_name = "pull";
  static constexpr riffle_read reads[] = {at_i(f::position)};
  static constexpr riffle_write writes[] = {sum(f::acceleration)};
  template <class P>
  static void run(const P&, const Block& b) {
    for (int c = 0; c < b.dim(); ++c) {
      RIFFLE_EACH(k, b) b.out(0, c)[k] = 1;
    }
  }
};
struct Pulled : ToyOf<'p', Pull> {
  using ToyOf::ToyOf;
  static constexpr riffle_evolved evolved[] = {evolved_field(f::position, f::velocity),
                                               evolved_field(f::velocity, f::acceleration)};
};
struct Stir {
  static constexpr auto pass_name = "stir";
  static constexpr riffle_read reads[] = {at_i(f::position)};
  static constexpr riffle_write writes[] = {set(f::eddy_viscosity)};
  template <class P>
  static void run(const P&, const Block& b) {
    RIFFLE_EACH(k, b) b.out(0)[k] = 1;
  }
};
struct Eddies : ToyOf<'t', Stir> {
  using ToyOf::ToyOf;
  static constexpr auto kind = "turbulence";
};

// Nobody reads an eddy viscosity here.
TEST(SceneRules, a_closure_that_nobody_listens_to_is_named) {
  Toys toys(2);
  toys.add<Pulled>().add<Eddies>();
  EXPECT_EQ(idle_plugins(Graph(2, toys.active, {"velocity"}, {})),
            std::vector<std::string>{"turbulence \"toy-t\" has no effect: nobody in this case uses what it writes"});
  EXPECT_TRUE(idle_plugins(Graph(2, toys.active, {"velocity"}, {"eddy_viscosity"})).empty());
}

}  // namespace
}  // namespace riffle::test::blow_up
