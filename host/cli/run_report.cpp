#include "host/cli/run_report.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "host/output/fronts.hpp"
#include "host/output/picture.hpp"
#include "host/output/profiles.hpp"
#include "host/particles/placement.hpp"
#include "host/particles/water.hpp"
#include "host/verdicts/pores.hpp"

namespace riffle {

namespace {

// The scalar columns of a field: one, or one per axis.
std::vector<std::pair<std::string, int>> columns_of(const Field& field, int dim) {
  static constexpr const char* axes[3][3] = {{"", "", ""}, {"_x", "_z", ""}, {"_x", "_y", "_z"}};
  std::vector<std::pair<std::string, int>> out;
  for (std::size_t c = 0; c < field.component.size(); ++c) {
    std::string suffix;
    if (field.component.size() > 1) {
      suffix = field.description.shape == Shape::vector ? axes[dim - 1][c] : "_" + std::to_string(c);
    }
    out.emplace_back(field.description.name + suffix, static_cast<int>(c));
  }
  return out;
}

std::size_t water(const Simulation& simulation) {
  return static_cast<std::size_t>(simulation.store().role_begin(1));
}

std::vector<double> values_of(const Simulation& simulation, const std::string& field, int component) {
  const double* v = simulation.store().data(field, component);
  return {v, v + water(simulation)};
}

// The depths of a panel as levels above the ground, which is drawn under them.
void put_on_ground(Panel& panel, const Simulation& simulation) {
  const riffle_services& scene = simulation.services();
  const auto level_of = [&](const std::vector<double>& x) {
    std::vector<double> level(x.size());
    scene.bed(scene.context, static_cast<std::int64_t>(x.size()), x.data(), nullptr, level.data(), nullptr, nullptr);
    return level;
  };
  for (Series& series : panel.series) {
    const std::vector<double> bed = level_of(series.x);
    for (std::size_t k = 0; k < bed.size(); ++k) series.y[k] += bed[k];
  }
  Series ground{"bed", SeriesStyle::ground, {}, {}};
  constexpr int points = 4000;
  for (int k = 0; k <= points; ++k) ground.x.push_back(scene.low[0] + (scene.high[0] - scene.low[0]) * k / points);
  ground.y = level_of(ground.x);
  panel.series.insert(panel.series.begin(), std::move(ground));
  panel.y_label = "level [m]";
}

// Of those that a list holds: it sees a skin of the support further.
std::int64_t within_support(const Simulation& simulation, const NeighbourList& list, Reach reach, std::int64_t i) {
  const ParticleStore& store = simulation.store();
  const double *l = store.data("smoothing_length"), kappa = simulation.neighbourhood().kappa();
  const auto at = static_cast<std::size_t>(i);
  std::int64_t count = 0;
  for (std::int64_t k = 0; k < list.count[at]; ++k) {
    const std::int64_t j = list.neighbour[static_cast<std::size_t>(list.begin[at] + k)];
    double r2 = 0;
    for (int c = 0; c < store.dim(); ++c) {
      const double* x = store.data("position", c);
      r2 += (x[i] - x[j]) * (x[i] - x[j]);
    }
    const double far = kappa * (reach == Reach::gather ? l[i] : reach == Reach::scatter ? l[j] : std::max(l[i], l[j]));
    count += r2 < far * far ? 1 : 0;
  }
  return count;
}

NeighbourStatistics neighbour_statistics(const Simulation& simulation) {
  NeighbourStatistics statistics;
  for (const auto& node : simulation.graph().nodes()) {
    if (!node.pair || node.makes_pair_field || (node.targets & RIFFLE_FLUID) == 0) continue;
    const NeighbourList& list = simulation.neighbourhood().list({node.reach, node.targets, node.sources});
    const auto n = static_cast<std::int64_t>(std::min(water(simulation), list.count.size()));
    if (n == 0) continue;
    std::int64_t sum = 0;
    for (std::int64_t i = 0; i < n; ++i) {
      const std::int64_t seen = within_support(simulation, list, node.reach, i);
      statistics.smallest = i == 0 ? seen : std::min(statistics.smallest, seen);
      statistics.largest = std::max(statistics.largest, seen);
      sum += seen;
    }
    statistics.mean = static_cast<double>(sum) / static_cast<double>(n);
    break;
  }
  return statistics;
}

// Of a dam break along a channel: where the water is deeper on one side at t = 0.
void add_fronts(const Simulation& simulation, RunRecord& record) {
  const Case& scene = simulation.scene();
  if (scene.dimension != 1 || scene.initial.count("depth") == 0 || simulation.store().find("depth") == nullptr) return;
  const Water initial(scene);
  try {
    record.dam = depth_step([&](double x) { return initial.depth(x); }, scene.lower[0], scene.upper[0]);
  } catch (const PlacementError&) {  // no number at a place where no particle is
  }
  if (!record.dam) return;
  record.fronts = fronts(*record.dam, values_of(simulation, "position", 0), values_of(simulation, "depth", 0));
}

}  // namespace

InitialState capture(const Simulation& simulation) {
  InitialState initial;
  initial.x = values_of(simulation, "position", 0);
  for (const auto& name : simulation.shown_fields()) {
    const Field* field = simulation.store().find(name);
    if (field == nullptr) continue;
    for (const auto& [column, c] : columns_of(*field, simulation.scene().dimension))
      initial.fields[column] = values_of(simulation, name, c);
  }
  return initial;
}

void write_run_profile(const std::filesystem::path& path, Simulation& simulation, const Comparison* comparison) {
  const Case& scene = simulation.scene();
  static constexpr const char* axes[3][3] = {{"x", "", ""}, {"x", "z", ""}, {"x", "y", "z"}};
  std::vector<ProfileColumn> columns;
  const std::size_t n = water(simulation);
  for (int c = 0; c < scene.dimension; ++c)
    columns.push_back({axes[scene.dimension - 1][c], "m", {simulation.store().data("position", c), n}});
  for (const auto& name : simulation.shown_fields()) {
    const Field* field = simulation.store().find(name);
    if (field == nullptr) continue;
    for (const auto& [column, c] : columns_of(*field, scene.dimension)) {
      columns.push_back({column, field->description.unit, {simulation.store().data(name, c), n}});
    }
  }
  std::vector<ExactField> exact;
  if (comparison != nullptr) exact = comparison->at_particles(simulation);
  for (const auto& field : exact) columns.push_back({field.name + "_exact", field.unit, field.exact});
  write_profile(path, {scene.name, simulation.time()}, columns);
}

std::filesystem::path draw_run(const std::filesystem::path& folder, Simulation& simulation,
                               const Comparison* comparison, const InitialState& initial) {
  const Case& scene = simulation.scene();
  const std::string title =
      (scene.title.empty() ? scene.name : scene.title) + fmt::format(", t = {:.6g} s", simulation.time());
  PictureResult result;
  if (scene.dimension == 1) {
    LinePicture picture{title, "x [m]", {}};
    std::map<std::string, std::vector<double>> lines;
    std::vector<double> fine;
    if (comparison != nullptr) {
      constexpr int points = 4000;
      for (int k = 0; k <= points; ++k) fine.push_back(scene.lower[0] + (scene.upper[0] - scene.lower[0]) * k / points);
      lines = comparison->along(fine, simulation.time());
    }
    for (const auto& name : simulation.shown_fields()) {
      const Field* field = simulation.store().find(name);
      if (field == nullptr) continue;
      for (const auto& [column, c] : columns_of(*field, 1)) {
        const auto& named = scene.output.fields;
        const bool asked = std::find(named.begin(), named.end(), name) != named.end();
        if (!lines.empty() && lines.count(column) == 0 && !asked)
          continue;  // what is compared, and what the case names
        Panel panel{
            fmt::format("{} [{}]", column, field->description.unit == "m.s-1" ? "m/s" : field->description.unit), {}};
        const auto before = initial.fields.find(column);
        if (before != initial.fields.end())
          panel.series.push_back({"initial", SeriesStyle::initial, initial.x, before->second});
        const auto line = lines.find(column);
        if (line != lines.end())
          panel.series.push_back(
              {"exact (" + scene.reference->plugin.id + ")", SeriesStyle::exact, fine, line->second});
        panel.series.push_back(
            {"computed", SeriesStyle::computed, values_of(simulation, "position", 0), values_of(simulation, name, c)});
        if (column == "depth" && simulation.services().has_bed != 0) put_on_ground(panel, simulation);
        picture.panels.push_back(std::move(panel));
      }
    }
    result = draw(folder, picture);
  } else {
    FieldPicture picture{title,
                         "x [m]",
                         scene.dimension == 2 ? "z [m]" : "y [m]",
                         "",
                         values_of(simulation, "position", 0),
                         values_of(simulation, "position", 1),
                         {},
                         0};
    const auto shown = simulation.shown_fields();
    const std::string name =
        std::find(shown.begin(), shown.end(), "velocity") != shown.end() || shown.empty() ? "velocity" : shown.front();
    const Field* field = simulation.store().find(name);
    if (field == nullptr) return "no field to draw";
    picture.value.assign(water(simulation), 0.0);
    for (const auto& component : field->component) {
      for (std::size_t i = 0; i < picture.value.size(); ++i)
        picture.value[i] += component.data()[i] * component.data()[i];
    }
    for (double& v : picture.value) v = std::sqrt(v);
    picture.value_label =
        fmt::format("{}{} [{}]", field->component.size() > 1 ? "size of " : "", name, field->description.unit);
    picture.spacing = scene.placement.spacing;
    result = draw(folder, picture);
  }
  return result.drawn ? folder / "picture.png" : std::filesystem::path(result.message);
}

double volume_of_water(const Simulation& simulation) {
  const ParticleStore& store = simulation.store();
  if (store.find("mass") == nullptr || store.find("density") == nullptr) return 0;
  const double *m = store.data("mass"), *rho = store.data("density");
  long double sum = 0;
  for (std::size_t i = 0; i < water(simulation); ++i) sum += m[i] / rho[i];
  return static_cast<double>(sum);
}

RunRecord make_record(Simulation& simulation, const Registry& registry, const Comparison* comparison,
                      const RunReport& report) {
  const Case& scene = simulation.scene();
  RunRecord record;
  record.case_name = scene.name;
  record.title = scene.title;
  record.time = simulation.time();
  record.steps = simulation.steps();
  record.particles = simulation.store().owned();
  record.wall_seconds = report.wall_seconds;
  record.cpu_seconds = report.cpu_seconds;
  const double seconds = std::max(1e-9, report.cpu_seconds);
  record.particle_steps_per_second = static_cast<double>(simulation.particle_steps()) / seconds;
  record.evaluations_per_second = static_cast<double>(simulation.evaluator().evaluations()) / seconds;
  for (const auto& name : simulation.shown_fields()) {
    const Field* field = simulation.store().find(name);
    if (field == nullptr) continue;
    for (const auto& [column, c] : columns_of(*field, scene.dimension))
      record.extrema[column] = extrema(values_of(simulation, name, c));
  }
  if (comparison != nullptr && report.failure.empty())
    record.errors = comparison->errors(simulation, comparison->at_particles(simulation));
  const auto& ledger = simulation.boundaries().ledger();
  const int conserved = simulation.graph().conserved();
  const bool is_mass =
      conserved >= 0 &&
      simulation.graph().fields()[static_cast<std::size_t>(conserved)].description.unit.find("kg") != std::string::npos;
  const double to_mass = is_mass ? 1.0 : scene.density;
  record.mass = {to_mass * ledger.initial, to_mass * ledger.in, to_mass * ledger.out,
                 to_mass * simulation.boundaries().inside()};
  record.momentum.initial = report.momentum_initial;
  record.momentum.final = simulation.momentum();
  for (double& p : record.momentum.initial) p *= to_mass;
  for (double& p : record.momentum.final) p *= to_mass;
  if (conserved >= 0 && simulation.store().find("velocity") != nullptr) {
    const double* amount = simulation.store().data(simulation.graph().name(conserved));
    for (std::size_t i = 0; i < water(simulation); ++i) {
      double u2 = 0;
      for (int c = 0; c < scene.dimension; ++c) u2 += std::pow(simulation.store().data("velocity", c)[i], 2);
      record.momentum.scale += to_mass * amount[i] * std::sqrt(u2);
    }
  }
  record.surface = report.surface;
  if (report.volume_initial > 0) {
    record.volume = VolumeLedger{report.volume_initial, volume_of_water(simulation),
                                 report.volume_initial + (ledger.in - ledger.out) / scene.density};
  }
  record.limits = report.limits;
  record.overrides = scene.overrides;
  record.manifest = scene.effective;
  record.resumed_from = report.resumed_from;
  record.threads = omp_get_max_threads();
  try {
    record.neighbours = neighbour_statistics(simulation);
  } catch (const std::runtime_error&) {  // supports too large for any list: the verdicts say so, and need this record
    record.neighbours.reset();
  }
  if (simulation.store().find("dispersion_active") != nullptr && water(simulation) > 0) {
    const double* active = simulation.store().data("dispersion_active");
    record.active_fraction =
        std::accumulate(active, active + water(simulation), 0.0) / static_cast<double>(water(simulation));
  }
  if (report.failure.empty()) add_fronts(simulation, record);
  record.averages = report.averages;
  record.bytes_per_particle =
      static_cast<double>(simulation.bytes()) / std::max<double>(1, static_cast<double>(record.particles));
  record.seconds.list = simulation.evaluator().list_seconds();
  record.seconds.sweeps = simulation.evaluator().sweep_seconds();
  record.seconds.output = report.output_seconds;
  record.seconds.verdicts = report.verdict_seconds;
  record.seconds.integrate =
      std::max(0.0, report.wall_seconds - record.seconds.list - record.seconds.sweeps - record.seconds.verdicts);
  const auto add = [&](const PluginChoice& choice) {
    const Plugin* plugin = registry.plugin(choice.kind, choice.id);
    if (plugin == nullptr) return;
    PluginRecord p{choice.slot,
                   choice.kind,
                   choice.id,
                   plugin->description.version,
                   plugin->description.library_path,
                   plugin->description.library_hash,
                   plugin->description.build,
                   nlohmann::ordered_json::object()};
    for (const auto& value : choice.values) {
      if (value.function != nullptr)
        p.parameters[value.name] = value.function->text();
      else if (!value.text.empty())
        p.parameters[value.name] = value.text;
      else
        p.parameters[value.name] = value.number;
    }
    const auto& active = simulation.graph().plugins();
    const auto of = std::find_if(active.begin(), active.end(), [&](const auto& a) { return a.slot == choice.slot; });
    if (of != active.end()) p.state = simulation.boundaries().state(static_cast<std::size_t>(of - active.begin()));
    record.plugins.push_back(std::move(p));
  };
  for (const auto& choice : scene.plugins) add(choice);
  if (scene.reference) add(scene.reference->plugin);
  record.verdicts = report.verdicts;
  for (const SceneWarning& warning : simulation.warnings())
    record.verdicts.push_back({warning.name, warning.text, Severity::note, warning.value, warning.bound});
  if (record.neighbours && record.neighbours->smallest == 0 && record.particles > 1) {
    record.verdicts.push_back({"lost-neighbours",
                               "some water particle has no neighbour within its support: the depth or density there is "
                               "that of a lone particle, and no force reaches it",
                               Severity::suspect, 0, 1, record.time});
  }
  for (const auto& doubt : simulation.doubts()) record.verdicts.push_back({"scene", doubt, Severity::note, {}, {}, {}});
  for (const auto& field : report.failure.empty() && comparison != nullptr ? comparison->at_particles(simulation)
                                                                           : std::vector<ExactField>{}) {
    if (field.name != "velocity_x") continue;
    if (auto verdict = locked_bed(simulation, field.exact)) record.verdicts.push_back(std::move(*verdict));
  }
  if (!report.failure.empty())
    record.verdicts.push_back({"blew-up", report.failure, Severity::failed, {}, {}, record.time});
  record.status = status_from(record.verdicts);
  record.message = report.failure;
  return record;
}

std::string summary(const RunRecord& record, const Case& scene, const RunReport& report,
                    const std::filesystem::path& folder) {
  std::string text = fmt::format("{}: {} at t = {:.6g} s after {} steps, {} particles\n", record.case_name,
                                 record.status == RunStatus::finished  ? "finished"
                                 : record.status == RunStatus::suspect ? "suspect"
                                                                       : "failed",
                                 record.time, record.steps, record.particles);
  if (!record.message.empty()) text += "  " + record.message + "\n";
  for (const auto& verdict : record.verdicts) {
    if (verdict.severity != Severity::suspect) continue;
    text += "  suspect: " + verdict.text;
    if (verdict.first_seen) text += fmt::format(" (from t = {:.4g} s)", *verdict.first_seen);
    text += "\n";
  }
  for (const auto& [field, e] : record.errors) {
    if (e.count == 0) {
      text += fmt::format("  {} against {}: no particle to compare\n", field, scene.reference->plugin.id);
      continue;
    }
    text += fmt::format("  {} against {}: L2 = {:.4g} (eq. 17), L1 = {:.4g}, Linf = {:.4g}\n", field,
                        scene.reference->plugin.id, e.l2, e.l1, e.linf);
  }
  for (const SurfaceError& e : record.surface) {
    text += fmt::format("  surface at t = {:.4g} s: RMSE = {:.2f} mm over {} points, mean {:+.2f} mm\n", e.time,
                        1e3 * e.rmse, e.points, 1e3 * e.bias);
  }
  if (record.volume) text += fmt::format("  volume of the water: {:+.3g} %\n", 100 * record.volume->change());
  const double per_step = 1e6 * record.cpu_seconds /
                          std::max(1.0, static_cast<double>(record.particles) * static_cast<double>(record.steps));
  text +=
      fmt::format("  speed: {:.3g} s CPU, {:.3g} s wall, {:.3g} us CPU per particle and step, {} thread{}\n",
                  record.cpu_seconds, record.wall_seconds, per_step, record.threads, record.threads == 1 ? "" : "s");
  if (!report.picture.empty()) text += "  picture: " + report.picture.string() + "\n";
  text += "  record: " + (folder / "run.json").string() + "\n";
  return text;
}

nlohmann::json limits_json(const std::map<std::string, StepLimit>& limits) {
  nlohmann::json json = nlohmann::json::object();
  for (const auto& [name, limit] : limits) json[name] = {limit.steps, limit.smallest};
  return json;
}

std::map<std::string, StepLimit> limits_from(const nlohmann::json& json) {
  std::map<std::string, StepLimit> limits;
  for (const auto& [name, pair] : json.items())
    limits[name] = {pair.at(0).get<std::int64_t>(), pair.at(1).get<double>()};
  return limits;
}

}  // namespace riffle
