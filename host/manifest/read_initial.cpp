#include <fmt/format.h>

#include <algorithm>

#include "host/manifest/functions.hpp"
#include "host/manifest/keys.hpp"
#include "host/manifest/nearest.hpp"
#include "host/manifest/sections.hpp"
#include "host/manifest/tables.hpp"
#include "host/manifest/values.hpp"

namespace riffle {
namespace {

// Formulas and tables over an axis that the domain does not have would silently see 0 there.
void check_axes(Reading& reading, const ReadFunction& function, const SourcePlace& place, const std::string& key) {
  if (reading.dim == 0) return;
  const std::array<bool, 3> present{true, reading.dim == 3, reading.dim >= 2};
  constexpr std::array<const char*, 3> names{"x", "y", "z"};
  for (std::size_t axis = 0; axis < present.size(); ++axis) {
    if (!function.uses[axis] || present[axis]) continue;
    reading.mistakes.add(place, fmt::format("{} uses {}, but with domain.dimension = {} there {}", key, names[axis],
                                            reading.dim, reading.dim == 1 ? "is only x" : "are only x and z"));
  }
}

// The field as the equation set describes it. While the equation set is not known (a mistake already noted), any
// equation set that has a field of that name will do, so that mistakes in its value are found in the same go.
std::optional<FieldDescription> field_named(const Reading& reading, const std::string& name) {
  const PluginDescription* const chosen = equation_set(reading);
  for (const PluginDescription* plugin : reading.catalogue.all()) {
    if (chosen != nullptr ? plugin != chosen : plugin->kind != "equations") continue;
    for (const FieldDescription& field : plugin->initial) {
      if (field.name == name) return field;
    }
  }
  return std::nullopt;
}

std::optional<ReadFunction> read_component(Reading& reading, const TomlNode& node, const std::string& key,
                                           const FieldDescription& field) {
  auto function = read_function(reading, node, key, field.unit);
  if (!function) return std::nullopt;
  check_axes(reading, *function, node.place, key);
  if (field.not_negative && function->constant && *function->constant < 0) {
    reading.mistakes.add(node.place, fmt::format("{} must not be negative, got {}", key, node.shown()));
  }
  return function;
}

void read_field(Reading& reading, const TomlEntry& entry, const FieldDescription& field) {
  const std::string key = "initial." + field.name;
  if (entry.value.is_text() && entry.value.text == "reference") {
    reading.result.initial_from_reference.push_back(field.name);  // read_reference sees whether it gives the field
    effective_at(reading, key) = "reference";
    return;
  }
  const int wanted = reading.dim == 0 ? 0 : components(field.shape, reading.dim);
  const bool one = field.shape == Shape::scalar || (wanted <= 1 && !entry.value.is_array());
  std::vector<Function>& functions = reading.result.initial[field.name];
  if (one) {
    if (const auto function = read_component(reading, entry.value, key, field)) {
      functions.push_back(function->function);
      effective_at(reading, key) = function->effective;
    }
    return;
  }
  if (!entry.value.is_array() || (wanted > 0 && entry.value.items.size() != static_cast<std::size_t>(wanted))) {
    const std::string axes = wanted == 2 ? " (x, z)" : wanted == 3 && field.shape == Shape::vector ? " (x, y, z)" : "";
    reading.mistakes.add(
        entry.value.place,
        fmt::format("{} must be an array of {} function{}{}, one per component, got {}", key, wanted,
                    wanted == 1 ? "" : "s", axes,
                    entry.value.is_array() ? std::to_string(entry.value.items.size()) : entry.value.shown()));
    return;
  }
  nlohmann::ordered_json effective = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < entry.value.items.size(); ++k) {
    const auto function = read_component(reading, entry.value.items[k], fmt::format("{}[{}]", key, k), field);
    if (!function) continue;
    functions.push_back(function->function);
    effective.push_back(function->effective);
  }
  effective_at(reading, key) = effective;
}

bool has_depth(const PluginDescription& equations) {
  return std::any_of(equations.initial.begin(), equations.initial.end(),
                     [](const FieldDescription& field) { return field.name == "depth"; });
}

std::vector<std::string> initial_keys(const PluginDescription& equations) {
  std::vector<std::string> known;
  for (const FieldDescription& field : equations.initial) known.push_back(field.name);
  if (has_depth(equations)) known.emplace_back("level");
  known.insert(known.end(), {"particles", "inside"});
  return known;
}

void check_needed(Reading& reading, const TomlNode& initial, const PluginDescription& equations) {
  const std::vector<std::string> known = initial_keys(equations);
  for (const FieldDescription& field : equations.initial) {
    if (initial.find(field.name) != nullptr || !(field.needed || field.name == "depth")) continue;
    if (field.name == "depth" && initial.find("level") != nullptr) continue;
    if (misspelt(initial, field.name, known)) continue;
    reading.mistakes.add(initial.place, fmt::format("initial.{} is missing; equations \"{}\" needs it [{}]", field.name,
                                                    equations.id, field.unit));
  }
}

// initial.level stands for initial.depth; the bed that lies between them is a plugin's business.
void read_level(Reading& reading, const TomlNode& initial) {
  const TomlEntry* const level = initial.find("level");
  if (level == nullptr) return;
  if (initial.find("depth") != nullptr) {
    reading.mistakes.add(level->place, "initial must have either depth or level, got both");
    return;
  }
  const auto function = read_function(reading, level->value, "initial.level", "m");
  if (!function) return;
  check_axes(reading, *function, level->value.place, "initial.level");
  reading.result.level = function->function;
  effective_at(reading, "initial.level") = function->effective;
}

}  // namespace

void read_particles(Reading& reading) {
  const TomlNode* const initial = find_table(reading, "initial");
  if (initial == nullptr) return;
  const TomlEntry* const entry = initial->find("particles");
  const bool is_table = entry != nullptr && entry->value.is_table();
  if (!is_table) {
    reading.mistakes.add(entry != nullptr ? entry->value.place : initial->place,
                         fmt::format("initial.particles {}; it must be a table such as {{ spacing = \"5 mm\" }} or "
                                     "{{ count = 1000 }}",
                                     entry != nullptr ? "is " + entry->value.shown() : "is missing"));
  } else {
    const TomlNode& table = entry->value;
    const std::size_t before = reading.mistakes.count();
    const OwnTable own = read_own_table(reading, &table, "initial.particles");
    Placement& placement = reading.result.placement;
    placement.spacing = own.number("spacing", 0);
    placement.count = static_cast<std::int64_t>(own.number("count", 0));
    placement.perturbation = own.number("perturbation", 0);
    placement.seed = static_cast<std::uint64_t>(own.number("seed", 1));
    const bool by_volume = own.text("placement") == "equal-volume";
    const TomlEntry* const count = table.find("count");
    const TomlEntry* const spacing = table.find("spacing");
    if (by_volume) {
      placement.mode = reading.dim == 2 ? Placement::Mode::equal_volume_in_plane : Placement::Mode::equal_volume;
    } else {
      placement.mode = count != nullptr ? Placement::Mode::count : Placement::Mode::spacing;
    }
    if ((count != nullptr) == (spacing != nullptr)) {
      reading.mistakes.add(count != nullptr ? count->place : table.place,
                           fmt::format("initial.particles must have either spacing or count, got {}",
                                       count != nullptr ? "both" : "neither"));
    } else if (reading.dim > 1 && (count != nullptr || (by_volume && reading.dim == 3))) {
      reading.mistakes.add(
          count != nullptr ? count->place : table.find("placement")->value.place,
          fmt::format("initial.particles must be placed by spacing when domain.dimension is {}, got {}", reading.dim,
                      count != nullptr ? "count" : "placement = \"equal-volume\""));
    } else if (by_volume && reading.dim == 1 && count == nullptr && reading.mistakes.count() == before) {
      reading.mistakes.add(spacing->place,
                           "initial.particles with placement = \"equal-volume\" must have count, got spacing");
    }
  }
  if (const TomlEntry* const inside = initial->find("inside")) {
    const auto function = read_function(reading, inside->value, "initial.inside", "1");
    if (!function) return;
    check_axes(reading, *function, inside->value.place, "initial.inside");
    reading.result.placement.inside = function->function;
    effective_at(reading, "initial.inside") = function->effective;
  }
}

void read_initial_fields(Reading& reading) {
  const TomlEntry* const found = reading.root.find("initial");
  if (found == nullptr || !found->value.is_table()) return;
  const TomlNode& initial = found->value;
  const PluginDescription* const equations = equation_set(reading);
  for (const TomlEntry& entry : initial.entries) {
    if (entry.key == "particles" || entry.key == "inside") continue;
    if (entry.key == "level" && (equations == nullptr || has_depth(*equations))) {
      read_level(reading, initial);
      continue;
    }
    if (const auto field = field_named(reading, entry.key)) {
      read_field(reading, entry, *field);
    } else if (equations != nullptr) {
      const std::vector<std::string> known = initial_keys(*equations);
      std::string hint = did_you_mean(entry.key, known);
      if (hint.empty()) hint = "; it knows " + all_of(known);
      reading.mistakes.add(
          entry.place, fmt::format("equations \"{}\" has no initial field \"{}\"{}", equations->id, entry.key, hint));
    }
  }
  if (equations != nullptr) check_needed(reading, initial, *equations);
}

}  // namespace riffle
