#include "host/study/read_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "host/manifest/document.hpp"
#include "host/manifest/nearest.hpp"
#include "host/manifest/reading.hpp"
#include "host/manifest/rules.hpp"
#include "host/manifest/values.hpp"
#include "host/study/read_variations.hpp"
#include "host/study/study_keys.hpp"

namespace riffle {
namespace {

struct Given {
  std::vector<ParameterValue> values;  // one, or those of the array
  std::vector<SourcePlace> places;
};

// The keys of one of the study's own tables, by name; those that are absent or mistaken are not among them.
class OwnKeys {
 public:
  OwnKeys(Reading& reading, const TomlNode& table, const std::string& name,
          const std::vector<std::string>& further = {}) {
    std::vector<std::string> known = further;
    for (const StudyKey* key : study_keys_of(name)) known.push_back(key->value.name);
    for (const StudyKey* key : study_keys_of(name)) {
      const std::string path = name + '.' + key->value.name;
      const TomlEntry* const entry = table.find(key->value.name);
      if (entry != nullptr) {
        read(reading, *key, path, entry->value);
      } else if (key->value.required && !misspelt(table, key->value.name, known)) {
        reading.mistakes.add(table.place,
                             fmt::format("{} is missing; it must be {}", path, rule_in_words(key->value, 1)));
      }
    }
    refuse_unknown_keys(reading, table, '[' + name + ']', known);
  }

  [[nodiscard]] const Given* find(const std::string& key) const {
    const auto found = given_.find(key);
    return found == given_.end() ? nullptr : &found->second;
  }
  [[nodiscard]] std::string text(const std::string& key, const std::string& otherwise = "") const {
    const Given* const given = find(key);
    return given == nullptr ? otherwise : given->values.front().text;
  }
  [[nodiscard]] double number(const std::string& key, double otherwise) const {
    const Given* const given = find(key);
    return given == nullptr ? otherwise : given->values.front().number;
  }
  [[nodiscard]] SourcePlace place(const std::string& key) const {
    const Given* const given = find(key);
    return given == nullptr ? SourcePlace{} : given->places.front();
  }

 private:
  void read(Reading& reading, const StudyKey& key, const std::string& path, const TomlNode& node) {
    Given given;
    if (key.list && node.is_array() && node.items.empty()) {
      reading.mistakes.add(node.place, path + " is empty: the study would have no runs");
      return;
    }
    const std::vector<TomlNode> nodes = key.list && node.is_array() ? node.items : std::vector<TomlNode>{node};
    for (const TomlNode& one : nodes) {
      const auto value = read_value(reading, one, path, key.value);
      if (!value) return;
      given.values.push_back(value->value);
      given.places.push_back(one.place);
    }
    given_[key.value.name] = std::move(given);
  }

  std::map<std::string, Given> given_;
};

void check_name(Reading& reading, const SourcePlace& place, const std::string& name) {
  const bool good = !name.empty() &&
                    name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-.") == std::string::npos &&
                    name.front() != '-' && name.front() != '.';
  if (good) return;
  reading.mistakes.add(place, fmt::format("study.name must be a word of a-z, 0-9, - and . that begins with a letter or "
                                          "digit, got \"{}\"",
                                          name));
}

void read_own(Reading& reading, const TomlNode& table, Study& study) {
  const OwnKeys own(reading, table, "study");
  study.name = own.text("name");
  if (own.find("name") != nullptr) check_name(reading, own.place("name"), study.name);
  study.title = own.text("title", study.name);
  study.cost = own.text("cost", study.cost);
  study.baseline = own.text("baseline");
  study.baseline_place = own.place("baseline");
  study.repeats = static_cast<int>(own.number("repeats", study.repeats));
  study.exclusive = own.text("timing") == "exclusive";
  study.pictures = own.number("pictures", 1) != 0;
  study.time_limit = own.number("time_limit", 0);
  study.runs_at_most = static_cast<std::size_t>(own.number("runs_at_most", static_cast<double>(study.runs_at_most)));
  if (const Given* const threads = own.find("threads")) {
    study.threads.clear();
    for (const auto& value : threads->values) study.threads.push_back(static_cast<int>(value.number));
  }
  if (const Given* const errors = own.find("error")) {
    for (const auto& value : errors->values) study.errors.push_back(value.text);
    study.error_places = errors->places;
  }
  const Given* const cases = own.find("cases");
  if (cases == nullptr) return;
  for (std::size_t k = 0; k < cases->values.size(); ++k) {
    const std::filesystem::path path = study.file.parent_path() / cases->values[k].text;
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
      reading.mistakes.add(cases->places[k], fmt::format("study.cases: there is no manifest {}", path.string()));
    }
    study.cases.push_back(path);
    study.case_places.push_back(cases->places[k]);
  }
}

MapAxis read_axis(Reading& reading, const TomlNode& map, const std::string& name) {
  MapAxis axis;
  const TomlEntry* const entry = map.find(name);
  if (entry == nullptr || !entry->value.is_table()) {
    reading.mistakes.add(entry == nullptr ? map.place : entry->place,
                         fmt::format("map.{} must be a table with key, from and to", name));
    return axis;
  }
  const OwnKeys own(reading, entry->value, "map." + name);
  axis.place = entry->place;
  axis.key = own.text("key");
  axis.name = short_name(axis.key);
  axis.low = own.number("from", 0);
  axis.high = own.number("to", 1);
  axis.points = static_cast<int>(own.number("points", axis.points));
  axis.logarithmic = own.text("scale") == "logarithmic";
  axis.whole = own.number("whole", 0) != 0;
  if (own.find("from") == nullptr || own.find("to") == nullptr) return axis;
  if (!(axis.low < axis.high)) {
    reading.mistakes.add(own.place("to"), fmt::format("map.{0}.to must be above map.{0}.from = {1:g}, got {2:g}", name,
                                                      axis.low, axis.high));
  }
  if (axis.logarithmic && !(axis.low > 0)) {
    reading.mistakes.add(own.place("from"),
                         fmt::format("map.{}.from must be above 0 on a logarithmic scale, got {:g}", name, axis.low));
  }
  return axis;
}

void read_map(Reading& reading, const TomlNode& table, Study& study) {
  const OwnKeys own(reading, table, "map", {"x", "y"});
  StabilityMap map;
  map.error_bound = own.number("error_bound", 0);
  map.search = static_cast<int>(own.number("search", map.search));
  map.axes = {read_axis(reading, table, "x"), read_axis(reading, table, "y")};
  if (map.axes[0].name == map.axes[1].name) {
    for (MapAxis& axis : map.axes) axis.name = axis.key;
  }
  if (!map.axes[0].key.empty() && map.axes[0].key == map.axes[1].key) {
    reading.mistakes.add(map.axes[1].place,
                         fmt::format("map.y must have another key than map.x, got {} for both", map.axes[0].key));
  }
  study.map = map;
}

// What compare and stability do not share.
void check_purpose(Reading& reading, const TomlNode& root, StudyPurpose purpose) {
  if (purpose == StudyPurpose::compare) {
    if (const TomlEntry* const map = root.find("map")) {
      reading.mistakes.add(map->place, "[map] is for riffle stability; riffle compare varies with [vary]");
    }
    return;
  }
  if (root.find("map") == nullptr) {
    reading.mistakes.add({root.place.source, 1, 1}, "the table [map] is missing (the two parameters that are mapped)");
  }
  for (const char* name : {"vary", "resolution"}) {
    if (const TomlEntry* const table = root.find(name)) {
      reading.mistakes.add(table->place,
                           fmt::format("[{}] is for riffle compare; riffle stability varies the two keys of "
                                       "[map], for each of [closures]",
                                       name));
    }
  }
}

}  // namespace

double MapAxis::value(int k) const {
  if (points < 2) return low;
  const double share = static_cast<double>(k) / (points - 1);
  const double exact = logarithmic ? low * std::pow(high / low, share) : low + (high - low) * share;
  if (whole) return std::round(exact);
  // Rounded to six digits: so that keys are short, and the same on every machine.
  return k == points - 1 ? high : std::stod(fmt::format("{:.6g}", exact));
}

Study read_study(const std::filesystem::path& file, StudyPurpose purpose, const PluginCatalogue& catalogue) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw ManifestError({file.string() + ": no such study"});
  const TomlNode root = read_document(file);
  Reading reading(root, catalogue);
  Study study;
  study.file = file;
  const std::vector<std::string> known{"study", "set", "vary", "resolution", "closures", "map"};
  for (const TomlEntry& entry : root.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    std::string hint = did_you_mean(entry.key, known);
    if (hint.empty()) hint = "; there are " + all_of(known);
    reading.mistakes.add(entry.place,
                         fmt::format("unknown {} \"{}\"{}", entry.value.is_table() ? "table" : "key", entry.key, hint));
  }
  const TomlEntry* const own = root.find("study");
  if (own != nullptr && own->value.is_table()) {
    read_own(reading, own->value, study);
  } else if (!misspelt(root, "study", known)) {
    reading.mistakes.add({file.string(), 1, 1}, "the table [study] is missing (name and cases)");
  }
  read_variations(root, study, reading.mistakes);
  check_purpose(reading, root, purpose);
  const TomlEntry* const map = root.find("map");
  if (map != nullptr && map->value.is_table() && purpose == StudyPurpose::stability)
    read_map(reading, map->value, study);
  reading.mistakes.throw_if_any();
  return study;
}

}  // namespace riffle
