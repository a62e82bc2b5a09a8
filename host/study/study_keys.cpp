#include "host/study/study_keys.hpp"

#include <fmt/format.h>

#include <limits>

#include "host/manifest/rules.hpp"

namespace riffle {
namespace {

ParameterDescription described(const std::string& name, ParameterType type, const std::string& doc) {
  ParameterDescription value;
  value.name = name;
  value.type = type;
  value.unit = "1";
  value.doc = doc;
  return value;
}

ParameterDescription required(ParameterDescription value) {
  value.required = true;
  return value;
}

ParameterDescription text(const std::string& name, const std::string& doc) {
  return described(name, ParameterType::text, doc);
}

ParameterDescription integer(const std::string& name, double low, double high, double fallback,
                             const std::string& doc) {
  ParameterDescription value = described(name, ParameterType::integer, doc);
  value.min = low;
  value.max = high;
  value.fallback = fallback;
  return value;
}

ParameterDescription boolean(const std::string& name, bool fallback, const std::string& doc) {
  ParameterDescription value = described(name, ParameterType::boolean, doc);
  value.fallback = fallback ? 1 : 0;
  return value;
}

ParameterDescription choice(const std::string& name, const std::vector<std::string>& choices, const std::string& doc) {
  ParameterDescription value = described(name, ParameterType::choice, doc);
  value.choices = choices;
  value.fallback_text = choices.front();
  return value;
}

ParameterDescription positive(const std::string& name, const std::string& unit, const std::string& doc) {
  ParameterDescription value = described(name, ParameterType::real, doc);
  value.unit = unit;
  value.max = std::numeric_limits<double>::infinity();
  value.above_min = true;
  return value;
}

std::vector<StudyKey> make_keys() {
  std::vector<StudyKey> keys{
      {"study", required(text("name", "short name; the folder of the results is called after it"))},
      {"study", text("title", "one line for charts and report; the name when absent")},
      {"study", required(text("cases", "one manifest or several, relative to the study")), true},
      {"study",
       text("error",
            "what is judged: one number of run.json or several, such as \"errors.depth.l1\"; the first "
            "error that there is when absent"),
       true},
      {"study", text("cost", "what it costs: a number of run.json; \"cpu_seconds\" when absent")},
      {"study",
       text("baseline", "label of the closure, or of the whole combination, that others are measured against")},
      {"study", integer("threads", 1, 1024, 1, "threads of a run; several numbers are compared like closures"), true},
      {"study", integer("repeats", 1, 1000, 1, "how often each run is done, for the spread of its timings")},
      {"study", choice("timing", {"shared", "exclusive"},
                       "exclusive: one run at a time, so that none disturbs another's "
                       "timing")},
      {"study",
       positive("time_limit", "s", "wall time after which a run is stopped as too slow; no limit when absent")},
      {"study", integer("runs_at_most", 1, 1e6, 500, "more runs than this need --yes")},
      {"study", boolean("pictures", true, "whether each run draws its picture")},
      {"map", required(positive("error_bound", "1", "runs with a larger error than this are inaccurate"))},
      {"map", integer("search", 2, 1000, 4,
                      "points along each axis of the grid that is looked at first; all where there are no more")},
  };
  for (const char* axis : {"map.x", "map.y"}) {
    keys.push_back({axis, required(text("key", "the key of the manifest that runs along this axis"))});
    keys.push_back({axis, required(described("from", ParameterType::real, "its first value"))});
    keys.push_back({axis, required(described("to", ParameterType::real, "its last value"))});
    keys.push_back({axis, integer("points", 2, 1000, 20, "number of values")});
    keys.push_back({axis, choice("scale", {"linear", "logarithmic"}, "how they are spaced")});
    keys.push_back({axis, boolean("whole", false, "whether they are rounded to whole numbers")});
  }
  return keys;
}

std::string fallback_of(const StudyKey& key) {
  const ParameterDescription& value = key.value;
  if (value.required) return "required";
  switch (value.type) {
    case ParameterType::integer: return fmt::format("{}", static_cast<long>(value.fallback));
    case ParameterType::boolean: return value.fallback != 0 ? "true" : "false";
    case ParameterType::choice: return '"' + value.fallback_text + '"';
    default: return "-";
  }
}

}  // namespace

const std::vector<StudyKey>& study_keys() {
  static const std::vector<StudyKey> keys = make_keys();
  return keys;
}

std::vector<const StudyKey*> study_keys_of(const std::string& table) {
  std::vector<const StudyKey*> found;
  for (const StudyKey& key : study_keys()) {
    if (key.table == table) found.push_back(&key);
  }
  return found;
}

std::string study_keys_in_markdown() {
  std::string out = "| key | value | default | meaning |\n|---|---|---|---|\n";
  for (const StudyKey& key : study_keys()) {
    out += fmt::format("| `{}.{}` | {}{} | {} | {} |\n", key.table, key.value.name, rule_in_words(key.value, 1),
                       key.list ? ", or several in an array" : "", fallback_of(key), key.value.doc);
  }
  return out;
}

}  // namespace riffle
