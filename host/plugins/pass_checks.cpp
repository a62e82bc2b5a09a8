#include <fmt/format.h>

#include <set>

#include "host/plugins/descriptor_checks.hpp"
#include "host/plugins/dictionary.hpp"

namespace riffle {
namespace {

bool per_pair(const riffle_field& field) {
  return (field.flags & RIFFLE_PER_PAIR) != 0;
}

// Why a pass of this type may not read the field that way; empty when it may.
std::string read_problem(const riffle_pass& pass, const riffle_read& read) {
  const bool of_pair = per_pair(*read.field);
  if ((read.flags & ~(RIFFLE_OPTIONAL | RIFFLE_PREVIOUS)) != 0) return fmt::format("unknown flags {:#x}", read.flags);
  // A kernel output with RIFFLE_PREVIOUS is that of the previous smoothing length.
  if ((read.flags & RIFFLE_PREVIOUS) != 0 && of_pair && !is_kernel_field(read.field->name)) {
    return "a value of a pair has no previous one";
  }
  if (pass.type == RIFFLE_PASS_PARTICLE) {
    return read.where == RIFFLE_AT_I && !of_pair ? "" : "a particle pass reads its own particle only (RIFFLE_AT_I)";
  }
  if (is_kernel_field(read.field->name)) {
    const bool at_length = read.where == RIFFLE_AT_I || read.where == RIFFLE_AT_J || read.where == RIFFLE_MEAN;
    return at_length ? "" : "the kernel is read with the smoothing length of i, of j, or their mean";
  }
  if (pass.type == RIFFLE_PASS_GLOBAL && read.where != RIFFLE_AT_I && read.where != RIFFLE_PAIR) {
    return "a global pass reads whole fields (RIFFLE_AT_I) or kept ones of pairs (RIFFLE_PAIR)";
  }
  if (of_pair != (read.where == RIFFLE_PAIR)) {
    return of_pair ? "a value of a pair is read as RIFFLE_PAIR" : "only a value of a pair is read as RIFFLE_PAIR";
  }
  return "";
}

// Why a pass of this type may not write the field that way; empty when it may.
std::string write_problem(const riffle_pass& pass, const riffle_write& write) {
  const bool of_pair = per_pair(*write.field);
  if ((write.flags & ~static_cast<std::uint32_t>(RIFFLE_KEEP)) != 0) {
    return fmt::format("unknown flags {:#x}", write.flags);
  }
  if ((write.flags & RIFFLE_KEEP) != 0 && !of_pair) return "only a value of a pair can be kept";
  if (is_geometry_field(write.field->name) || is_kernel_field(write.field->name)) {
    return "the host itself provides this field";
  }
  if (pass.type == RIFFLE_PASS_PAIR) {
    if (of_pair == (write.how == RIFFLE_SET)) return "";
    return of_pair ? "a value of a pair is written with RIFFLE_SET"
                   : "a pair pass gives a particle the sum, least or largest over its pairs";
  }
  if (of_pair) return "only a pair pass writes values of pairs";
  if (write.how == RIFFLE_SUM && (write.field->flags & RIFFLE_ACCUMULATES) == 0) {
    return "only a field with RIFFLE_ACCUMULATES can be added to by several passes";
  }
  return write.how == RIFFLE_SET || write.how == RIFFLE_SUM ? "" : "least and largest are formed over pairs only";
}

void check_reads_and_writes(const riffle_pass& pass, const std::string& subject, Problems& problems) {
  for (const riffle_read* read : Table(pass.reads)) {
    if (!check_field(read->field, subject + " reads", problems)) continue;
    const std::string what =
        read->where > RIFFLE_PAIR ? fmt::format("there is no way {} to read", read->where) : read_problem(pass, *read);
    if (!what.empty()) problems.add(fmt::format("{} reads \"{}\": {}", subject, read->field->name, what));
  }
  if (Table(pass.writes).size() == 0) problems.add(subject + ": writes nothing");
  for (const riffle_write* write : Table(pass.writes)) {
    if (!check_field(write->field, subject + " writes", problems)) continue;
    const std::string what =
        write->how > RIFFLE_MAX ? fmt::format("there is no way {} to write", write->how) : write_problem(pass, *write);
    if (!what.empty()) problems.add(fmt::format("{} writes \"{}\": {}", subject, write->field->name, what));
  }
}

// The parameter that a pass or iteration names for a number; nullptr names are allowed by the caller or not.
void check_number_parameter(const riffle_plugin& plugin, const char* name, std::uint32_t type,
                            const std::string& subject, Problems& problems) {
  const riffle_parameter* parameter = find_parameter(plugin, text_or_empty(name));
  if (parameter == nullptr || parameter->type != type) {
    problems.add(fmt::format("{}: \"{}\" is no {} parameter of the plugin", subject, text_or_empty(name),
                             type == RIFFLE_INTEGER ? "integer" : "real"));
  }
}

void check_flags(const riffle_plugin& plugin, const riffle_pass& pass, const std::string& subject, Problems& problems) {
  constexpr std::uint32_t known =
      RIFFLE_WITH_SELF | RIFFLE_INITIAL | RIFFLE_OCCASIONAL | RIFFLE_IF_PROVIDED | RIFFLE_STEADY;
  if ((pass.flags & ~known) != 0) problems.add(fmt::format("{}: unknown flags {:#x}", subject, pass.flags));
  if ((pass.flags & RIFFLE_WITH_SELF) != 0 && pass.type != RIFFLE_PASS_PAIR) {
    problems.add(subject + ": only a pair pass has a pair of a particle with itself");
  }
  const bool occasional = (pass.flags & RIFFLE_OCCASIONAL) != 0;
  if (occasional && (pass.flags & RIFFLE_INITIAL) != 0) {
    problems.add(subject + ": runs either at the start or from time to time");
  }
  if (occasional != (pass.every != nullptr || pass.interval != nullptr)) {
    problems.add(subject + (occasional ? ": does not say how often it runs"
                                       : ": says how often it runs, but is not "
                                         "RIFFLE_OCCASIONAL"));
  }
  if (pass.every != nullptr) check_number_parameter(plugin, pass.every, RIFFLE_INTEGER, subject, problems);
  if (pass.interval != nullptr) check_number_parameter(plugin, pass.interval, RIFFLE_REAL, subject, problems);
  if (((pass.targets | pass.sources) & ~static_cast<std::uint32_t>(RIFFLE_ALL_ROLES)) != 0) {
    problems.add(subject + ": unknown particle roles");
  }
  if (pass.neighbours > RIFFLE_EITHER) problems.add(subject + ": unknown rule for neighbours");
}

void check_pass(const riffle_plugin& plugin, const riffle_pass& pass, const std::string& subject, Problems& problems) {
  if (pass.type > RIFFLE_PASS_GLOBAL) {
    problems.add(fmt::format("{}: unknown type {}", subject, pass.type));
    return;
  }
  const bool global = pass.type == RIFFLE_PASS_GLOBAL;
  if (global ? pass.run_global == nullptr : pass.run == nullptr) problems.add(subject + ": has no run function");
  check_flags(plugin, pass, subject, problems);
  check_condition(plugin, pass.when, subject, problems);
  check_reads_and_writes(pass, subject, problems);
  if (pass.iteration == nullptr) return;
  for (const riffle_iteration* iteration : Table(plugin.iterations)) {
    if (text_or_empty(iteration->name) == pass.iteration) return;
  }
  problems.add(fmt::format("{}: belongs to iteration \"{}\", which does not exist", subject, pass.iteration));
}

void check_iteration(const riffle_plugin& plugin, const riffle_iteration& iteration, Problems& problems) {
  const std::string subject = fmt::format("iteration \"{}\"", text_or_empty(iteration.name));
  if (text_or_empty(iteration.name).empty()) problems.add(subject + ": has no name");
  check_number_parameter(plugin, iteration.tolerance, RIFFLE_REAL, subject, problems);
  check_number_parameter(plugin, iteration.maximum_iterations, RIFFLE_INTEGER, subject, problems);
  if (!check_field(iteration.residual, subject + " measures", problems)) return;
  for (const riffle_pass* pass : Table(plugin.passes)) {
    if (text_or_empty(pass->iteration) != text_or_empty(iteration.name)) continue;
    for (const riffle_write* write : Table(pass->writes)) {
      if (write->field != nullptr && text_or_empty(write->field->name) == iteration.residual->name) return;
    }
  }
  problems.add(fmt::format("{}: none of its passes writes its residual \"{}\"", subject, iteration.residual->name));
}

}  // namespace

void check_passes(const riffle_plugin& plugin, Problems& problems) {
  std::set<std::string> names;
  for (const riffle_pass* pass : Table(plugin.passes)) {
    const std::string subject = fmt::format("pass \"{}\"", text_or_empty(pass->name));
    if (text_or_empty(pass->name).empty()) problems.add(subject + ": has no name");
    // Two passes of one name are alternatives, of which a condition picks one.
    if (!names.insert(text_or_empty(pass->name)).second && pass->when == nullptr) {
      problems.add(subject + ": declared twice");
    }
    check_pass(plugin, *pass, subject, problems);
  }
  for (const riffle_iteration* iteration : Table(plugin.iterations)) check_iteration(plugin, *iteration, problems);
}

}  // namespace riffle
