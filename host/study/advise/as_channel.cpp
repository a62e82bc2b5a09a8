#include "host/study/advise/as_channel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace riffle {
namespace {

const ParameterValue* parameter_of(const PluginChoice& choice, const std::string& name) {
  for (const ParameterValue& value : choice.values) {
    if (value.name == name) return &value;
  }
  return nullptr;
}

struct Ends {
  bool low = false, high = false;  // walls stand there
  std::string obstacle;
};

Ends ends_of(const Case& scene) {
  Ends ends;
  for (const PluginChoice& choice : scene.plugins) {
    if (choice.kind != "boundary") continue;
    for (const ParameterValue& value : choice.values) {
      if (value.name == "solid" && value.given) ends.obstacle = "its walls have a shape";
      if ((value.name == "end" || value.name == "discharge") && value.given) ends.obstacle = "it has open ends";
      if ((value.name == "motion" || value.name == "displacement") && value.given) ends.obstacle = "its walls move";
    }
    const ParameterValue *low = parameter_of(choice, "x_min"), *high = parameter_of(choice, "x_max"),
                         *round = parameter_of(choice, "x");
    if (round != nullptr && round->number != 0) ends.obstacle = "water goes round";
    ends.low = ends.low || (low != nullptr && low->number != 0);
    ends.high = ends.high || (high != nullptr && high->number != 0);
  }
  return ends;
}

// A boundary for channels that can stand at either end.
const PluginDescription* wall_of(const PluginCatalogue& catalogue) {
  for (const PluginDescription* plugin : catalogue.all()) {
    if (plugin->kind != "boundary") continue;
    if (std::find(plugin->dimensions.begin(), plugin->dimensions.end(), 1) == plugin->dimensions.end()) continue;
    const auto has = [&](const char* name) {
      return std::any_of(plugin->parameters.begin(), plugin->parameters.end(), [&](const ParameterDescription& one) {
        return one.name == name && one.type == ParameterType::boolean;
      });
    };
    if (has("x_min") && has("x_max")) return plugin;
  }
  return nullptr;
}

// Piecewise heights, joined where they differ by less than particles can tell.
std::string depth_of(const WaterColumns& columns) {
  const double width = (columns.high - columns.low) / static_cast<double>(columns.height.size());
  std::string breaks, values;
  double last = -1;
  for (std::size_t k = 0; k < columns.height.size(); ++k) {
    const double height = columns.height[k];
    const bool same = (height > 0) == (last > 0) && std::abs(height - last) < 0.6 * columns.spacing;
    if (last >= 0 && same) continue;
    if (last >= 0)
      breaks += fmt::format("{}{:.6g}", breaks.empty() ? "" : ", ", columns.low + width * static_cast<double>(k));
    values += fmt::format("{}{:.6g}", values.empty() ? "" : ", ", height);
    last = height;
  }
  return breaks.empty() ? values : fmt::format("{{ x = [{}], values = [{}] }}", breaks, values);
}

std::string obstacle_of(const Case& scene, const WaterColumns& columns) {
  if (scene.dimension != 2) return "it has three dimensions";
  for (const PluginChoice& choice : scene.plugins) {
    for (const char* kind : {"drag", "turbulence"}) {
      if (choice.kind == kind && choice.id != "none") return fmt::format("it has {} \"{}\"", kind, choice.id);
    }
  }
  double low = 1e300, high = -1e300;
  for (std::size_t k = 0; k < columns.height.size(); ++k) {
    if (!(columns.height[k] > 0)) continue;
    low = std::min(low, columns.bottom[k]);
    high = std::max(high, columns.bottom[k]);
  }
  return high - low > 1.5 * columns.spacing ? "its bottom is not level" : "";
}

}  // namespace

ChannelManifest as_channel(const Case& scene, const WaterColumns& columns, const ModelNotes& model,
                           const PluginCatalogue& catalogue) {
  const Ends ends = ends_of(scene);
  std::string obstacle = obstacle_of(scene, columns);
  if (obstacle.empty()) obstacle = ends.obstacle;
  const PluginDescription* const wall = wall_of(catalogue);
  if (obstacle.empty() && wall == nullptr) obstacle = "no wall for channels is installed";
  if (!obstacle.empty()) return {"", obstacle};
  std::string kernel;
  for (const std::string& change : model.set) {
    constexpr const char* key = "plugins.kernel.id=";
    if (change.rfind(key, 0) == 0) kernel = change.substr(std::string(key).size());
  }
  return {fmt::format("[case]\nname = \"{}-channel\"\ntitle = \"The same columns of water as a channel\"\n\n[domain]\n"
                      "x = [{:.9g}, {:.9g}]\nsmoothing_ratio = 1.0\n\n[fluid]\ngravity = {:.9g}\ndensity = {:.9g}\n"
                      "viscosity = {:.9g}\n\n[initial]\nparticles = {{ count = 400 }}\ndepth = {}\n\n"
                      "[plugins.equations]\nid = \"{}\"\n\n[plugins.kernel]\nid = \"{}\"\n\n[plugins.boundary]\n"
                      "id = \"{}\"\nx_min = {}\nx_max = {}\n\n[time]\nend = {:.9g}\n",
                      scene.name, columns.low, columns.high, scene.gravity, scene.density, scene.viscosity,
                      depth_of(columns), model.plugin->id, kernel, wall->id, ends.low, ends.high, scene.time.end),
          ""};
}

}  // namespace riffle
