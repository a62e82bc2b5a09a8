#include "host/study/attempt.hpp"

#include <fmt/format.h>

#include "host/manifest/read.hpp"
#include "host/output/build_info.hpp"
#include "host/time/simulation.hpp"

namespace riffle {
namespace {

// Everything in force, and the very libraries that compute it.
std::string identity_of(const Case& scene) {
  std::string identity = riffle_version() + '\n' + scene.effective;
  const auto add = [&](const PluginChoice& choice) {
    identity += fmt::format("\n{} {} {}", choice.kind, choice.id, choice.description->library_hash);
  };
  for (const PluginChoice& choice : scene.plugins) add(choice);
  if (scene.reference) add(scene.reference->plugin);
  return identity;
}

// Components of a vector have an error each, named as in run.json.
std::vector<std::string> error_fields_of(const Case& scene) {
  static constexpr const char* axes[3][3] = {{"", "", ""}, {"_x", "_z", ""}, {"_x", "_y", "_z"}};
  std::vector<std::string> names;
  const std::vector<FieldDescription> none;
  for (const FieldDescription& field : scene.reference ? scene.reference->plugin.description->gives : none) {
    const int count = components(field.shape, scene.dimension);
    for (int c = 0; c < count; ++c) names.push_back(field.name + (count > 1 ? axes[scene.dimension - 1][c] : ""));
  }
  if (scene.surface) names.emplace_back(measured_surface);
  return names;
}

}  // namespace

Trial attempt(const std::filesystem::path& manifest, const std::vector<std::string>& overrides,
              const Registry& registry) {
  Trial trial;
  try {
    const Case scene = read_case(manifest, overrides, registry);
    trial.case_name = scene.name;
    trial.title = scene.title;
    trial.dimension = scene.dimension;
    trial.error_fields = error_fields_of(scene);
    trial.identity = identity_of(scene);
    SimulationOptions options;
    options.only_plugins = true;
    const Simulation simulation(scene, registry, options);
    if (scene.reference) {
      const PluginChoice& choice = scene.reference->plugin;
      PluginInstance(*registry.plugin("reference", choice.id), scene.dimension, choice.values, &simulation.services());
    }
  } catch (const ManifestError& error) {
    trial.refusals = error.lines();
  } catch (const ScheduleError& error) {
    trial.refusals = error.lines();
  } catch (const std::exception& error) {
    trial.refusals = {error.what()};
  }
  return trial;
}

}  // namespace riffle
