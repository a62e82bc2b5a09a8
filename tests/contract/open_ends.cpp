// Open ends of the vertical plane with an editor that holds a piece of a channel: 50 by 10 particles, 1 m by 0.2 m.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/contract/loaded.hpp"

namespace riffle::contract {
namespace open_ends {

constexpr double spacing = 0.02, depth = 0.2, sound = 20, gravity = 9.81, reach = 0.088;

class Channel {
 public:
  explicit Channel(bool porous = false) {
    if (porous) fields_["porosity.0"];
    for (const char* name : {"position.0", "position.1", "velocity.0", "velocity.1", "density.0", "mass.0",
                             "cell_measure.0", "wave_speed.0", "smoothing_length.0"})
      fields_[name];
    for (int i = 0; i < 50; ++i) {
      for (int k = 0; k < 10; ++k) {
        const double z = (k + 0.5) * spacing, rho = 1000 * (1 + gravity * (depth - z) / (sound * sound));
        role.push_back(RIFFLE_FLUID);
        for (auto& [name, values] : fields_) values.push_back(0);
        last("position.0") = (i + 0.5) * spacing;
        last("position.1") = z;
        last("velocity.0") = 1 + z;
        last("density.0") = rho;
        last("mass.0") = rho * spacing * spacing * (porous ? 0.5 : 1);
        last("cell_measure.0") = spacing * spacing;
        last("wave_speed.0") = sound;
        last("smoothing_length.0") = 2 * spacing;
        if (porous) last("porosity.0") = 0.5;
      }
    }
  }
  void begin(const Instance& end) { call(end, end.table().begin, 0); }
  void edit(const Instance& end, double dt) { call(end, end.table().edit, dt); }
  void move(double dt) {
    for (std::size_t i = 0; i < role.size(); ++i) fields_["position.0"][i] += dt * fields_["velocity.0"][i];
  }
  double& at(const char* field, std::size_t i) { return fields_.at(field)[i]; }
  // Indices of a role above the bed, or of its floor.
  [[nodiscard]] std::vector<std::size_t> of(std::uint32_t wanted, bool floor = false) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < role.size(); ++i) {
      if (role[i] == wanted && (at("position.1", i) < 0) == floor) found.push_back(i);
    }
    return found;
  }
  std::vector<std::uint32_t> role;

 private:
  double& last(const char* field) { return fields_.at(field).back(); }
  template <class Function>
  void call(const Instance& plugin, Function function, double dt) {
    const std::vector<double> reaches(role.size(), reach);
    const std::vector<std::uint32_t> roles = role;
    removed_.clear();
    riffle_editor e{};
    e.size = sizeof e;
    e.dim = 2;
    e.count = static_cast<std::int64_t>(role.size());
    e.dt = dt;
    e.state = state_;
    e.context = this;
    e.role = roles.data();
    e.reach = reaches.data();
    e.read = [](void* c, const char* field, std::int32_t k) noexcept -> const double* {
      return static_cast<Channel*>(c)->array(field, k);
    };
    e.write = [](void* c, const char* field, std::int32_t k) noexcept {
      return static_cast<Channel*>(c)->array(field, k);
    };
    e.add = [](void* c, std::uint32_t as, std::int64_t like) noexcept {
      auto& self = *static_cast<Channel*>(c);
      for (auto& [name, values] : self.fields_) {
        const double value = values[static_cast<std::size_t>(like)];
        values.push_back(value);
      }
      self.role.push_back(as);
      return static_cast<std::int64_t>(self.role.size()) - 1;
    };
    e.retag = [](void* c, std::int64_t i, std::uint32_t as) noexcept {
      static_cast<Channel*>(c)->role[static_cast<std::size_t>(i)] = as;
    };
    e.remove = [](void* c, std::int64_t i) noexcept {
      static_cast<Channel*>(c)->removed_.insert(static_cast<std::size_t>(i));
    };
    riffle_error error{sizeof(riffle_error), {}};
    if (function(plugin.self(), &e, &error) != RIFFLE_OK) throw Refused(error.message);
    for (auto i = removed_.rbegin(); i != removed_.rend(); ++i) {
      for (auto& [name, values] : fields_) values.erase(values.begin() + static_cast<std::ptrdiff_t>(*i));
      role.erase(role.begin() + static_cast<std::ptrdiff_t>(*i));
    }
    // Grouped by role, as the host leaves them.
    std::vector<std::size_t> order(role.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return role[a] < role[b]; });
    const auto sorted = [&](const auto& values) {
      auto out = values;
      for (std::size_t i = 0; i < order.size(); ++i) out[i] = values[order[i]];
      return out;
    };
    for (auto& [name, values] : fields_) values = sorted(values);
    role = sorted(role);
  }
  double* array(const std::string& field, std::int32_t k) {
    const auto found = fields_.find(field + "." + std::to_string(k));
    return found == fields_.end() ? nullptr : found->second.data();
  }
  std::map<std::string, std::vector<double>> fields_;
  std::set<std::size_t> removed_;
  double state_[4] = {0, 0, 0, 0};
};

TEST(InflowDischarge, ItsRowsCarryTheDischargeWithTheShapeOfTheWaterInside) {
  Channel channel;
  channel.begin(Instance(plugin("boundary", "inflow-discharge"), 2, {{"discharge", 0.11}}));
  std::map<double, double> rows;
  for (const std::size_t i : channel.of(RIFFLE_INFLOW)) {
    EXPECT_LT(channel.at("position.0", i), 0);
    rows[channel.at("position.1", i)] = channel.at("velocity.0", i);
    EXPECT_NEAR(channel.at("mass.0", i) / channel.at("density.0", i), spacing * spacing, 1e-12);
  }
  ASSERT_EQ(rows.size(), 10u);
  double q = 0;
  for (const auto& [z, u] : rows) {
    q += u * spacing;
    EXPECT_NEAR(u, 0.5 * (1 + z), 1e-9);  // inside 1 + z carries 0.22
  }
  EXPECT_NEAR(q, 0.11, 1e-12);
  EXPECT_FALSE(channel.of(RIFFLE_INFLOW, true).empty());
  for (const std::size_t i : channel.of(RIFFLE_INFLOW, true)) {
    EXPECT_EQ(channel.at("velocity.0", i), 0);
    EXPECT_GT(channel.at("density.0", i), 1000 * (1 + gravity * depth / (sound * sound)));
  }
}

TEST(InflowDischarge, WhatHasEnteredIsWaterAndIsFollowed) {
  Channel channel;
  const Instance end(plugin("boundary", "inflow-discharge"), 2, {{"discharge", 0.22}});
  channel.begin(end);
  const std::size_t water = channel.of(RIFFLE_FLUID).size(), buffer = channel.of(RIFFLE_INFLOW).size();
  channel.move(0.9 * spacing);  // the lowest row by 0.91 spacings, the highest by 1.07
  channel.edit(end, 0);
  EXPECT_EQ(channel.of(RIFFLE_FLUID).size(), water + 10);
  EXPECT_EQ(channel.of(RIFFLE_INFLOW).size(), buffer);
}

TEST(InflowDischarge, ADischargeThatLeavesIsRefused) {
  Channel channel;
  const Instance end(plugin("boundary", "inflow-discharge"), 2, {{"discharge", -1}});
  EXPECT_THROW(channel.begin(end), Refused);
}

TEST(OutflowLevel, ItsBufferIsAtRestAboveTheLevelAndMovesAsTheWaterInside) {
  Channel channel;
  const Instance end(plugin("boundary", "outflow-level"), 2, {{"level", 0.21}});
  channel.begin(end);
  const auto buffer = channel.of(RIFFLE_OUTFLOW);
  ASSERT_FALSE(buffer.empty());
  for (const std::size_t i : buffer) {
    const double z = channel.at("position.1", i);
    EXPECT_GT(channel.at("position.0", i), 1);
    EXPECT_NEAR(channel.at("velocity.0", i), 1 + std::min(z, 0.19), 1e-9);
    EXPECT_NEAR(channel.at("density.0", i), 1000 * (1 + gravity * (0.21 - z) / (sound * sound)), 1e-9);
  }
  channel.move(0.9 * spacing);
  channel.edit(end, 0.9 * spacing);
  EXPECT_EQ(channel.of(RIFFLE_FLUID).size(), 490u);  // a column has left
}

TEST(OutflowFrozen, WaterKeepsWhatItHad) {
  Channel channel;
  const Instance end(plugin("boundary", "outflow-frozen"), 2);
  channel.begin(end);
  for (std::size_t i = 490; i < 500; ++i) channel.at("velocity.1", i) = 0.25;
  channel.move(0.9 * spacing);
  channel.edit(end, 0.9 * spacing);
  int frozen = 0;
  for (const std::size_t i : channel.of(RIFFLE_OUTFLOW)) frozen += channel.at("velocity.1", i) == 0.25 ? 1 : 0;
  EXPECT_EQ(frozen, 10);
}

TEST(InflowAveraged, AnEvenVelocityStaysAndADensityIsBetweenThoseAround) {
  Channel channel;
  for (std::size_t i = 0; i < 500; ++i) channel.at("velocity.0", i) = 0.7;
  const Instance end(plugin("boundary", "inflow-averaged"), 2);
  channel.begin(end);
  const double bed = 1000 * (1 + gravity * depth / (sound * sound));
  for (const std::size_t i : channel.of(RIFFLE_INFLOW)) {
    EXPECT_NEAR(channel.at("velocity.0", i), 0.7, 1e-12);
    EXPECT_GT(channel.at("density.0", i), 1000);
    EXPECT_LT(channel.at("density.0", i), bed);
  }
}

TEST(InflowPorous, OneVelocityCarriesTheDischargeThroughThePores) {
  Channel channel(true);
  const Instance end(plugin("boundary", "inflow-porous"), 2, {{"discharge", 0.1}, {"level", 0.25}});
  channel.begin(end);
  const auto buffer = channel.of(RIFFLE_INFLOW);
  ASSERT_FALSE(buffer.empty());
  for (const std::size_t i : buffer) EXPECT_NEAR(channel.at("velocity.0", i), 0.1 / (0.5 * 0.25), 1e-12);
  Channel clear;
  EXPECT_THROW(clear.begin(end), Refused);
}

}  // namespace open_ends
}  // namespace riffle::contract
