#include "host/cli/describe.hpp"

#include <fmt/format.h>

#include <iostream>

#include "host/cli/common.hpp"
#include "host/manifest/nearest.hpp"

namespace riffle {

namespace {

std::string range_of(const ParameterDescription& p) {
  switch (p.type) {
    case ParameterType::choice: return fmt::format("one of {}", fmt::join(p.choices, ", "));
    case ParameterType::boolean: return "true or false";
    case ParameterType::text: return p.path ? "a path" : "text";
    case ParameterType::function: return "a number, formula, piecewise values or table";
    default: return fmt::format("{}{:g}, {:g}{}", p.above_min ? "(" : "[", p.min, p.max, p.below_max ? ")" : "]");
  }
}

std::string default_of(const ParameterDescription& p) {
  if (p.required) return "required";
  if (!p.inherit.empty()) return "from " + p.inherit;
  if (p.type == ParameterType::choice || p.type == ParameterType::text) return "\"" + p.fallback_text + "\"";
  if (p.type == ParameterType::boolean) return p.fallback != 0 ? "true" : "false";
  return fmt::format("{:g}", p.fallback);
}

std::string read_text(const riffle_read& read) {
  static constexpr const char* where[] = {"", " of neighbours", " difference", " pair mean", ""};
  return std::string(read.field->name) + where[read.where] + ((read.flags & RIFFLE_OPTIONAL) != 0 ? " (optional)" : "");
}

void print_passes(const riffle_plugin& table) {
  for (auto p = table.passes; p != nullptr && *p != nullptr; ++p) {
    static constexpr const char* types[] = {"particle", "pair", "global"};
    std::cout << fmt::format("\npass {} ({}{})\n", (*p)->name, types[(*p)->type],
                             ((*p)->flags & RIFFLE_INITIAL) != 0 ? ", once at t = 0" : "");
    if ((*p)->when != nullptr) std::cout << "  when   " << (*p)->when << "\n";
    for (auto r = (*p)->reads; r != nullptr && *r != nullptr; ++r)
      std::cout << fmt::format("  reads  {} [{}]\n", read_text(**r), (*r)->field->unit);
    for (auto w = (*p)->writes; w != nullptr && *w != nullptr; ++w) {
      static constexpr const char* how[] = {"", ", summed", ", least", ", largest"};
      std::cout << fmt::format("  writes {} [{}]{}\n", (*w)->field->name, (*w)->field->unit, how[(*w)->how]);
    }
  }
}

}  // namespace

int describe_plugin(const Registry& registry, const std::string& wanted) {
  const auto slash = wanted.find('/');
  const std::string kind = slash == std::string::npos ? "" : wanted.substr(0, slash);
  const std::string id = slash == std::string::npos ? wanted : wanted.substr(slash + 1);
  std::vector<std::string> names;
  bool found = false;
  for (const auto* d : registry.all()) {
    names.push_back(d->id);
    if (d->id != id || (!kind.empty() && d->kind != kind)) continue;
    std::cout << fmt::format("{}{} {} {}: {}\n", found ? "\n" : "", d->kind, d->id, d->version, d->summary);
    found = true;
    if (!d->source.empty()) std::cout << "  source      " << d->source << "\n";
    if (!d->leaves_out.empty()) std::cout << "  leaves out  " << d->leaves_out << "\n";
    std::cout << fmt::format("  dimensions  {}\n  library     {}\n  build       {}\n", fmt::join(d->dimensions, ", "),
                             d->library_path, d->build);
    for (const auto& p : d->parameters) {
      std::cout << fmt::format("\nparameter {} [{}], default {}, {}\n  {}\n", p.name, p.unit, default_of(p),
                               range_of(p), p.doc);
    }
    for (const auto& f : d->initial)
      std::cout << fmt::format("\ninitial field {} [{}]\n  {}\n", f.name, f.unit, f.meaning);
    for (const auto& f : d->gives) std::cout << fmt::format("\ngives {} [{}]\n", f.name, f.unit);
    print_passes(*registry.plugin(d->kind, d->id)->table);
  }
  if (found) return exit_good;
  const std::string close = nearest(id, names);
  std::cerr << fmt::format("there is no plugin \"{}\"{}; \"riffle list\" shows all\n", wanted,
                           close.empty() ? "" : fmt::format(", did you mean \"{}\"?", close));
  return exit_bad_input;
}

}  // namespace riffle
