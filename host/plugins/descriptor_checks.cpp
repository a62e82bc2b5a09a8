#include "host/plugins/descriptor_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "host/plugins/dictionary.hpp"
#include "host/plugins/unit.hpp"

namespace riffle {
namespace {

bool lower_case(char c) {
  return c >= 'a' && c <= 'z';
}

bool agrees(const riffle_field& field, const FieldDescription& known) {
  return field.shape == static_cast<std::uint32_t>(known.shape) && parse_unit(field.unit) == parse_unit(known.unit) &&
         ((field.flags & RIFFLE_PER_PAIR) != 0) == known.per_pair;
}

std::string shape_text(Shape shape) {
  switch (shape) {
    case Shape::scalar: return "scalar";
    case Shape::vector: return "vector";
    case Shape::symmetric: return "symmetric tensor";
    case Shape::tensor: return "tensor";
  }
  return "";
}

void check_texts(const riffle_plugin& plugin, Problems& problems) {
  if (!is_name(plugin.id, '-')) problems.add(fmt::format("id \"{}\" is not [a-z][a-z0-9-]*", text_or_empty(plugin.id)));
  const auto& kinds = plugin_kinds();
  if (std::find(kinds.begin(), kinds.end(), text_or_empty(plugin.kind)) == kinds.end()) {
    problems.add(
        fmt::format("there is no kind \"{}\"; kinds are {}", text_or_empty(plugin.kind), fmt::join(kinds, ", ")));
  }
  if (text_or_empty(plugin.version).empty()) problems.add("has no version");
  if (text_or_empty(plugin.summary).empty()) problems.add("has no summary");
  if (plugin.source == nullptr) problems.add("has no source; an empty text is allowed");
  constexpr std::uint32_t possible = 0xE;
  if (plugin.dims == 0 || (plugin.dims & ~possible) != 0) {
    problems.add(fmt::format("supports dimensions {:#x}; bits 1, 2 and 3 are possible", plugin.dims));
  }
}

void check_functions(const riffle_plugin& plugin, Problems& problems) {
  const std::string kind = text_or_empty(plugin.kind);
  if (plugin.create == nullptr) problems.add("has no create function");
  if (plugin.destroy == nullptr) problems.add("has no destroy function");
  const bool has_passes = Table(plugin.passes).size() > 0;
  if (kind == "kernel" && (plugin.kernel == nullptr || plugin.evaluate_kernel == nullptr)) {
    problems.add("a kernel needs the functions kernel and evaluate_kernel");
  }
  if (kind == "reference" && (plugin.evaluate_reference == nullptr || Table(plugin.gives).size() == 0)) {
    problems.add("a reference needs the function evaluate_reference and fields that it gives");
  }
  if (kind == "boundary" && plugin.begin == nullptr && plugin.edit == nullptr && plugin.images == nullptr &&
      !has_passes) {
    problems.add("a boundary needs one of the functions begin, edit, images, or a pass");
  }
  if ((kind == "bed" || kind == "width") && plugin.evaluate_profile == nullptr) {
    problems.add(fmt::format("a {} needs the function evaluate_profile", kind));
  }
  for (const riffle_refusal* refusal : Table(plugin.refuses)) {
    const auto& kinds = plugin_kinds();
    if (std::find(kinds.begin(), kinds.end(), text_or_empty(refusal->kind)) == kinds.end()) {
      problems.add(fmt::format("refuses the kind \"{}\", which does not exist", text_or_empty(refusal->kind)));
    }
    if (text_or_empty(refusal->reason).empty()) problems.add("refuses a plugin without a reason");
  }
  if (kind == "equations" && Table(plugin.evolved).size() == 0) problems.add("equations need an evolved field");
  if (plugin.state_size < 0) problems.add(fmt::format("asks for {} numbers of state", plugin.state_size));
}

void check_evolved(const riffle_plugin& plugin, Problems& problems) {
  for (const riffle_evolved* evolved : Table(plugin.evolved)) {
    const bool usable =
        check_field(evolved->field, "evolved", problems) && check_field(evolved->rate, "evolved", problems);
    if (!usable) continue;
    check_condition(plugin, evolved->when, fmt::format("evolved field \"{}\"", evolved->field->name), problems);
    const auto unit = parse_unit(evolved->field->unit), rate = parse_unit(evolved->rate->unit);
    const Unit per_second = parse_unit("s-1").value();
    if (evolved->field->shape != evolved->rate->shape || (unit && rate && *unit * per_second != *rate)) {
      problems.add(fmt::format("evolved field \"{}\" [{}]: \"{}\" [{}] cannot be its rate", evolved->field->name,
                               evolved->field->unit, evolved->rate->name, evolved->rate->unit));
    }
    if (evolved->damping != nullptr && check_field(evolved->damping, "evolved", problems) &&
        (evolved->damping->shape != RIFFLE_SCALAR || parse_unit(evolved->damping->unit) != per_second)) {
      problems.add(fmt::format("evolved field \"{}\": its damping \"{}\" is no scalar in s-1", evolved->field->name,
                               evolved->damping->name));
    }
  }
}

void check_votes(const riffle_plugin& plugin, Problems& problems) {
  for (const riffle_vote* vote : Table(plugin.votes)) {
    const std::string subject = fmt::format("vote \"{}\"", text_or_empty(vote->name));
    if (text_or_empty(vote->name).empty()) problems.add(subject + ": has no name");
    if (vote->limit == nullptr) problems.add(subject + ": has no function");
    if ((vote->targets & ~static_cast<std::uint32_t>(RIFFLE_ALL_ROLES)) != 0) {
      problems.add(subject + ": unknown particle roles");
    }
    check_condition(plugin, vote->when, subject, problems);
    for (const riffle_read* read : Table(vote->reads)) {
      if (!check_field(read->field, subject + " reads", problems)) continue;
      if (read->where != RIFFLE_AT_I || (read->field->flags & RIFFLE_PER_PAIR) != 0) {
        problems.add(fmt::format("{} reads \"{}\": a vote reads the particle itself only (RIFFLE_AT_I)", subject,
                                 read->field->name));
      }
    }
  }
}

// Every field of the plugin once more, by name: it must mean the same in each place.
void check_agreement(const riffle_plugin& plugin, Problems& problems) {
  std::map<std::string, const riffle_field*> seen;
  const auto look = [&](const riffle_field* field) {
    if (field == nullptr || field->name == nullptr || field->unit == nullptr) return;
    const riffle_field* first = seen.try_emplace(field->name, field).first->second;
    if (first->shape != field->shape || std::string_view(first->unit) != field->unit) {
      problems.add(fmt::format("field \"{}\" has two meanings: [{}] and [{}]", field->name, first->unit, field->unit));
    }
  };
  for (const riffle_pass* pass : Table(plugin.passes)) {
    for (const riffle_read* read : Table(pass->reads)) look(read->field);
    for (const riffle_write* write : Table(pass->writes)) look(write->field);
  }
  for (const riffle_evolved* evolved : Table(plugin.evolved)) {
    for (const riffle_field* field : {evolved->field, evolved->rate, evolved->damping}) look(field);
  }
}

}  // namespace

bool is_name(const char* text, char also) {
  if (text == nullptr || !lower_case(*text)) return false;
  const std::string_view rest = text + 1;
  return std::all_of(rest.begin(), rest.end(),
                     [&](char c) { return lower_case(c) || (c >= '0' && c <= '9') || c == also; });
}

std::vector<std::string> split_words(std::string_view text) {
  std::vector<std::string> words;
  while (true) {
    const std::size_t bar = text.find('|');
    words.emplace_back(text.substr(0, bar));
    if (bar == std::string_view::npos) return words;
    text.remove_prefix(bar + 1);
  }
}

bool check_field(const riffle_field* field, const std::string& subject, Problems& problems) {
  if (field == nullptr) {
    problems.add(subject + " a field that is missing");
    return false;
  }
  const std::string name = fmt::format("{} \"{}\"", subject, text_or_empty(field->name));
  if (!is_name(field->name, '_')) {
    problems.add(name + ": the name is not [a-z][a-z0-9_]*");
    return false;
  }
  if (field->unit == nullptr || !parse_unit(field->unit)) {
    problems.add(
        fmt::format("{}: unit \"{}\" is no product of powers such as kg.m-3", name, text_or_empty(field->unit)));
    return false;
  }
  if (field->shape > RIFFLE_TENSOR) {
    problems.add(fmt::format("{}: unknown shape {}", name, field->shape));
    return false;
  }
  constexpr std::uint32_t known_flags = RIFFLE_ACCUMULATES | RIFFLE_NOT_NEGATIVE | RIFFLE_PER_PAIR;
  if ((field->flags & ~known_flags) != 0) problems.add(fmt::format("{}: unknown flags {:#x}", name, field->flags));
  const FieldDescription* known = dictionary_field(field->name);
  if (known != nullptr && !agrees(*field, *known)) {
    problems.add(fmt::format("{}: is a {} in {} here, but the dictionary has a {}{} in {}", name,
                             shape_text(static_cast<Shape>(field->shape)), field->unit, shape_text(known->shape),
                             known->per_pair ? " of pairs" : "", known->unit));
  }
  return true;
}

void check_descriptor(const riffle_plugin& plugin, const std::string& library, Problems& problems) {
  problems.set_where(
      fmt::format("{}: {} \"{}\"", library, plugin.kind == nullptr ? "plugin" : plugin.kind, text_or_empty(plugin.id)));
  check_texts(plugin, problems);
  check_functions(plugin, problems);
  check_parameters(plugin, problems);
  check_passes(plugin, problems);
  check_votes(plugin, problems);
  check_evolved(plugin, problems);
  for (const riffle_field* field : Table(plugin.initial)) check_field(field, "initial", problems);
  for (const riffle_field* field : Table(plugin.gives)) check_field(field, "gives", problems);
  if (plugin.conserved != nullptr) check_field(plugin.conserved, "conserves", problems);
  check_agreement(plugin, problems);
}

}  // namespace riffle
