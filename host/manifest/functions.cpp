#include "host/manifest/functions.hpp"

#include <fmt/format.h>

#include <utility>

#include "host/manifest/csv_table.hpp"
#include "host/manifest/formula.hpp"
#include "host/manifest/function_kinds.hpp"
#include "host/manifest/nearest.hpp"
#include "host/manifest/rules.hpp"
#include "host/manifest/units.hpp"
#include "host/manifest/values.hpp"

namespace riffle {
namespace {

const std::vector<std::string>& axis_names() {
  static const std::vector<std::string> names{"x", "y", "z", "t"};
  return names;
}

const std::vector<std::string>& piecewise_keys() {
  static const std::vector<std::string> keys{"x", "y", "z", "t", "values", "csv"};
  return keys;
}
const std::vector<std::string>& table_keys() {
  static const std::vector<std::string> keys{"x", "y", "z", "t", "csv", "value", "outside"};
  return keys;
}

// Reads one function; the parts of a message that stay the same are its members.
class FunctionReader {
 public:
  FunctionReader(Reading& reading, const std::string& key, const std::string& unit) : reading_(reading), key_(key) {
    description_.name = key;
    description_.unit = unit;
    description_.type = ParameterType::real;
  }

  std::optional<ReadFunction> read(const TomlNode& node) {
    if (node.is_number()) return constant(node);
    if (node.is_text()) return split_quantity(node.text) && !is_bare_number(node.text) ? constant(node) : formula(node);
    if (node.is_table()) return node.find("csv") != nullptr ? table(node) : piecewise(node);
    ParameterDescription any = description_;
    any.type = ParameterType::function;
    add(node.place, fmt::format("{} must be {}, got {}", key_, rule_in_words(any, reading_.dim), node.shown()));
    return std::nullopt;
  }

 private:
  void add(const SourcePlace& place, const std::string& sentence) { reading_.mistakes.add(place, sentence); }

  static bool is_bare_number(const std::string& text) {
    const auto quantity = split_quantity(text);
    return quantity && quantity->unit.empty();
  }

  std::optional<ReadFunction> constant(const TomlNode& node) {
    const auto value = read_real(reading_, node, key_, description_);
    if (!value) return std::nullopt;
    ReadFunction read = constant_function(*value);
    read.function = Function(constant_values(*value), node.is_text() ? node.text : node.shown());
    return read;
  }

  std::optional<ReadFunction> formula(const TomlNode& node) {
    try {
      const Formula parsed = parse_formula(node.text, reading_.result.gravity);
      ReadFunction read;
      read.function = Function(parsed.implementation, node.text);
      read.effective = node.text;
      read.uses = parsed.uses;
      return read;
    } catch (const FormulaError& error) {
      const SourcePlace place = error.byte ? node.character(*error.byte) : node.place;
      const std::string where = error.byte ? fmt::format(" at character {}", *error.byte + 1) : "";
      add(place, fmt::format("{}: the formula {} does not parse{}: {}", key_, node.shown(), where, error.what()));
      return std::nullopt;
    }
  }

  // The one of x, y, z, t that the table runs over; nothing after a mistake.
  std::optional<std::size_t> axis(const TomlNode& node, const std::string& example) {
    std::optional<std::size_t> found;
    int count = 0;
    for (std::size_t k = 0; k < axis_names().size(); ++k) {
      if (node.find(axis_names()[k]) == nullptr) continue;
      found = k;
      ++count;
    }
    if (count == 1) return found;
    add(node.place, fmt::format("{} must run over exactly one of x, y, z and t, as in {}", key_, example));
    return std::nullopt;
  }

  std::optional<ReadFunction> piecewise(const TomlNode& node) {
    const std::string example = "{ x = [0, 5], values = [10, \"x\", 5] }";
    refuse_unknown_keys(reading_, node, key_, piecewise_keys());
    const auto over = axis(node, example);
    const TomlEntry* const values = node.find("values");
    if (values == nullptr && !misspelt(node, "values", piecewise_keys()))
      add(node.place, fmt::format("{}.values is missing; it must be as in {}", key_, example));
    if (!over || values == nullptr) return std::nullopt;
    const std::string& name = axis_names()[*over];
    const TomlNode& breaks = node.find(name)->value;
    for (const auto& [part, list] : {std::pair(name, &breaks), std::pair(std::string("values"), &values->value)}) {
      if (list->is_array() && !list->items.empty()) continue;
      add(list->place, fmt::format("{}.{} must be an array as in {}, got {}", key_, part, example, list->shown()));
      return std::nullopt;
    }

    const std::size_t before = reading_.mistakes.count();
    ReadFunction read;
    read.uses[*over] = true;
    const std::vector<double> at = break_points(breaks, key_ + '.' + name, *over);
    const std::vector<Function> pieces = piece_functions(values->value, read);
    if (breaks.items.size() + 1 != values->value.items.size()) {
      add(values->value.place, fmt::format("{}.values must have one value more than {} has breaks, so {}, got {}", key_,
                                           name, breaks.items.size() + 1, values->value.items.size()));
    }
    if (reading_.mistakes.count() != before) return std::nullopt;
    read.effective = {{name, at}, {"values", read.effective}};
    read.function = Function(piecewise_values(*over, at, pieces), read.effective.dump());
    return read;
  }

  std::vector<double> break_points(const TomlNode& breaks, const std::string& shown, std::size_t over) {
    ParameterDescription coordinate = description_;
    coordinate.unit = over == 3 ? "s" : "m";
    std::vector<double> at;
    for (std::size_t k = 0; k < breaks.items.size(); ++k) {
      const auto value = read_real(reading_, breaks.items[k], fmt::format("{}[{}]", shown, k), coordinate);
      if (!value) return at;
      if (!at.empty() && !(*value > at.back())) {
        add(breaks.items[k].place, fmt::format("{} must increase, got {} after {}", shown, breaks.items[k].shown(),
                                               breaks.items[k - 1].shown()));
        return at;
      }
      at.push_back(*value);
    }
    return at;
  }

  std::vector<Function> piece_functions(const TomlNode& values, ReadFunction& whole) {
    std::vector<Function> pieces;
    whole.effective = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < values.items.size(); ++k) {
      const TomlNode& item = values.items[k];
      const std::string shown = fmt::format("{}.values[{}]", key_, k);
      if (item.is_table() || item.is_array()) {
        add(item.place, fmt::format("{} must be a quantity or a formula, got {}", shown, item.shown()));
        continue;
      }
      const auto piece = FunctionReader(reading_, shown, description_.unit).read(item);
      if (!piece) continue;
      pieces.push_back(piece->function);
      whole.effective.push_back(piece->effective);
      for (std::size_t a = 0; a < whole.uses.size(); ++a) whole.uses[a] = whole.uses[a] || piece->uses[a];
    }
    return pieces;
  }

  std::optional<ReadFunction> table(const TomlNode& node) {
    const std::string example = "{ csv = \"bed.csv\", x = \"x\", value = \"level\" }";
    const std::size_t before = reading_.mistakes.count();
    refuse_unknown_keys(reading_, node, key_, table_keys());
    const auto over = axis(node, example);
    const TomlEntry* const value = node.find("value");
    if (value == nullptr && !misspelt(node, "value", table_keys()))
      add(node.place, fmt::format("{}.value is missing; it names a column, as in {}", key_, example));
    if (!over || value == nullptr) return std::nullopt;
    const std::string& name = axis_names()[*over];
    const TomlNode& file = node.find("csv")->value;
    const TomlNode& abscissa = node.find(name)->value;
    for (const auto& [part, text] : {std::pair(std::string("csv"), &file), std::pair(name, &abscissa),
                                     std::pair(std::string("value"), &value->value)}) {
      if (text->is_text()) continue;
      add(text->place,
          fmt::format("{}.{} must be a text in quotes, as in {}, got {}", key_, part, example, text->shown()));
    }
    const bool undefined_outside = outside(node);
    if (reading_.mistakes.count() != before) return std::nullopt;

    ReadFunction read;
    try {
      const CsvTable csv(reading_.folder / file.text, file.text);
      for (const auto& [part, column] : {std::pair(name, &abscissa), std::pair(std::string("value"), &value->value)}) {
        if (csv.has(column->text)) continue;
        std::string hint = did_you_mean(column->text, csv.columns());
        if (hint.empty()) hint = "; it has " + all_of(csv.columns());
        add(column->place, fmt::format("{}.{}: {} has no column \"{}\"{}", key_, part, file.text, column->text, hint));
      }
      if (reading_.mistakes.count() != before) return std::nullopt;
      const std::vector<double> at = csv.increasing_numbers(abscissa.text);
      if (undefined_outside && !covers_the_case(node, name, at)) return std::nullopt;
      read.effective = {{"csv", file.text},
                        {name, abscissa.text},
                        {"value", value->value.text},
                        {"outside", undefined_outside ? "error" : "constant"}};
      read.function =
          Function(table_values(*over, at, csv.numbers(value->value.text), undefined_outside), read.effective.dump());
    } catch (const TableError& error) {
      add(file.place, fmt::format("{}.csv: {}", key_, error.what()));
      return std::nullopt;
    }
    read.uses[*over] = true;
    return read;
  }

  bool outside(const TomlNode& node) {
    const TomlEntry* const entry = node.find("outside");
    if (entry == nullptr) return false;
    ParameterDescription choice;
    choice.name = "outside";
    choice.type = ParameterType::choice;
    choice.choices = {"constant", "error"};
    const auto read = read_value(reading_, entry->value, key_ + ".outside", choice);
    return read && read->value.text == "error";
  }

  // With outside = "error" the table must reach over the domain, or over the simulated time.
  bool covers_the_case(const TomlNode& node, const std::string& axis_name, const std::vector<double>& at) {
    const bool time = axis_name == "t";
    const auto low = reading_.quantities.find(time ? "time.begin" : "domain." + axis_name + "_min");
    const auto high = reading_.quantities.find(time ? "time.end" : "domain." + axis_name + "_max");
    if (low == reading_.quantities.end() || high == reading_.quantities.end()) return true;
    if (at.front() <= low->second && at.back() >= high->second) return true;
    add(node.find("csv")->value.place,
        fmt::format("{}: with outside = \"error\" the table must reach from {} = {} to {}, it goes from {} to {}", key_,
                    axis_name, low->second, high->second, at.front(), at.back()));
    return false;
  }

  Reading& reading_;
  std::string key_;
  ParameterDescription description_;  // as a constant
};

}  // namespace

ReadFunction constant_function(double value) {
  ReadFunction read;
  read.function = Function(constant_values(value), fmt::format("{}", value));
  read.effective = value;
  read.constant = value;
  return read;
}

std::optional<ReadFunction> read_function(Reading& reading, const TomlNode& node, const std::string& key,
                                          const std::string& unit) {
  return FunctionReader(reading, key, unit).read(node);
}

}  // namespace riffle
