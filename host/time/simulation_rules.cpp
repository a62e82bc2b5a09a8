// What a simulation refuses, and what it warns of, before its first step.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "host/manifest/nearest.hpp"
#include "host/time/scene_rules.hpp"
#include "host/time/simulation.hpp"

namespace riffle {

// Fields that the store will not hold cannot be written: those that nobody gives, and those of pairs.
void Simulation::require_shown_fields() const {
  std::vector<std::string> there, lines;
  for (const auto& field : graph_->fields()) {
    if (field.pair_source == PairSource::none && field.is_given()) there.push_back(field.description.name);
  }
  for (const auto& name : case_.output.fields) {
    if (std::find(there.begin(), there.end(), name) != there.end()) continue;
    const int known = graph_->field(name);
    const bool pairs = known >= 0 && graph_->fields()[static_cast<std::size_t>(known)].pair_source != PairSource::none;
    lines.push_back("output.fields: " +
                    std::string(pairs ? "\"" + name + "\" is a number of pairs, not of particles"
                                      : "no plugin of this case gives \"" + name + "\"" + did_you_mean(name, there)));
  }
  if (!lines.empty()) throw ScheduleError(lines);
}

// Along a channel, a bed or a width that no pass reads would be left out of the equations without a word.
void Simulation::require_that_terrain_is_used() const {
  if (case_.dimension != 1) return;
  const auto reads = [&](const PassNode& node, const char* field) {
    const bool own = node.plugin + 1 == static_cast<int>(graph_->plugins().size());  // those that offer the fields
    const auto is_field = [&, wanted = graph_->field(field)](const NodeRead& read) { return read.field == wanted; };
    return !own && graph_->field(field) >= 0 && std::any_of(node.reads.begin(), node.reads.end(), is_field);
  };
  const auto unused = [&](std::initializer_list<const char*> fields) {
    return std::none_of(graph_->nodes().begin(), graph_->nodes().end(), [&](const PassNode& node) {
      return std::any_of(fields.begin(), fields.end(), [&](const char* field) { return reads(node, field); });
    });
  };
  std::vector<std::string> lines;
  const auto add = [&](const char* kind, const char* what) {
    lines.push_back(instance_of(kind)->name() + " has no effect: " + instance_of("equations")->name() +
                    " does not read the " + what);
  };
  if (terrain_->has_bed() &&
      unused({"bed_level", "bed_slope", "smoothed_bed_level", "smoothed_bed_slope", "water_level"})) {
    add("bed", "bed");
  }
  if (terrain_->has_width() && unused({"channel_width", "width_slope"})) add("width", "width of the channel");
  if (instance_of("porosity") != nullptr && unused({"porosity"})) add("porosity", "porosity");
  if (!lines.empty()) throw ScheduleError(lines);
}

// Fewer particles along the channel than one support holds: every sum would miss a part of its kernel.
void Simulation::require_enough_particles(std::int64_t n) const {
  const PluginInstance* const kernel = instance_of("kernel");
  if (case_.dimension != 1 || kernel == nullptr) return;
  riffle_kernel about{};
  about.size = sizeof about;
  kernel->table().kernel(kernel->self(), &about);
  const double needed = 2 * about.support * case_.smoothing_ratio;
  if (static_cast<double>(n) >= needed) return;
  std::ostringstream text;
  text << "initial.particles must be at least " << std::ceil(needed) << " for " << kernel->name()
       << " at smoothing_ratio " << case_.smoothing_ratio << ", whose support holds so many, got " << n;
  throw ScheduleError({text.str()});
}

void Simulation::look_at_scene() {
  std::vector<std::string> refused = idle_plugins(*graph_);
  const double spacing = case_.placement.spacing;
  if (case_.dimension > 1 && spacing > 0 && store_.role_begin(1) > 0) {
    const double depth = deepest_water(store_, spacing);
    for (auto& line : drowned_by_roughness(case_, depth)) refused.push_back(std::move(line));
    warnings_ = doubtful_resolution(case_, store_, depth);
    if (const std::string reader = reader_of_host_field(*graph_, "wall_distance"); !reader.empty()) {
      refresh({"wall_distance"});
      const double* distance = store_.data("wall_distance");
      if (std::none_of(distance, distance + store_.role_begin(1), [](double d) { return std::isfinite(d); }))
        refused.push_back(reader + " reads the distance to the nearest wall, and this scene has no walls");
    }
  }
  if (!refused.empty()) throw ScheduleError(refused);
}

}  // namespace riffle
