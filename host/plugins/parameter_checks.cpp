#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "host/plugins/descriptor_checks.hpp"
#include "host/plugins/unit.hpp"

namespace riffle {
namespace {

std::string range_text(const riffle_parameter& p) {
  return fmt::format("{}{}, {}{}", (p.flags & RIFFLE_ABOVE_MIN) != 0 ? "(" : "[", p.min, p.max,
                     (p.flags & RIFFLE_BELOW_MAX) != 0 ? ")" : "]");
}

bool in_range(const riffle_parameter& p) {
  if (p.fallback < p.min || p.fallback > p.max) return false;
  if (p.fallback == p.min && (p.flags & RIFFLE_ABOVE_MIN) != 0) return false;
  return p.fallback != p.max || (p.flags & RIFFLE_BELOW_MAX) == 0;
}

void check_number(const riffle_parameter& p, const std::string& subject, Problems& problems) {
  if (std::isnan(p.min) || std::isnan(p.max) || p.min > p.max) {
    problems.add(fmt::format("{}: the range {} is empty", subject, range_text(p)));
    return;
  }
  const bool has_default = (p.flags & RIFFLE_REQUIRED) == 0 && p.inherit == nullptr;
  if (!has_default) return;
  if (!std::isfinite(p.fallback) || !in_range(p)) {
    problems.add(fmt::format("{}: default {} is outside {}", subject, p.fallback, range_text(p)));
  } else if (p.type == RIFFLE_INTEGER && p.fallback != std::floor(p.fallback)) {
    problems.add(fmt::format("{}: default {} of an integer is no whole number", subject, p.fallback));
  }
}

void check_choice(const riffle_parameter& p, const std::string& subject, Problems& problems) {
  const std::vector<std::string> words = split_words(text_or_empty(p.choices));
  const auto is_word = [](const std::string& word) {
    return !word.empty() && word.find_first_of(" \t\n\"'=,") == std::string::npos;
  };
  if (!std::all_of(words.begin(), words.end(), is_word)) {
    problems.add(fmt::format("{}: choices \"{}\" are no words separated by |", subject, text_or_empty(p.choices)));
  } else if (std::set<std::string>(words.begin(), words.end()).size() != words.size()) {
    problems.add(fmt::format("{}: choices \"{}\" hold one word twice", subject, p.choices));
  } else if ((p.flags & RIFFLE_REQUIRED) == 0 &&
             std::find(words.begin(), words.end(), text_or_empty(p.fallback_text)) == words.end()) {
    problems.add(fmt::format("{}: default \"{}\" is none of its choices \"{}\"", subject,
                             text_or_empty(p.fallback_text), p.choices));
  }
}

void check_parameter(const riffle_parameter& p, const std::string& subject, Problems& problems) {
  constexpr std::uint32_t known_flags = RIFFLE_REQUIRED | RIFFLE_ABOVE_MIN | RIFFLE_BELOW_MAX | RIFFLE_PATH;
  if ((p.flags & ~known_flags) != 0) problems.add(fmt::format("{}: unknown flags {:#x}", subject, p.flags));
  if (p.unit == nullptr || !parse_unit(p.unit)) {
    problems.add(fmt::format("{}: unit \"{}\" is no product of powers such as kg.m-3", subject, text_or_empty(p.unit)));
  }
  if (text_or_empty(p.doc).empty()) problems.add(fmt::format("{}: has no description", subject));
  if (p.inherit != nullptr && std::string_view(p.inherit).find('.') == std::string_view::npos) {
    problems.add(
        fmt::format("{}: inherits \"{}\", which is no manifest key such as fluid.gravity", subject, p.inherit));
  }
  switch (p.type) {
    case RIFFLE_REAL:
    case RIFFLE_INTEGER: check_number(p, subject, problems); break;
    case RIFFLE_BOOLEAN:
      if (p.fallback != 0 && p.fallback != 1) {
        problems.add(fmt::format("{}: default {} of a boolean is neither 0 nor 1", subject, p.fallback));
      }
      break;
    case RIFFLE_CHOICE: check_choice(p, subject, problems); break;
    case RIFFLE_TEXT: break;
    case RIFFLE_FUNCTION:
      if (!std::isfinite(p.fallback) && (p.flags & RIFFLE_REQUIRED) == 0) {
        problems.add(fmt::format("{}: default {} is not finite", subject, p.fallback));
      }
      break;
    default: problems.add(fmt::format("{}: unknown type {}", subject, p.type));
  }
}

}  // namespace

void check_parameters(const riffle_plugin& plugin, Problems& problems) {
  std::set<std::string> names;
  for (const riffle_parameter* p : Table(plugin.parameters)) {
    const std::string subject = fmt::format("parameter \"{}\"", text_or_empty(p->name));
    if (!is_name(p->name, '_')) {
      problems.add(fmt::format("{}: the name is not [a-z][a-z0-9_]*", subject));
    } else if (std::string_view(p->name) == "kind" || std::string_view(p->name) == "id") {
      problems.add(fmt::format("{}: the name is taken by the manifest itself", subject));
    } else if (!names.insert(p->name).second) {
      problems.add(fmt::format("{}: declared twice", subject));
    }
    check_parameter(*p, subject, problems);
  }
}

const riffle_parameter* find_parameter(const riffle_plugin& plugin, std::string_view name) {
  for (const riffle_parameter* p : Table(plugin.parameters)) {
    if (p->name != nullptr && name == p->name) return p;
  }
  return nullptr;
}

void check_condition(const riffle_plugin& plugin, const char* when, const std::string& subject, Problems& problems) {
  if (when == nullptr) return;
  const std::string_view text = when;
  const std::size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  const riffle_parameter* parameter = find_parameter(plugin, name);
  if (equals == std::string_view::npos || parameter == nullptr) {
    problems.add(fmt::format("{}: condition \"{}\" names no parameter of the plugin", subject, when));
    return;
  }
  if (parameter->type == RIFFLE_FUNCTION || parameter->type == RIFFLE_REAL) {
    problems.add(fmt::format("{}: condition \"{}\" compares a parameter that is no choice", subject, when));
    return;
  }
  if (parameter->type != RIFFLE_CHOICE) return;
  const std::vector<std::string> choices = split_words(text_or_empty(parameter->choices));
  for (const std::string& value : split_words(text.substr(equals + 1))) {
    if (std::find(choices.begin(), choices.end(), value) == choices.end()) {
      problems.add(fmt::format("{}: condition \"{}\": \"{}\" is none of the choices \"{}\"", subject, when, value,
                               text_or_empty(parameter->choices)));
    }
  }
}

}  // namespace riffle
