// A catalogue of made-up plugins, and a folder for the manifests of one test.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "host/manifest/read.hpp"

namespace riffle::test {

inline ParameterDescription parameter(const std::string& name, ParameterType type, const std::string& unit,
                                      double fallback, double min, double max) {
  ParameterDescription made;
  made.name = name;
  made.type = type;
  made.unit = unit;
  made.doc = "what " + name + " means";
  made.fallback = fallback;
  made.min = min;
  made.max = max;
  return made;
}

inline FieldDescription field(const std::string& name, const std::string& unit, Shape shape) {
  FieldDescription made;
  made.name = name;
  made.unit = unit;
  made.shape = shape;
  return made;
}

class FakeCatalogue : public PluginCatalogue {
 public:
  FakeCatalogue() {
    constexpr double none = std::numeric_limits<double>::infinity();
    auto& shallow = add("equations", "shallow-water", {1, 2});
    shallow.initial = {field("depth", "m", Shape::scalar), field("velocity", "m.s-1", Shape::vector),
                       field("bed_level", "m", Shape::scalar), field("porosity", "1", Shape::scalar)};
    shallow.initial.back().not_negative = true;
    ParameterDescription support = parameter("support", ParameterType::choice, "1", 0, 0, 0);
    support.choices = {"constant", "inverse-depth"};
    support.fallback_text = "constant";
    ParameterDescription gravity = parameter("gravity", ParameterType::real, "m.s-2", 0, 0, none);
    gravity.inherit = "fluid.gravity";
    gravity.above_min = true;
    shallow.parameters = {support, gravity};

    auto& compressible = add("equations", "compressible", {2, 3});
    compressible.initial = {field("density", "kg.m-3", Shape::scalar), field("velocity", "m.s-1", Shape::vector)};
    compressible.initial.front().needed = true;
    compressible.refuses = {{"turbulence", "", "its stresses are its own; use none"},
                            {"viscosity", "riemann", "it has no faces to solve for"},
                            {"drag", "manning", "there is no depth to rub on"}};
    compressible.integrators = {"predictor-corrector", "semi-implicit-euler"};
    ParameterDescription celerity = parameter("sound_speed", ParameterType::real, "m.s-1", 0, 0, none);
    celerity.required = celerity.above_min = true;
    compressible.parameters = {celerity};

    add("kernel", "cubic-spline", {1, 2, 3});
    add("kernel", "wendland-c2", {2, 3});
    auto& monaghan = add("viscosity", "monaghan", {1, 2, 3});
    monaghan.parameters = {parameter("alpha", ParameterType::real, "1", 1, 0, 100),
                           parameter("beta", ParameterType::real, "1", 0, 0, 100)};
    auto& riemann = add("viscosity", "riemann", {1, 2, 3});
    riemann.parameters = {parameter("beta", ParameterType::real, "1", 0.5, 0, 2),
                          parameter("limited", ParameterType::boolean, "1", 1, 0, 1)};
    add("viscosity", "none", {1, 2, 3});
    auto& manning = add("drag", "manning", {1, 2, 3});
    manning.parameters = {parameter("n", ParameterType::real, "s.m-1/3", 0, 0, 1)};
    manning.parameters.front().required = true;
    auto& wall = add("boundary", "mirror-wall", {1, 2, 3});
    ParameterDescription position = parameter("position", ParameterType::real, "m", 0, -none, none);
    position.inherit = "domain.x_min";
    ParameterDescription side = parameter("layers", ParameterType::integer, "1", 3, 1, 10);
    wall.parameters = {position, side};
    auto& inflow = add("boundary", "inflow", {1, 2});
    ParameterDescription record = parameter("record", ParameterType::text, "1", 0, 0, 0);
    record.path = true;
    ParameterDescription roof = parameter("roof", ParameterType::real, "m", 0, -none, none);
    roof.inherit = "domain.z_max";
    inflow.parameters = {parameter("discharge", ParameterType::function, "m2.s-1", 0.25, -none, none), record};
    auto& lid = add("boundary", "lid", {1, 2});
    lid.parameters = {roof};
    auto& stoker = add("reference", "stoker", {1});
    stoker.gives = {field("depth", "m", Shape::scalar), field("velocity", "m.s-1", Shape::vector)};
    stoker.parameters = {parameter("h_left", ParameterType::real, "m", 1, 0, none),
                         parameter("h_right", ParameterType::real, "m", 0.5, 0, none)};
    add("bed", "flat", {1, 2, 3});
    add("turbulence", "none", {1, 2, 3});
    add("turbulence", "mixing-length", {1, 2, 3});
    auto& ritter = add("reference", "ritter", {1});
    ritter.gives = {field("depth", "m", Shape::scalar)};
    ritter.parameters = {parameter("h_left", ParameterType::real, "m", 1, 0, none)};
  }

  const PluginDescription* find(const std::string& kind, const std::string& id) const override {
    for (const auto& plugin : plugins_) {
      if (plugin->kind == kind && plugin->id == id) return plugin.get();
    }
    return nullptr;
  }
  std::vector<const PluginDescription*> all() const override {
    std::vector<const PluginDescription*> list;
    for (const auto& plugin : plugins_) list.push_back(plugin.get());
    return list;
  }

 private:
  PluginDescription& add(const std::string& kind, const std::string& id, std::vector<int> dimensions) {
    plugins_.push_back(std::make_unique<PluginDescription>());
    PluginDescription& plugin = *plugins_.back();
    plugin.kind = kind;
    plugin.id = id;
    plugin.version = "1.0.0";
    plugin.summary = "a made-up " + kind;
    plugin.dimensions = std::move(dimensions);
    return plugin;
  }
  std::vector<std::unique_ptr<PluginDescription>> plugins_;
};

// A manifest that is right as it stands.
inline const std::string dam_break = R"([case]
name = "dam-break"

[domain]
x = [0, 200]
smoothing_ratio = 2

[initial]
particles = { count = 400 }
depth = { x = [100], values = [10, 5] }

[plugins.equations]
id = "shallow-water"

[plugins.kernel]
id = "cubic-spline"

[plugins.viscosity]
id = "monaghan"
alpha = 2.0

[time]
end = 6
)";

class ManifestTest : public testing::Test {
 protected:
  ManifestTest() : folder_(std::filesystem::path(testing::TempDir()) / unique_name()) {
    std::filesystem::create_directories(folder_);
  }
  ~ManifestTest() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }

  // The case of a manifest text.
  Case read(const std::string& manifest, const std::vector<std::string>& overrides = {}) const {
    write("case.toml", manifest);
    return read_case(folder_ / "case.toml", overrides, catalogue_);
  }

  // The mistakes of a manifest text, without the folder in front of "case.toml".
  std::vector<std::string> mistakes(const std::string& manifest, const std::vector<std::string>& overrides = {}) const {
    try {
      read(manifest, overrides);
    } catch (const ManifestError& error) {
      std::vector<std::string> lines = error.lines();
      const std::string prefix = folder_.string() + '/';
      for (std::string& line : lines) {
        for (std::size_t at = line.find(prefix); at != std::string::npos; at = line.find(prefix)) {
          line.erase(at, prefix.size());
        }
      }
      return lines;
    }
    return {};
  }

  // `text` with the first `from` replaced by `to`.
  static std::string with(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the text has no \"" + from + '"');
    return text.replace(at, from.size(), to);
  }

  const FakeCatalogue catalogue_;
  const std::filesystem::path folder_;

 private:
  static std::string unique_name() {
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    return std::string("riffle-") + test->test_suite_name() + '-' + test->name();
  }
};

using Lines = std::vector<std::string>;

}  // namespace riffle::test
