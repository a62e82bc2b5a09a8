#include "host/manifest/read.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/manifest/document.hpp"
#include "host/manifest/keys.hpp"
#include "host/manifest/nearest.hpp"
#include "host/manifest/reading.hpp"
#include "host/manifest/replacements.hpp"
#include "host/manifest/sections.hpp"
#include "host/manifest/tables.hpp"
#include "host/manifest/values.hpp"

namespace riffle {
namespace {

void check_tables(Reading& reading) {
  std::vector<std::string> known;
  for (const ManifestTable& table : manifest_tables()) known.push_back(table.name);
  for (const ManifestTable& table : manifest_tables()) {
    if (table.required && reading.root.find(table.name) == nullptr && !misspelt(reading.root, table.name, known)) {
      reading.mistakes.add(top_of(reading), fmt::format("the table [{}] is missing ({})", table.name, table.doc));
    }
  }
  for (const TomlEntry& entry : reading.root.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    std::string hint = did_you_mean(entry.key, known);
    if (hint.empty()) hint = "; there are " + all_of(known);
    reading.mistakes.add(entry.place,
                         fmt::format("unknown {} \"{}\"{}", entry.value.is_table() ? "table" : "key", entry.key, hint));
  }
}

void read_case_table(Reading& reading) {
  const TomlNode* const node = find_table(reading, "case");
  if (node == nullptr) return;
  const OwnTable own = read_own_table(reading, node, "case");
  reading.result.name = own.text("name");
  reading.result.title = own.text("title").empty() ? reading.result.name : own.text("title");
  reading.effective["case"]["title"] = reading.result.title;
}

void read_domain(Reading& reading) {
  const TomlNode* const node = find_table(reading, "domain");
  if (node == nullptr) return;
  const OwnTable own = read_own_table(reading, node, "domain");
  Case& result = reading.result;
  reading.dim = static_cast<int>(own.number("dimension", 0));
  result.dimension = reading.dim;
  result.smoothing_ratio = own.number("smoothing_ratio", 0);
  if (reading.dim == 0) return;

  static const std::array<std::vector<std::string>, 3> axes_of{{{"x"}, {"x", "z"}, {"x", "y", "z"}}};
  const std::vector<std::string>& axes = axes_of[static_cast<std::size_t>(reading.dim) - 1];
  for (const std::string name : {"x", "y", "z"}) {
    const auto axis = std::find(axes.begin(), axes.end(), name);
    const TomlEntry* const given = node->find(name);
    if (axis == axes.end()) {
      if (given == nullptr) continue;
      reading.mistakes.add(
          given->place, fmt::format("domain.{} does not exist with domain.dimension = {}, there {}", name, reading.dim,
                                    axes.size() == 1 ? "is only x" : "are only x and z"));
      continue;
    }
    if (given == nullptr && name != "x") {
      reading.mistakes.add(node->place, fmt::format("domain.{} is missing; with domain.dimension = {} it must be [low, "
                                                    "high], each a length [m]",
                                                    name, reading.dim));
    }
    const OwnValue* const range = own.find(name);
    if (range == nullptr) continue;
    const auto k = static_cast<std::size_t>(axis - axes.begin());
    result.lower[k] = range->range[0];
    result.upper[k] = range->range[1];
    reading.quantities["domain." + name + "_min"] = range->range[0];
    reading.quantities["domain." + name + "_max"] = range->range[1];
  }
}

void read_fluid(Reading& reading) {
  const OwnTable own = read_own_table(reading, find_table(reading, "fluid"), "fluid");
  reading.result.gravity = own.number("gravity", reading.result.gravity);
  reading.result.density = own.number("density", reading.result.density);
  reading.result.viscosity = own.number("viscosity", reading.result.viscosity);
}

void read_time(Reading& reading) {
  const TomlNode* const node = find_table(reading, "time");
  if (node == nullptr) return;
  const OwnTable own = read_own_table(reading, node, "time");
  TimeControl& time = reading.result.time;
  time.end = own.number("end", 0);
  time.cfl = own.number("cfl", time.cfl);
  if (own.has("step")) time.fixed_step = own.number("step", 0);
  time.max_step = own.number("max_step", 0);
  time.max_steps = static_cast<std::int64_t>(own.number("max_steps", 0));
  time.integrator = own.text("integrator");
  time.drag_implicit = own.text("drag") != "explicit";
  reading.quantities["time.begin"] = 0;
}

void read_output(Reading& reading) {
  const OwnTable own = read_own_table(reading, find_table(reading, "output"), "output");
  OutputControl& output = reading.result.output;
  output.snapshot_interval = own.number("snapshots", 0);
  output.profile_interval = own.number("profiles", 0);
  output.checkpoint_interval = own.number("checkpoint", 0);
  output.checkpoint_wall_interval = own.number("checkpoint_wall", 0);
  output.averages_interval = own.number("averages", 0);
  output.averages_from = own.number("averages_from", 0);
  output.picture = own.number("picture", 1) != 0;
  if (const OwnValue* const fields = own.find("fields")) output.fields = fields->words;
}

}  // namespace

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides,
               const PluginCatalogue& catalogue) {
  TomlNode root = read_document(file);
  Reading reading(root, catalogue);
  apply_overrides(overrides, root, catalogue, reading.mistakes);
  reading.folder = file.parent_path();
  reading.result.file = file;
  reading.result.overrides = overrides;
  for (const ManifestTable& table : manifest_tables()) {
    reading.effective[table.name] = nlohmann::ordered_json::object();
  }
  check_tables(reading);
  read_case_table(reading);
  read_domain(reading);
  read_fluid(reading);
  read_time(reading);
  read_output(reading);
  read_particles(reading);
  read_plugins(reading);
  read_initial_fields(reading);
  read_reference(reading);
  read_surface(reading);
  reading.mistakes.throw_if_any();
  reading.result.effective = reading.effective.dump(2);
  return std::move(reading.result);
}

}  // namespace riffle
