#include "host/time/scene_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace riffle {

namespace {

constexpr double enough_rows = 20, compression = 0.01;

double number_of(const PluginChoice& choice, const std::string& name) {
  const auto found =
      std::find_if(choice.values.begin(), choice.values.end(), [&](const auto& value) { return value.name == name; });
  return found == choice.values.end() ? 0 : found->number;
}

}  // namespace

std::vector<std::string> idle_plugins(const Graph& graph) {
  std::vector<std::string> lines;
  for (std::size_t p = 0; p < graph.plugins().size(); ++p) {
    const ActivePlugin& plugin = graph.plugins()[p];
    const bool closure =
        plugin.kind == "drag" || plugin.kind == "turbulence" || plugin.kind == "viscosity" || plugin.kind == "filter";
    if (!closure || plugin.fallback) continue;
    bool wants = false;  // to do something, with the parameters that it has
    for (auto pass = plugin.table->passes; pass != nullptr && *pass != nullptr; ++pass)
      wants = wants || (*pass)->when == nullptr || condition_holds((*pass)->when, plugin.values);
    const bool works = std::any_of(graph.nodes().begin(), graph.nodes().end(),
                                   [&](const PassNode& node) { return node.plugin == static_cast<int>(p); });
    if (wants && !works)
      lines.push_back(plugin.kind + " \"" + plugin.id + "\" has no effect: nobody in this case uses what it writes");
  }
  return lines;
}

double deepest_water(const ParticleStore& store, double spacing) {
  std::map<std::pair<std::int64_t, std::int64_t>, std::pair<double, double>> columns;
  const double *x = store.data("position"), *y = store.dim() == 3 ? store.data("position", 1) : nullptr;
  const double* z = store.data("position", store.dim() - 1);
  double deepest = 0;
  for (std::int64_t i = 0; i < store.role_begin(1); ++i) {
    const auto cell = [&](double at) { return static_cast<std::int64_t>(std::floor(at / (2 * spacing))); };
    auto& [low, high] = columns.try_emplace({cell(x[i]), y != nullptr ? cell(y[i]) : 0}, z[i], z[i]).first->second;
    low = std::min(low, z[i]);
    high = std::max(high, z[i]);
    deepest = std::max(deepest, high - low + spacing);
  }
  return deepest;
}

std::string reader_of_host_field(const Graph& graph, const std::string& field) {
  const int wanted = graph.field(field),
            host = static_cast<int>(graph.plugins().size()) - 1;  // the last of the plugins
  bool given = false;
  std::string reader;
  for (const PassNode& node : graph.nodes()) {
    const auto is_field = [&](const auto& use) { return use.field == wanted; };
    if (node.plugin == host)
      given = given || std::any_of(node.writes.begin(), node.writes.end(), is_field);
    else if (std::any_of(node.reads.begin(), node.reads.end(), is_field))
      reader = graph.plugins()[static_cast<std::size_t>(node.plugin)].kind + " \"" +
               graph.plugins()[static_cast<std::size_t>(node.plugin)].id + "\"";
  }
  return given ? reader : "";
}

std::vector<std::string> drowned_by_roughness(const Case& scene, double depth) {
  std::vector<std::string> lines;
  for (const PluginChoice& choice : scene.plugins) {
    const double height = choice.kind == "drag" ? number_of(choice, "roughness_height") : 0;
    if (height < depth || height == 0) continue;
    lines.push_back(
        fmt::format("plugins.{}.roughness_height must be below the depth of the water, {:.4g} m, got {:.4g} m",
                    choice.slot, depth, height));
  }
  return lines;
}

std::vector<SceneWarning> doubtful_resolution(const Case& scene, const ParticleStore& store, double depth) {
  std::vector<SceneWarning> warnings;
  const Field *waves = store.find("wave_speed"), *velocity = store.find("velocity");
  const std::int64_t n = store.role_begin(1);
  if (n == 0 || waves == nullptr || velocity == nullptr || waves->use != FieldUse::attribute) return warnings;
  const double sound = *std::min_element(waves->component[0].data(), waves->component[0].data() + n);
  double fastest = 0;
  for (std::int64_t i = 0; i < n; ++i) {
    double square = 0;
    for (const auto& component : velocity->component) square += component.data()[i] * component.data()[i];
    fastest = std::max(fastest, square);
  }
  const double head = std::max(scene.gravity * depth, fastest);  // m2/s2
  if (head > 1.1 * compression * sound * sound) {                // water out of its lattice is a part of a row deeper
    warnings.push_back({"sound-speed",
                        fmt::format("a speed of sound of {:.4g} m/s lets the density vary by {:.2g} %: ten times {}, "
                                    "{:.4g} m/s, keeps it within 1 %",
                                    sound, 100 * head / (sound * sound),
                                    head > fastest ? fmt::format("sqrt(g H) of water {:.3g} m deep", depth)
                                                   : "the largest velocity at t = 0",
                                    std::sqrt(head / compression)),
                        head / (sound * sound), compression});
  }
  const double rows = depth / scene.placement.spacing;
  if (scene.gravity > 0 && rows < enough_rows - 1e-6) {
    warnings.push_back(
        {"rows",
         fmt::format(
             "only {:.3g} rows of particles over {:.3g} m of water, {:.3g} m apart: with fewer than {:g} the pressure "
             "between them may resist shear like a soft solid and hold back water on a mild slope",
             rows, depth, scene.placement.spacing, enough_rows),
         rows, enough_rows});
  }
  return warnings;
}

}  // namespace riffle
