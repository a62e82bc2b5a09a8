#include "host/manifest/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "host/manifest/rules.hpp"

namespace riffle {
namespace {

using Form = ManifestKey::Form;
constexpr double none = std::numeric_limits<double>::infinity();
constexpr double largest_count = 2147483647;          // neighbour lists hold 32-bit indices
constexpr double largest_integer = 9007199254740992;  // 2^53: every integer up to here is a double

ManifestKey key(const std::string& table, const std::string& name, ParameterType type, const std::string& doc) {
  ManifestKey made;
  made.table = table;
  made.value.name = name;
  made.value.unit = std::string("1");
  made.value.type = type;
  made.value.doc = doc;
  return made;
}
ManifestKey real(const std::string& path_table, const std::string& name, const std::string& unit, double min,
                 double max, const std::string& doc) {
  ManifestKey made = key(path_table, name, ParameterType::real, doc);
  made.value.unit = unit;
  made.value.min = min;
  made.value.max = max;
  return made;
}
ManifestKey integer(const std::string& table, const std::string& name, double min, double max, const std::string& doc) {
  ManifestKey made = real(table, name, "1", min, max, doc);
  made.value.type = ParameterType::integer;
  return made;
}
ManifestKey choice(const std::string& table, const std::string& name, std::vector<std::string> words,
                   const std::string& doc) {
  ManifestKey made = key(table, name, ParameterType::choice, doc);
  made.value.choices = std::move(words);
  made.value.fallback_text = made.value.choices.front();
  return made;
}
ManifestKey with_default(ManifestKey made, double value) {
  made.value.fallback = value;
  return made;
}
ManifestKey above_min(ManifestKey made) {
  made.value.above_min = true;
  return made;
}
ManifestKey required(ManifestKey made) {
  made.value.required = true;
  return made;
}
ManifestKey optional(ManifestKey made) {
  made.optional = true;
  return made;
}
ManifestKey formed(ManifestKey made, Form form) {
  made.form = form;
  return made;
}

ManifestKey text_default(ManifestKey made, const std::string& value) {
  made.value.fallback_text = value;
  return made;
}
ManifestKey file_key(const std::string& table, const std::string& name, const std::string& doc) {
  ManifestKey made = key(table, name, ParameterType::text, doc);
  made.value.path = true;
  return made;
}

std::vector<std::string> kinds_of_slots() {
  std::vector<std::string> kinds = plugin_kinds();
  kinds.erase(std::remove(kinds.begin(), kinds.end(), "reference"), kinds.end());
  return kinds;
}

ManifestKey water_level() {
  ManifestKey made = key("initial", "level", ParameterType::function,
                         "level of the water at t = 0, instead of depth, which is then what lies above the bed");
  made.value.unit = "m";
  return made;
}

std::vector<ManifestKey> make_keys() {
  const ParameterType text = ParameterType::text;
  ManifestKey name = required(key("case", "name", text, "short name; the folder of the run is called after it"));
  name.pattern = "[a-z0-9][a-z0-9.-]*";
  name.pattern_in_words = "a word of a-z, 0-9, - and . that begins with a letter or digit";
  ManifestKey perturbation = with_default(
      real("initial.particles", "perturbation", "1", 0, 0.5, "largest random displacement over the local spacing"), 0);
  perturbation.value.below_max = true;
  return {
      name,
      key("case", "title", text, "one line for pictures and records; the name when absent"),

      with_default(integer("domain", "dimension", 1, 3, "1: axis x; 2: x and z in the vertical plane; 3: x, y, z"), 1),
      required(formed(real("domain", "x", "m", -none, none, "extent along the channel"), Form::interval)),
      optional(formed(real("domain", "y", "m", -none, none, "extent across; dimension 3 only"), Form::interval)),
      optional(formed(real("domain", "z", "m", -none, none, "extent upwards; dimensions 2 and 3"), Form::interval)),
      required(above_min(
          real("domain", "smoothing_ratio", "1", 0, none, "smoothing length over particle spacing at t = 0"))),

      with_default(real("fluid", "gravity", "m.s-2", 0, none, "acceleration of gravity; the constant g of formulas"),
                   9.81),
      with_default(above_min(real("fluid", "density", "kg.m-3", 0, none, "density of the water")), 1000),
      with_default(real("fluid", "viscosity", "m2.s-1", 0, none, "kinematic viscosity of the water"), 1e-6),

      optional(water_level()),
      optional(key("initial", "inside", ParameterType::function, "particles are placed only where it is above 0")),
      optional(
          above_min(real("initial.particles", "spacing", "m", 0, none, "distance between particles; this or count"))),
      optional(integer("initial.particles", "count", 1, largest_count,
                       "number of particles, in one dimension; this or spacing")),
      choice("initial.particles", "placement", {"equal-spacing", "equal-volume"},
             "whether particles share the wetted space equally, or the water (by count, or in the vertical plane)"),
      perturbation,
      with_default(integer("initial.particles", "seed", 0, largest_integer, "picks the random displacements"), 1),

      optional(choice("plugins", "kind", kinds_of_slots(), "what the plugin is; only when the slot's name is no kind")),
      required(key("plugins", "id", text, "which plugin; its parameters follow in the same table")),

      required(above_min(real("time", "end", "s", 0, none, "simulated time at which the run ends"))),
      with_default(above_min(real("time", "cfl", "1", 0, none, "multiplies the time-step limits that scale")), 0.5),
      optional(above_min(real("time", "step", "s", 0, none, "fixed time step, instead of the limits"))),
      real("time", "max_step", "s", 0, none, "longest time step; 0: no such limit"),
      integer("time", "max_steps", 0, largest_integer, "the run ends after so many steps; 0: no such limit"),
      choice("time", "integrator",
             {"leap-frog", "semi-implicit-euler", "predictor-corrector", "predictor-verlet", "ssp-rk2", "ssp-rk3"},
             "the equation set's first one when it does not work with the default"),
      choice("time", "drag", {"implicit", "explicit"}, "how drag rates are applied; implicit is always stable"),

      real("output", "snapshots", "s", 0, none, "simulated time between snapshots; 0: only the first and the last"),
      real("output", "profiles", "s", 0, none, "simulated time between profiles; 0: only the last"),
      real("output", "checkpoint", "s", 0, none, "simulated time between checkpoints; 0: none"),
      real("output", "checkpoint_wall", "s", 0, none, "wall-clock time between checkpoints; 0: none"),
      real("output", "averages", "s", 0, none,
           "simulated time between samples of the averages of steady flow by height; 0: none"),
      real("output", "averages_from", "s", 0, none, "when their sampling begins"),
      with_default(key("output", "picture", ParameterType::boolean, "whether to draw the picture of the run"), 1),
      formed(key("output", "fields", text, "fields to write; none named: initial and evolved fields"), Form::words),

      required(key("reference", "id", text, "which reference solution; its parameters follow in the same table")),
      optional(formed(key("reference", "ignore_below", ParameterType::real,
                          "field = value: particles whose exact value is below are left out of the errors"),
                      Form::limits)),
      optional(formed(
          real("reference", "region", "m", -none, none, "extent in x: particles outside are left out of the errors"),
          Form::interval)),

      required(file_key("surface", "csv", "measured levels of the free surface: a table in CSV, in SI units")),
      text_default(key("surface", "time", text, "its column of times"), "t"),
      text_default(key("surface", "x", text, "its column of abscissae"), "x"),
      text_default(key("surface", "level", text, "its column of levels"), "z"),
  };
}

std::string values_in_words(const ManifestKey& key) {
  if (key.form == Form::words) return "array of texts";
  if (key.form == Form::limits) return "table of quantities";
  if (key.value.type == ParameterType::function) return "a function (see below)";
  const std::string rule = key.pattern.empty() ? rule_in_words(key.value, 1) : key.pattern_in_words;
  return key.form == Form::interval ? fmt::format("[low, high], each {}", rule) : rule;
}

std::string default_in_words(const ManifestKey& key) {
  if (key.value.required) return "required";
  if (key.optional) return "none";
  if (key.form == Form::words) return "[]";
  switch (key.value.type) {
    case ParameterType::boolean: return key.value.fallback != 0 ? "true" : "false";
    case ParameterType::choice:
    case ParameterType::text: return fmt::format("\"{}\"", key.value.fallback_text);
    default: break;
  }
  const bool has_unit = key.value.unit != "1";
  return fmt::format("{}{}{}", key.value.fallback, has_unit ? " " : "", has_unit ? key.value.unit : "");
}

}  // namespace

const std::vector<ManifestKey>& manifest_keys() {
  static const std::vector<ManifestKey> keys = make_keys();
  return keys;
}

const std::vector<ManifestTable>& manifest_tables() {
  static const std::vector<ManifestTable> tables{
      {"case", true, "what the case is called"},
      {"domain", true, "where it happens"},
      {"fluid", false, "the water and gravity"},
      {"initial", true, "particles and fields at t = 0"},
      {"plugins", true, "the physics: one table [plugins.<slot>] per plugin"},
      {"time", true, "how long, and in which steps"},
      {"output", false, "what is written"},
      {"reference", false, "the solution to compare with, a plugin of kind reference"},
      {"surface", false, "measured free surfaces to compare with"},
  };
  return tables;
}

std::vector<const ManifestKey*> keys_of(const std::string& table) {
  std::vector<const ManifestKey*> found;
  for (const ManifestKey& key : manifest_keys()) {
    if (key.table == table) found.push_back(&key);
  }
  return found;
}

const ManifestKey& manifest_key(const std::string& path) {
  for (const ManifestKey& key : manifest_keys()) {
    if (key.path() == path) return key;
  }
  throw std::logic_error("the table of manifest keys has no \"" + path + '"');
}

std::string keys_in_markdown() {
  std::string text = "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const ManifestKey& key : manifest_keys()) {
    const std::string table = key.table == "plugins" ? "plugins.<slot>" : key.table;
    text += fmt::format("| `{}.{}` | {} | {} | {} |\n", table, key.value.name, values_in_words(key),
                        default_in_words(key), key.value.doc);
  }
  return text;
}

}  // namespace riffle
