#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "host/study/advise/advice.hpp"
#include "host/study/pool.hpp"

namespace riffle {
namespace {

std::string percent(double share) {
  if (!std::isfinite(share)) return "?";
  return share != 0 && share < 1e-5 ? fmt::format("{:.1e} %", 100 * share) : fmt::format("{:.2g} %", 100 * share);
}

std::string verdict_of(const Term& term, double tolerance) {
  if (!std::isfinite(term.best())) return "not known";
  if (!term.matters(tolerance)) return term.kept ? "kept" : "left out";
  if (term.kept) return "needed";
  return term.obstacle.empty() ? "would be needed" : "would be needed: " + term.obstacle;
}

std::string seconds(double value) {
  return std::isfinite(value) ? fmt::format("{:.2g} s", value) : "?";
}

nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

}  // namespace

std::string advice_in_words(const Advice& advice, const std::string& manifest) {
  std::string text = fmt::format("{}: {}\n\nthe scene\n", advice.case_name, advice.title);
  for (const SceneFigure& figure : advice.figures) {
    text += fmt::format("  {:>10.3g} {:<4} {}\n", figure.value, figure.unit == "1" ? "" : figure.unit, figure.name);
  }
  text += fmt::format("\nwhat each term contributes (tolerance {})\n  {:<26}{:>10}{:>10}  \n",
                      percent(advice.tolerance), "", "estimate", "measured");
  for (const Term& term : advice.terms) {
    text += fmt::format("  {:<26}{:>10}{:>10}  {}\n", term.name, percent(term.contributes),
                        term.trial && term.trial->done ? percent(term.trial->difference) : "-",
                        verdict_of(term, advice.tolerance));
    text += fmt::format("  {:<26}  from {}", "", term.how);
    if (term.trial && term.trial->done)
      text += fmt::format("; CPU time {} without, {} with", seconds(term.trial->cpu_without),
                          seconds(term.trial->cpu_with));
    if (term.trial && !term.trial->problem.empty()) text += "; not measured: " + term.trial->problem;
    text += '\n';
  }
  text += fmt::format("\nthe least model\n  {}\n", advice.model);
  std::vector<std::string> command{"riffle", "run", advice.manifest.empty() ? manifest : "channel.toml"};
  for (const std::string& change : advice.proposal) {
    command.emplace_back("--set");
    command.push_back(change);
  }
  text += fmt::format("  {}\n", shell_words(command));
  text += fmt::format("  about {} of CPU time; the case as it is: about {}\n", seconds(advice.cpu_proposed),
                      seconds(advice.cpu_given));
  if (!advice.manifest.empty()) text += "\nchannel.toml\n\n" + advice.manifest;
  for (const std::string& note : advice.notes) text += fmt::format("\nnote: {}\n", note);
  return text;
}

std::string advice_in_json(const Advice& advice) {
  nlohmann::ordered_json json;
  json["case"] = advice.case_name;
  json["title"] = advice.title;
  json["tolerance"] = advice.tolerance;
  for (const SceneFigure& figure : advice.figures) json["figures"][figure.key] = number(figure.value);
  json["terms"] = nlohmann::json::array();
  for (const Term& term : advice.terms) {
    nlohmann::ordered_json one{{"name", term.name},
                               {"estimate", number(term.contributes)},
                               {"from", term.how},
                               {"matters", term.matters(advice.tolerance)},
                               {"kept", term.kept},
                               {"obstacle", term.obstacle},
                               {"measured", number(term.measured())}};
    if (term.trial) {
      one["without"] = term.trial->without;
      one["with"] = term.trial->with;
      if (term.trial->done) {
        one["cpu_seconds_without"] = term.trial->cpu_without;
        one["cpu_seconds_with"] = term.trial->cpu_with;
      }
      one["problem"] = term.trial->problem;
    }
    json["terms"].push_back(one);
  }
  json["model"] = advice.model;
  json["set"] = advice.proposal;
  json["manifest"] = advice.manifest;
  json["cpu_seconds_proposed"] = number(advice.cpu_proposed);
  json["cpu_seconds_given"] = number(advice.cpu_given);
  json["notes"] = advice.notes;
  return json.dump(2) + '\n';
}

}  // namespace riffle
