#include "host/plugins/instance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "host/plugins/contracts.hpp"
#include "tests/unit/plugins/toy.hpp"

namespace riffle {
namespace {

using test::Toy;

// What the last plugin was created with, and how often one was destroyed.
struct Seen {
  std::int32_t dim = 0;
  std::vector<const riffle_value*> values;
  int destroyed = 0;
};
Seen seen;

// A plugin that shows what it gets.
struct Showing : Toy {
  Showing() {
    seen = {};
    plugin.create = [](std::int32_t dim, const riffle_value* const* values, riffle_error*) noexcept -> void* {
      seen.dim = dim;
      for (; *values != nullptr; ++values) seen.values.push_back(*values);
      return &seen;
    };
    plugin.destroy = [](void* self) noexcept { ++static_cast<Seen*>(self)->destroyed; };
  }
};

TEST(Instance, ValuesComeInTheOrderDeclared) {
  Showing toy;
  const Plugin plugin = toy.read().front();
  auto values = default_values(plugin.description);
  values[0].number = 0.25;
  values[0].given = true;
  const PluginInstance instance(plugin, 2, values);
  EXPECT_EQ(seen.dim, 2);
  ASSERT_EQ(seen.values.size(), 4U);
  EXPECT_EQ(seen.values[0]->number, 0.25);
  EXPECT_EQ(seen.values[0]->given, 1U);
  EXPECT_EQ(seen.values[1]->number, 3);
  EXPECT_EQ(seen.values[1]->given, 0U);
  EXPECT_STREQ(seen.values[2]->text, "quadratic");
  EXPECT_EQ(seen.values[2]->number, 1) << "index of the choice";
}

TEST(Instance, AFunctionStaysCallableWhenTheInstanceMoves) {
  Showing toy;
  const Plugin plugin = toy.read().front();
  PluginInstance first(plugin, 1, default_values(plugin.description));
  const PluginInstance second = std::move(first);
  const riffle_function& function = *seen.values[3]->function;
  const double x[] = {1, 2};
  double out[] = {0, 0};
  function.evaluate(function.context, 2, x, nullptr, nullptr, 0, out);
  EXPECT_EQ(out[0], 0.03);
  EXPECT_EQ(out[1], 0.03);
  EXPECT_EQ(seen.destroyed, 0);
}

TEST(Instance, AFunctionThatThrowsGivesNoNumber) {
  struct Throwing : Function::Implementation {
    void evaluate(std::int64_t, const double*, const double*, const double*, double, double*) const override {
      throw std::runtime_error("outside the table");
    }
  };
  Showing toy;
  const Plugin plugin = toy.read().front();
  auto values = default_values(plugin.description);
  values[3].function = std::make_shared<Function>(std::make_shared<Throwing>(), "table");
  const PluginInstance instance(plugin, 1, values);
  const double x = 1;
  double out = 0;
  seen.values[3]->function->evaluate(seen.values[3]->function->context, 1, &x, nullptr, nullptr, 0, &out);
  EXPECT_TRUE(std::isnan(out));
}

TEST(Instance, ItIsDestroyedOnce) {
  Showing toy;
  const Plugin plugin = toy.read().front();
  {
    PluginInstance first(plugin, 1, default_values(plugin.description));
    const PluginInstance second = std::move(first);
  }
  EXPECT_EQ(seen.destroyed, 1);
}

TEST(Instance, ADimensionThatIsNotSupportedIsRefused) {
  Toy toy;
  toy.plugin.dims = 1U << 1U | 1U << 2U;
  const Plugin plugin = toy.read().front();
  try {
    const PluginInstance instance(plugin, 3, default_values(plugin.description));
    FAIL() << "created";
  } catch (const PluginError& error) {
    EXPECT_STREQ(error.what(), "drag \"toy\" works in 1, 2 dimension(s) only, the scene has 3");
  }
}

TEST(Instance, ADescriptorOutlivesTheLibraryObjectItCameFrom) {
  Toy toy;
  std::vector<Plugin> plugins = toy.read();
  const PluginInstance instance(plugins.front(), 1, default_values(plugins.front().description));
  plugins.clear();
  EXPECT_STREQ(instance.table().passes[0]->name, "friction");
}

TEST(DefaultValues, AnInheritedNumberIsThatOfTheCase) {
  Toy toy;
  toy.real.inherit = "fluid.gravity";
  const PluginDescription description = toy.read().front().description;
  EXPECT_EQ(default_values(description)[0].number, 9.81);
  EXPECT_EQ(default_values(description, {{"fluid.gravity", 1.62}})[0].number, 1.62);
}

TEST(DefaultValues, ARequiredNumberIsInItsRange) {
  Toy toy;
  toy.real.flags = RIFFLE_REQUIRED | RIFFLE_ABOVE_MIN;
  const double value = default_values(toy.read().front().description)[0].number;
  EXPECT_GT(value, 0);
  EXPECT_LE(value, 1);
}

TEST(Conditions, AreMetByOneOfTheirValues) {
  Toy toy;
  const Plugin plugin = toy.read().front();
  const PluginInstance instance(plugin, 1, default_values(plugin.description));
  EXPECT_TRUE(is_active(instance, nullptr));
  EXPECT_TRUE(is_active(instance, "law=linear|quadratic"));
  EXPECT_FALSE(is_active(instance, "law=linear"));
  EXPECT_TRUE(is_active(instance, "steps=3"));
  EXPECT_FALSE(is_active(instance, "steps=4"));
}

}  // namespace
}  // namespace riffle
