#include <fmt/format.h>

#include <cmath>

#include "host/plugins/check/checks.hpp"
#include "host/plugins/check/closure.hpp"

namespace riffle::check {
namespace {

// Numbers of pairs and particles that a block may have.
std::vector<std::int64_t> sizes(const Closure& closure) {
  if (closure.pairs()) return {4, 8, 12, 60, 64, 68};
  return {1, 2, 3, 7, 8, 64, 65};
}

std::string write_problem(const Closure& closure, const SyntheticBlock& block) {
  if (const int k = block.overrun_output(); k >= 0) {
    return fmt::format("writes past the end of \"{}\"", closure.output(k).name);
  }
  for (int k = 0; k < block.outputs(); ++k) {
    for (int c = 0; c < block.components(k); ++c) {
      for (std::int64_t p = 0; p < block.size(); ++p) {
        if (!std::isnan(block.out(k, c)[p])) continue;
        return fmt::format("leaves \"{}\" unwritten at place {}, or makes it no number,", closure.output(k).name, p);
      }
    }
  }
  return "";
}

}  // namespace

Findings check_writes(const Plugin& plugin) {
  Findings findings;
  const bool any = for_each_closure(plugin, [&](const PluginInstance& instance, const Closure& closure) {
    if (!findings.failures.empty()) return;
    for (const std::int64_t n : sizes(closure)) {
      for (const bool optional : {true, false}) {
        SyntheticScene scene = scene_for(closure, instance.dim());
        scene.optional = optional;
        const SyntheticBlock block(scene, closure.pass, first_items(n));
        run(closure, block);
        const std::string problem = write_problem(closure, block);
        if (problem.empty()) continue;
        findings.fail(fmt::format("{} {} in a block of {}{}", closure.name, problem, n,
                                  optional ? "" : " without its optional fields"));
        return;
      }
    }
  });
  findings.summary = any ? "every output written, nothing beside them, in blocks of many sizes" : nothing;
  return findings;
}

Findings check_inputs(const Plugin& plugin) {
  Findings findings;
  const bool any = for_each_closure(plugin, [](const PluginInstance& instance, const Closure& closure) {
    SyntheticBlock block(scene_for(closure, instance.dim()), closure.pass, first_items(64));
    block.protect_inputs();
    run(closure, block);
  });
  findings.summary = any ? "runs with inputs that cannot be written" : nothing;
  return findings;
}

}  // namespace riffle::check
