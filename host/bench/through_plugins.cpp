#include "host/bench/through_plugins.hpp"

#include <omp.h>

#include <algorithm>
#include <stdexcept>

#include "host/plugins/instance.hpp"
#include "host/schedule/evaluator.hpp"

namespace riffle::bench {

struct ThroughPlugins::Parts {
  std::vector<std::unique_ptr<PluginInstance>> instances;
  std::unique_ptr<ParticleStore> store;
  std::unique_ptr<Graph> graph;
  std::unique_ptr<Neighbourhood> neighbourhood;
  std::unique_ptr<Evaluator> evaluator;
  std::vector<int> rates;
  int density = -1;
};

ThroughPlugins::~ThroughPlugins() = default;

ThroughPlugins::ThroughPlugins(const BenchState& state, const Registry& registry, double skin, std::int64_t block)
    : parts_(std::make_unique<Parts>()) {
  omp_set_num_threads(1);
  Parts& p = *parts_;
  const Physics& physics = state.physics;
  const std::map<std::string, std::map<std::string, double>> settings{
      {"wcsph",
       {{"sound_speed", physics.sound_speed},
        {"gravity", 0},
        {"density", physics.reference_density},
        {"smoothing_ratio", 1.41}}},
      {"wendland-c2", {{"lattice_normalised", 0}, {"smoothing_ratio", 1.41}}},
      {"delta-sph", {{"delta", physics.delta}}},
      {"monaghan", {{"alpha", physics.alpha}, {"beta", 0}}}};
  std::vector<ActivePlugin> active;
  for (const auto& [kind, id] : {std::pair<std::string, std::string>{"equations", "wcsph"},
                                 {"kernel", "wendland-c2"},
                                 {"viscosity", "monaghan"},
                                 {"filter", "delta-sph"}}) {
    const Plugin* plugin = registry.plugin(kind, id);
    if (plugin == nullptr)
      throw std::runtime_error("the benchmark needs the " + kind + " \"" + id + "\", which is not in the plugin path");
    std::vector<ParameterValue> values = default_values(plugin->description, settings.at(id));
    for (auto& value : values) {
      const auto found = settings.at(id).find(value.name);
      if (found != settings.at(id).end()) value.number = found->second;
    }
    p.instances.push_back(std::make_unique<PluginInstance>(*plugin, 2, values));
    active.push_back({id, id, kind, &p.instances.back()->table(), p.instances.back()->self(), values, false});
  }
  p.graph = std::make_unique<Graph>(2, active, std::vector<std::string>{"velocity"}, std::vector<std::string>{});
  p.store = std::make_unique<ParticleStore>(2);
  for (const auto& field : p.graph->fields()) {
    if (field.pair_source != PairSource::none) continue;
    p.store->add_field(field.description, field.evolved     ? FieldUse::evolved
                                          : field.attribute ? FieldUse::attribute
                                                            : FieldUse::derived);
  }
  ParticleStore& store = *p.store;
  store.resize_owned({state.particles, 0, 0, 0, 0, 0});
  for (std::int64_t i = 0; i < state.particles; ++i) store.ids()[static_cast<std::size_t>(i)] = i;
  const auto set = [&](const char* field, int component, const std::vector<double>& values) {
    std::copy(values.begin(), values.end(), store.data(field, component));
  };
  set("position", 0, state.x);
  set("position", 1, state.z);
  const double spacing = physics.smoothing_length / 1.41;
  std::fill_n(store.data("cell_measure"), state.particles, spacing * spacing);
  p.neighbourhood = std::make_unique<Neighbourhood>(store, 2.0, skin, nullptr);
  p.evaluator = std::make_unique<Evaluator>(*p.graph, store, *p.neighbourhood, RunnerOptions{256, block});
  p.evaluator->run_initial_passes();
  std::fill_n(store.data("smoothing_length"), state.particles, physics.smoothing_length);
  set("velocity", 0, state.u);
  set("velocity", 1, state.w);
  set("density", 0, state.density);
  set("mass", 0, state.mass);
  p.evaluator->everything_changed();
  p.rates = {p.graph->field("acceleration"), p.graph->field("density_rate")};
  p.density = p.graph->field("density");
}

void ThroughPlugins::operator()() {
  parts_->evaluator->changed(parts_->density);
  parts_->evaluator->compute(parts_->rates, 0, 0);
}

void ThroughPlugins::copy_to(BenchRates& rates) const {
  const ParticleStore& store = *parts_->store;
  for (std::int64_t k = 0; k < store.owned(); ++k) {
    const auto i = static_cast<std::size_t>(store.ids()[static_cast<std::size_t>(k)]);
    rates.acceleration_x[i] = store.data("acceleration", 0)[k];
    rates.acceleration_z[i] = store.data("acceleration", 1)[k];
    rates.density_rate[i] = store.data("density_rate")[k];
  }
}

}  // namespace riffle::bench
