#include "host/time/simulation.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "host/particles/placement.hpp"
#include "host/plugins/contracts.hpp"
#include "host/time/porosity_at.hpp"
#include "host/time/reference_start.hpp"

namespace riffle {

namespace {

// All cores, but none for less than about 0.2 ms of work per step: waiting for each other would cost more.
int worthwhile_threads(int dim, std::int64_t particles) {
  const std::int64_t enough = dim == 1 ? 8000 : dim == 2 ? 2000 : 500;
  return static_cast<int>(std::clamp<std::int64_t>(particles / enough, 1, omp_get_num_procs()));
}

}  // namespace

Simulation::Simulation(const Case& scene, const Registry& registry, const SimulationOptions& options)
    : case_(scene), options_(options), store_(scene.dimension) {
  create_plugins(registry);
  if (options.only_plugins) return;
  place_particles();
  omp_set_num_threads(options.threads > 0 ? options.threads : worthwhile_threads(scene.dimension, store_.owned()));
  add_fields();
  riffle_kernel kernel{};
  if (graph_->kernel() >= 0) {
    const auto& plugin = graph_->plugins()[static_cast<std::size_t>(graph_->kernel())];
    plugin.table->kernel(plugin.self, &kernel);
  }
  boundaries_ = std::make_unique<Boundaries>(*graph_, store_);
  neighbourhood_ = std::make_unique<Neighbourhood>(store_, kernel.support, options.skin,
                                                   [this](std::vector<Image>& images) { boundaries_->images(images); });
  host_fields_.connect(store_, kernel.support, neighbourhood_->images());
  integrator_ = make_integrator(case_.time.integrator, *graph_, store_, case_.time.drag_implicit);
  evaluator_ = std::make_unique<Evaluator>(*graph_, store_, *neighbourhood_, options.runner);
  boundaries_->connect(*evaluator_, *neighbourhood_);
  evaluator_->run_initial_passes();
  boundaries_->begin(0);
  look_at_scene();
}

const std::vector<std::string>& averaged_fields() {
  static const std::vector<std::string> names{"modelled_shear_stress", "virial_shear_stress", "pressure", "body_force",
                                              "drag_rate"};
  return names;
}

const PluginInstance* Simulation::instance_of(const std::string& kind) const {
  const auto found =
      std::find_if(instances_.begin(), instances_.end(), [&](const auto& i) { return i->kind() == kind; });
  return found == instances_.end() ? nullptr : found->get();
}

void Simulation::create_plugins(const Registry& registry) {
  for (const auto& choice : case_.plugins) {
    const Plugin* plugin = registry.plugin(choice.kind, choice.id);
    if (plugin == nullptr) throw std::runtime_error("there is no " + choice.kind + " \"" + choice.id + "\"");
    instances_.push_back(std::make_unique<PluginInstance>(*plugin, case_.dimension, choice.values, nullptr));
  }
  terrain_ = std::make_unique<Terrain>(case_, instance_of("bed"), instance_of("width"));
  terrain_fields_ = std::make_unique<TerrainFields>(*terrain_, case_, instance_of("kernel"));
  if (case_.level.valid()) case_.initial["depth"] = {depth_below(case_.level, *terrain_)};
  begin_with_reference(case_, registry, terrain_->services());
  std::vector<ActivePlugin> active;
  std::vector<std::string> given, broken;
  for (const auto& [field, functions] : case_.initial) given.push_back(field);
  for (std::size_t p = 0; p < instances_.size(); ++p) {
    const PluginChoice& choice = case_.plugins[p];
    PluginInstance& instance = *instances_[p];
    instance.connect(terrain_->services());
    if (has_contract(choice.kind)) {
      const auto problems = contract_problems(instance);
      broken.insert(broken.end(), problems.begin(), problems.end());
    }
    active.push_back({choice.slot, choice.id, choice.kind, &instance.table(), instance.self(), choice.values, false});
    for (auto e = instance.table().evolved; e != nullptr && *e != nullptr; ++e) {
      for (auto f = instance.table().initial; f != nullptr && *f != nullptr; ++f) {  // from 0 unless given
        if (std::string((*f)->name) == (*e)->field->name) given.emplace_back((*f)->name);
      }
    }
  }
  if (!broken.empty()) throw ScheduleError(broken);
  active.push_back(terrain_fields_->as_plugin());
  active.push_back(host_fields_.plugin(case_.dimension));
  std::vector<std::string> wanted = case_.output.fields;
  if (terrain_->services().has_bed != 0) wanted.emplace_back("smoothed_bed_level");  // the energy of water stands on it
  if (case_.output.averages_interval > 0) {
    if (case_.dimension == 1)
      throw ScheduleError({"output.averages are means by height, and this scene has one dimension: leave them out"});
    wanted.insert(wanted.end(), averaged_fields().begin(), averaged_fields().end());
  }
  graph_ = std::make_unique<Graph>(case_.dimension, active, given, wanted);
  require_shown_fields();
  require_that_terrain_is_used();
}

void Simulation::place_particles() {
  const PlacedParticles placed = place(case_, porosity_of(instance_of("porosity")));
  const auto n = static_cast<std::int64_t>(placed.cell_measure.size());
  for (const char* name : {"position", "cell_measure"}) {
    store_.add_field(graph_->fields()[static_cast<std::size_t>(graph_->field(name))].description, FieldUse::evolved);
  }
  store_.resize_owned({n, 0, 0, 0, 0, 0});
  for (std::int64_t i = 0; i < n; ++i) store_.ids()[static_cast<std::size_t>(i)] = i;
  for (int c = 0; c < case_.dimension; ++c) {
    std::copy(placed.x[static_cast<std::size_t>(c)].begin(), placed.x[static_cast<std::size_t>(c)].end(),
              store_.data("position", c));
  }
  std::copy(placed.cell_measure.begin(), placed.cell_measure.end(), store_.data("cell_measure"));
  const auto [smallest, largest] = std::minmax_element(placed.cell_measure.begin(), placed.cell_measure.end());
  if (n > 0) terrain_fields_->prepare(*smallest, *largest);
  require_enough_particles(n);
}

void Simulation::add_fields() {
  for (const auto& field : graph_->fields()) {
    if (field.pair_source != PairSource::none || !field.is_given()) continue;
    const FieldUse use = field.evolved                       ? FieldUse::evolved
                         : field.attribute                   ? FieldUse::attribute
                         : field.carried || field.occasional ? FieldUse::carried
                                                             : FieldUse::derived;
    store_.add_field(field.description, use).use = use;
  }
  const auto n = store_.owned();
  const double* x = store_.data("position", 0);
  const double* z = case_.dimension > 1 ? store_.data("position", case_.dimension - 1) : nullptr;
  const double* y = case_.dimension == 3 ? store_.data("position", 1) : nullptr;
  for (const auto& [name, functions] : case_.initial) {
    Field* field = store_.find(name);
    if (field == nullptr) continue;  // nobody in this case uses it
    for (std::size_t c = 0; c < functions.size() && c < field->component.size(); ++c) {
      functions[c].evaluate(n, x, y, z, 0, field->component[c].data());
    }
  }
}

StepReport Simulation::step(double until) {
  StepReport report;
  const TimeControl& control = case_.time;
  Limit limit{control.fixed_step.value_or(0), "fixed step"};
  if (!control.fixed_step) {
    limit = evaluator_->time_step(control.cfl, time_, last_dt_);
    if (control.max_step > 0 && limit.dt > control.max_step) limit = {control.max_step, "max_step"};
  }
  if (!(limit.dt > 0)) throw RunError("the time step is " + std::to_string(limit.dt) + " s, limited by " + limit.name);
  if (!std::isfinite(limit.dt)) {
    throw RunError("nothing limits the time step; give time.step or time.max_step");
  }
  blow_up_.look(store_, limit, steps_);
  const double left = until - time_;
  report = {limit.dt, limit.name};
  bool reaches = false;
  if (limit.dt >= left) {
    report = {left, "output time"};
    reaches = true;
  } else if (2 * limit.dt > left) {  // two equal steps rather than one and a sliver
    report = {0.5 * left, "output time"};
  }
  if (time_ + report.dt == time_)
    throw RunError("the time step of " + std::to_string(report.dt) + " s, limited by " + report.limiter +
                   ", no longer advances the time");
  const double end = reaches ? until : time_ + report.dt;
  const double before = boundaries_->inside_before_exchange();
  integrator_->step(*evaluator_, time_, report.dt, end);
  boundaries_->enter_exchange(before);
  time_ = end;
  last_dt_ = report.dt;
  ++steps_;
  particle_steps_ += store_.owned();
  if (boundaries_->edit(time_, report.dt)) integrator_->restarted();
  evaluator_->run_occasional_passes(steps_, time_, report.dt);
  return report;
}

std::vector<double> Simulation::momentum() const {
  std::vector<double> sum(static_cast<std::size_t>(store_.dim()), 0.0);
  if (graph_->conserved() < 0 || store_.find("velocity") == nullptr) return sum;
  const double* amount = store_.data(graph_->name(graph_->conserved()));
  for (int c = 0; c < store_.dim(); ++c) {
    const double* u = store_.data("velocity", c);
    long double total = 0;
    for (std::int64_t i = 0; i < store_.role_begin(1); ++i) total += static_cast<long double>(amount[i]) * u[i];
    sum[static_cast<std::size_t>(c)] = static_cast<double>(total);
  }
  return sum;
}

void Simulation::refresh(const std::vector<std::string>& fields) {
  std::vector<int> wanted;
  for (const auto& name : fields) {
    const int f = graph_->field(name);
    if (f >= 0) wanted.push_back(f);
  }
  evaluator_->compute(wanted, time_, last_dt_);
}

std::vector<std::string> Simulation::shown_fields() const {
  if (!case_.output.fields.empty()) return case_.output.fields;
  std::vector<std::string> shown;
  std::set<std::string> initial;  // what a case can start with is what it is about, also when it is derived afterwards
  for (const auto& plugin : graph_->plugins()) {
    for (auto f = plugin.table->initial; f != nullptr && *f != nullptr; ++f) initial.insert((*f)->name);
  }
  for (const auto& [name, field] : store_.fields()) {
    const int f = graph_->field(name);
    if (f < 0 || name == "position" || name == "cell_measure") continue;
    const auto& graph_field = graph_->fields()[static_cast<std::size_t>(f)];
    const bool varies = !graph_field.attribute;
    if (graph_field.evolved || ((graph_field.given || initial.count(name) != 0) && varies)) shown.push_back(name);
  }
  return shown;
}

std::vector<std::string> Simulation::saved_fields() const {
  std::set<std::string> names;
  for (const auto& [name, field] : store_.fields()) {
    if (field->use != FieldUse::derived) names.insert(name);
  }
  for (const int f : integrator_->carried()) names.insert(graph_->name(f));
  for (const int n : evaluator_->history_nodes()) {
    for (const auto& w : graph_->nodes()[static_cast<std::size_t>(n)].writes) {
      if (store_.find(graph_->name(w.field)) != nullptr) names.insert(graph_->name(w.field));
    }
  }
  return {names.begin(), names.end()};
}

SimulationState Simulation::state() const {
  SimulationState s;
  const auto n = static_cast<std::size_t>(store_.owned());
  for (const auto& name : saved_fields()) {
    const Field& field = store_.at(name);
    for (std::size_t c = 0; c < field.component.size(); ++c) {
      const double* values = field.component[c].data();
      s.reals["field." + name + "." + std::to_string(c)].assign(values, values + n);
    }
  }
  // Particles other than water hold what their boundaries wrote: no pass makes it again.
  const auto water = store_.role_begin(1), others = store_.owned() - water;
  for (const auto& [name, field] : store_.fields()) {
    for (std::size_t c = 0; c < field->component.size() && others > 0; ++c) {
      const double* values = field->component[c].data() + water;
      s.reals["others." + name + "." + std::to_string(c)].assign(values, values + others);
    }
  }
  s.integers["boundary_fields"] = {boundaries_->written().begin(), boundaries_->written().end()};
  s.integers["ids"] = store_.ids();
  auto& roles = s.integers["particles_per_role"];
  for (int r = 0; r < role_count; ++r) roles.push_back(store_.role_begin(r + 1) - store_.role_begin(r));
  const NeighbourhoodState lists = neighbourhood_->state();
  for (int c = 0; c < store_.dim(); ++c) s.reals["list.position." + std::to_string(c)] = lists.x[c];
  s.reals["list.smoothing_length"] = lists.l;
  for (std::size_t p = 0; p < graph_->plugins().size(); ++p) {
    const auto& numbers = boundaries_->state(p);
    if (!numbers.empty()) s.reals["plugin." + graph_->plugins()[p].slot] = numbers;
  }
  const Ledger& ledger = boundaries_->ledger();
  s.reals["time"] = {time_, last_dt_};
  s.reals["ledger"] = {ledger.initial, ledger.in, ledger.out, ledger.in_rest, ledger.out_rest};
  s.integers["counters"] = {steps_, particle_steps_, lists.builds, boundaries_->next_id()};
  s.integers["history"] = evaluator_->history();
  s.integers["integrator"] = {integrator_->carrying() ? 1 : 0};
  return s;
}

void Simulation::restore(const SimulationState& s) {
  const auto reals = [&](const std::string& name) -> const std::vector<double>& {
    const auto found = s.reals.find(name);
    if (found == s.reals.end())
      throw std::runtime_error("the checkpoint holds no \"" + name + "\": it is not of this case");
    return found->second;
  };
  const auto integers = [&](const std::string& name) -> const std::vector<std::int64_t>& {
    const auto found = s.integers.find(name);
    if (found == s.integers.end())
      throw std::runtime_error("the checkpoint holds no \"" + name + "\": it is not of this case");
    return found->second;
  };
  std::array<std::int64_t, role_count> per_role{};
  const auto& roles = integers("particles_per_role");
  if (roles.size() != role_count)
    throw std::runtime_error("the checkpoint holds other particle roles than this program knows");
  std::copy(roles.begin(), roles.end(), per_role.begin());
  store_.resize_owned(per_role);
  const auto n = static_cast<std::size_t>(store_.owned());
  if (integers("ids").size() != n)
    throw std::runtime_error("the checkpoint contradicts itself: its ids do not match its particles");
  store_.ids() = integers("ids");
  for (const auto& name : saved_fields()) {
    Field& field = store_.at(name);
    for (std::size_t c = 0; c < field.component.size(); ++c) {
      const auto& values = reals("field." + name + "." + std::to_string(c));
      if (values.size() != n)
        throw std::runtime_error("the checkpoint holds " + std::to_string(values.size()) + " values of " + name +
                                 " for " + std::to_string(n) + " particles");
      std::copy(values.begin(), values.end(), field.component[c].data());
    }
  }
  for (const auto& [name, field] : store_.fields()) {
    for (std::size_t c = 0; c < field->component.size() && store_.owned() > store_.role_begin(1); ++c) {
      const auto& values = reals("others." + name + "." + std::to_string(c));
      std::copy(values.begin(), values.end(), field->component[c].data() + store_.role_begin(1));
    }
  }
  for (std::size_t p = 0; p < graph_->plugins().size(); ++p) {
    auto& numbers = boundaries_->state(p);
    if (numbers.empty()) continue;
    const auto& saved = reals("plugin." + graph_->plugins()[p].slot);
    if (saved.size() != numbers.size())
      throw std::runtime_error("the checkpoint holds another number of values for the state of " +
                               graph_->plugins()[p].id + ": it is not of this case");
    numbers = saved;
  }
  const auto& written = integers("boundary_fields");
  boundaries_->written() = {written.begin(), written.end()};
  const auto& counters = integers("counters");
  time_ = reals("time").at(0);
  last_dt_ = reals("time").at(1);
  const auto& ledger = reals("ledger");
  boundaries_->ledger() = {ledger.at(0), ledger.at(1), ledger.at(2), ledger.at(3), ledger.at(4)};
  steps_ = counters.at(0);
  particle_steps_ = counters.at(1);
  boundaries_->next_id() = counters.at(3);
  boundaries_->particles_replaced();
  evaluator_->everything_changed();
  NeighbourhoodState lists;
  for (int c = 0; c < store_.dim(); ++c) lists.x[c] = reals("list.position." + std::to_string(c));
  lists.l = reals("list.smoothing_length");
  lists.builds = counters.at(2);
  neighbourhood_->restore(lists);
  evaluator_->restore_history(integers("history"));
  if (integers("integrator").at(0) != 0)
    integrator_->resumed();
  else
    integrator_->restarted();
}

}  // namespace riffle
