#include "host/output/run_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/output/atomic_file.hpp"

namespace riffle {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json optional(const std::optional<double>& value) {
  return value ? number(*value) : Json(nullptr);
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

const char* name_of(RunStatus status) {
  switch (status) {
    case RunStatus::finished: return "finished";
    case RunStatus::suspect: return "suspect";
    case RunStatus::failed: return "failed";
  }
  return "failed";
}

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::note: return "note";
    case Severity::suspect: return "suspect";
    case Severity::failed: return "failed";
  }
  return "failed";
}

Json errors_of(const RunRecord& record) {
  Json all = Json::object();
  for (const auto& [field, e] : record.errors) {
    all[field] = {
        {"l1", number(e.l1)}, {"l2", number(e.l2)},   {"linf", number(e.linf)},          {"mean", number(e.mean)},
        {"count", e.count},   {"ignored", e.ignored}, {"normalisation", e.normalisation}};
  }
  if (!record.surface.empty()) {
    Json by_time = Json::object(), bias = Json::object(), points = Json::object();
    double sum = 0;
    for (const SurfaceError& e : record.surface) {
      const std::string time = fmt::format("{}", e.time);
      by_time[time] = number(e.rmse);
      bias[time] = number(e.bias);
      points[time] = e.points;
      sum += e.rmse / static_cast<double>(record.surface.size());
    }
    all["surface"] = {
        {"rmse", number(sum)}, {"rmse_by_time", by_time}, {"bias_by_time", bias}, {"points_by_time", points}};
  }
  return all;
}

Json volume_of(const RunRecord& record) {
  if (!record.volume) return nullptr;
  return {{"initial", number(record.volume->initial)},
          {"final", number(record.volume->final)},
          {"change", number(record.volume->change())}};
}

Json extrema_of(const RunRecord& record) {
  Json all = Json::object();
  for (const auto& [field, e] : record.extrema) {
    all[field] = {{"min", number(e.min)}, {"max", number(e.max)}, {"max_abs", number(e.max_abs)}};
  }
  return all;
}

Json ledger_of(const RunRecord& record) {
  const MassLedger& mass = record.mass;
  return {{"mass",
           {{"initial", number(mass.initial)},
            {"in", number(mass.in)},
            {"out", number(mass.out)},
            {"final", number(mass.final)},
            {"imbalance", number(mass.imbalance())}}},
          {"volume", volume_of(record)},
          {"momentum",
           {{"initial", numbers(record.momentum.initial)},
            {"final", numbers(record.momentum.final)},
            {"scale", number(record.momentum.scale)}}}};
}

Json limits_of(const RunRecord& record) {
  std::int64_t steps = 0;
  for (const auto& [name, limit] : record.limits) steps += limit.steps;
  Json all = Json::object();
  for (const auto& [name, limit] : record.limits) {
    const double share = static_cast<double>(limit.steps) / static_cast<double>(std::max<std::int64_t>(steps, 1));
    all[name] = {{"share", share}, {"steps", limit.steps}, {"smallest", number(limit.smallest)}};
  }
  return all;
}

void add_averages(Json& json, const std::optional<FlowAverages>& averages) {
  json["profiles"] = json["stress"] = json["balance"] = nullptr;
  if (!averages || averages->samples == 0) return;
  const FlowAverages& flow = *averages;
  const auto optional = [](const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); };
  json["profiles"] = {{"from", number(flow.from)},
                      {"to", number(flow.to)},
                      {"samples", flow.samples},
                      {"z", numbers(flow.z)},
                      {"velocity",
                       {{"mean", numbers(flow.velocity)},
                        {"rms_x", numbers(flow.rms_x)},
                        {"rms_z", numbers(flow.rms_z)},
                        {"over_depth", number(flow.mean_velocity)}}},
                      {"pressure", {{"mean", numbers(flow.pressure)}}},
                      {"depth", number(flow.depth)}};
  json["stress"] = {
      {"modelled", numbers(flow.modelled)}, {"resolved", numbers(flow.resolved)}, {"virial", numbers(flow.virial)}};
  json["balance"] = {{"momentum", optional(flow.balance)}, {"drag", optional(flow.drag_share)}};
}

Json plugins_of(const RunRecord& record) {
  Json all = Json::array();
  for (const PluginRecord& p : record.plugins) {
    all.push_back({{"slot", p.slot},
                   {"kind", p.kind},
                   {"id", p.id},
                   {"version", p.version},
                   {"library", p.library},
                   {"hash", p.hash},
                   {"build", p.build},
                   {"parameters", p.parameters},
                   {"state", p.state.empty() ? Json(nullptr) : numbers(p.state)}});
  }
  return all;
}

Json verdicts_of(const RunRecord& record) {
  Json all = Json::array();
  for (const Verdict& v : record.verdicts) {
    all.push_back({{"name", v.name},
                   {"severity", name_of(v.severity)},
                   {"text", v.text},
                   {"value", optional(v.value)},
                   {"bound", optional(v.bound)},
                   {"first_seen", optional(v.first_seen)}});
  }
  return all;
}

Json fronts_of(const RunRecord& record) {
  if (!record.dam) return nullptr;
  const Fronts& f = record.fronts;
  return {{"dam", number(record.dam->place)},
          {"toe", optional(f.toe)},
          {"mid", optional(f.mid)},
          {"crest", optional(f.crest)},
          {"crest_depth", optional(f.crest_depth)}};
}

}  // namespace

double MassLedger::imbalance() const {
  const double supplied = initial + in;
  const double missing = (final - initial) + (out - in);
  return supplied == 0 && missing == 0 ? 0 : missing / supplied;
}

RunStatus status_from(const std::vector<Verdict>& verdicts) {
  RunStatus status = RunStatus::finished;
  for (const Verdict& verdict : verdicts) {
    if (verdict.severity == Severity::failed) return RunStatus::failed;
    if (verdict.severity == Severity::suspect) status = RunStatus::suspect;
  }
  return status;
}

int exit_code(RunStatus status, bool strict) {
  switch (status) {
    case RunStatus::finished: return 0;
    case RunStatus::suspect: return strict ? 3 : 0;
    case RunStatus::failed: return 1;
  }
  return 1;
}

Json to_json(const RunRecord& record) {
  Json json;
  json["status"] = name_of(record.status);
  json["message"] = record.message;
  json["case"] = record.case_name;
  json["title"] = record.title;
  json["time"] = number(record.time);
  json["steps"] = record.steps;
  json["particles"] = record.particles;
  json["wall_seconds"] = number(record.wall_seconds);
  json["cpu_seconds"] = number(record.cpu_seconds);
  json["particle_steps_per_second"] = number(record.particle_steps_per_second);
  json["evaluations_per_second"] = number(record.evaluations_per_second);
  json["errors"] = errors_of(record);
  json["extrema"] = extrema_of(record);
  json["ledger"] = ledger_of(record);
  json["dt_limiters"] = limits_of(record);
  json["verdicts"] = verdicts_of(record);
  json["plugins"] = plugins_of(record);
  json["overrides"] = record.overrides;
  // A text that is not JSON is a mistake of ours, and must not cost the user the record of a long run.
  Json manifest = Json::parse(record.manifest, nullptr, false);
  json["manifest"] = manifest.is_discarded() ? Json(record.manifest) : std::move(manifest);
  json["resumed_from"] = record.resumed_from.empty() ? Json(nullptr) : Json(record.resumed_from);
  json["threads"] = record.threads;
  json["riffle"] = {{"version", riffle_version()}, {"build", riffle_build()}};
  json["machine"] = {{"processor", record.machine.processor}, {"cores", record.machine.cores}};
  json["neighbours"] = nullptr;
  if (record.neighbours) {
    json["neighbours"] = {{"mean", number(record.neighbours->mean)},
                          {"smallest", record.neighbours->smallest},
                          {"largest", record.neighbours->largest}};
  }
  json["active_fraction"] = optional(record.active_fraction);
  json["fronts"] = fronts_of(record);
  json["plateau"] = optional(record.fronts.plateau);
  add_averages(json, record.averages);
  json["bytes_per_particle"] = number(record.bytes_per_particle);
  json["seconds"] = {{"sort", number(record.seconds.sort)},     {"list", number(record.seconds.list)},
                     {"sweeps", number(record.seconds.sweeps)}, {"integrate", number(record.seconds.integrate)},
                     {"output", number(record.seconds.output)}, {"verdicts", number(record.seconds.verdicts)}};
  return json;
}

void write_run_record(const std::filesystem::path& path, const RunRecord& record) {
  // Text from a manifest or a plugin may not be UTF-8; the record is written all the same, with the bad bytes replaced.
  write_atomically(path, to_json(record).dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace riffle
