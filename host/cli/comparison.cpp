#include "host/cli/comparison.hpp"

#include <limits>

#include "host/plugins/call.hpp"
#include "host/plugins/contracts.hpp"
#include "host/schedule/run_error.hpp"

namespace riffle {

struct Comparison::Values {
  std::vector<std::string> name, unit, field;
  std::vector<int> component;
  std::vector<std::vector<double>> value, scale;
  std::vector<std::uint8_t> defined;
};

Comparison::Comparison(const Case& scene, const Registry& registry, const riffle_services& services) : case_(scene) {
  const PluginChoice& choice = scene.reference->plugin;
  reference_ = std::make_unique<PluginInstance>(*registry.plugin("reference", choice.id), scene.dimension,
                                                choice.values, &services);
  const auto broken = contract_problems(*reference_);
  if (!broken.empty()) throw PluginError(broken.front());
}

Comparison::Values Comparison::evaluate(std::int64_t n, const double* const x[3], double time) const {
  const riffle_plugin& table = reference_->table();
  Values values;
  for (auto f = table.gives; f != nullptr && *f != nullptr; ++f) {
    const int count = components(static_cast<Shape>((*f)->shape), case_.dimension);
    for (int c = 0; c < count; ++c) {
      static constexpr const char* axes[3][3] = {{"", "", ""}, {"_x", "_z", ""}, {"_x", "_y", "_z"}};
      values.name.push_back(std::string((*f)->name) + (count > 1 ? axes[case_.dimension - 1][c] : ""));
      values.unit.emplace_back((*f)->unit);
      values.field.emplace_back((*f)->name);
      values.component.push_back(c);
    }
  }
  const auto size = static_cast<std::size_t>(n);
  values.value.assign(values.name.size(), std::vector<double>(size));
  values.scale = values.value;
  values.defined.assign(size, 1);
  std::vector<double*> value, scale;
  for (auto& v : values.value) value.push_back(v.data());
  for (auto& s : values.scale) scale.push_back(s.data());
  riffle_points points{sizeof(riffle_points), case_.dimension, n, {x[0], x[1], x[2]}, time};
  riffle_error error{sizeof(riffle_error), {}};
  const auto evaluate_it = [&] {
    return may_throw(table.evaluate_reference)(reference_->self(), &points, value.data(), scale.data(),
                                               values.defined.data(), &error);
  };
  if (call_plugin(error, evaluate_it) != RIFFLE_OK) {
    throw RunError(reference_->name() + ": " + message_of(error));
  }
  return values;
}

std::vector<ExactField> Comparison::at_particles(const Simulation& simulation) const {
  const ParticleStore& store = simulation.store();
  const std::int64_t n = store.role_begin(1);
  const double* x[3] = {};
  for (int c = 0; c < case_.dimension; ++c) x[c] = store.data("position", c);
  const Values values = evaluate(n, x, simulation.time());
  std::vector<std::uint8_t> counts = values.defined;
  for (std::int64_t i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto& region = case_.reference->region;
    if (region && (x[0][i] < (*region)[0] || x[0][i] > (*region)[1])) counts[k] = 0;
    for (std::size_t f = 0; f < values.name.size(); ++f) {
      const auto bound = case_.reference->ignore_below.find(values.name[f]);
      if (bound != case_.reference->ignore_below.end() && values.value[f][k] < bound->second) counts[k] = 0;
    }
  }
  std::vector<ExactField> fields;
  for (std::size_t f = 0; f < values.name.size(); ++f) {
    if (store.find(values.field[f]) == nullptr) continue;
    ExactField field{values.name[f],  values.unit[f],  values.field[f], values.component[f],
                     values.value[f], values.scale[f], counts};
    for (std::size_t k = 0; k < field.exact.size(); ++k) {
      if (values.defined[k] == 0) field.exact[k] = std::numeric_limits<double>::quiet_NaN();
    }
    fields.push_back(std::move(field));
  }
  return fields;
}

std::map<std::string, std::vector<double>> Comparison::along(const std::vector<double>& x, double time) const {
  const double* at[3] = {x.data(), nullptr, nullptr};
  const Values values = evaluate(static_cast<std::int64_t>(x.size()), at, time);
  std::map<std::string, std::vector<double>> lines;
  for (std::size_t f = 0; f < values.name.size(); ++f) {
    auto& line = lines[values.name[f]] = values.value[f];
    for (std::size_t k = 0; k < line.size(); ++k) {
      if (values.defined[k] == 0) line[k] = std::numeric_limits<double>::quiet_NaN();
    }
  }
  return lines;
}

std::map<std::string, FieldErrors> Comparison::errors(const Simulation& simulation,
                                                      const std::vector<ExactField>& exact) const {
  const std::vector<double> measure = particle_measure(simulation);
  std::map<std::string, FieldErrors> errors;
  for (const auto& field : exact) {
    const double* computed = simulation.store().data(field.field, field.component);
    errors[field.name] =
        field_errors({{computed, field.exact.size()}, field.exact, field.scale, measure, field.counts});
  }
  return errors;
}

std::vector<double> particle_measure(const Simulation& simulation) {
  const ParticleStore& store = simulation.store();
  const auto n = static_cast<std::size_t>(store.role_begin(1));
  const Graph& graph = simulation.graph();
  const double* cell = store.data("cell_measure");
  std::vector<double> measure(cell, cell + n);
  const char* per = store.find("depth") != nullptr ? "depth" : store.find("density") != nullptr ? "density" : nullptr;
  if (graph.conserved() < 0 || per == nullptr) return measure;
  const double* amount = store.data(graph.name(graph.conserved()));
  const double* dense = store.data(per);
  for (std::size_t i = 0; i < n; ++i) measure[i] = amount[i] / dense[i];
  return measure;
}

}  // namespace riffle
