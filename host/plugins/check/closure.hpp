// Whatever a plugin computes, in the one shape that all checks use: a pass over made-up blocks. Kernels and references
// are dressed up as passes.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/plugins/instance.hpp"
#include "host/plugins/synthetic_block.hpp"

namespace riffle::check {

struct Closure {
  std::string name;    // in messages: pass "momentum", the kernel, the reference
  riffle_pass pass{};  // its reads, writes and run; run takes `self`
  const void* self = nullptr;
  std::shared_ptr<void> owner = {};  // of what a dressed-up pass needs

  [[nodiscard]] bool pairs() const { return pass.type == RIFFLE_PASS_PAIR; }
  [[nodiscard]] const riffle_field& output(int k) const { return *pass.writes[k]->field; }
};

// All that the instance computes with its parameters, global passes excepted. It must outlive them. `kernel_outputs`
// (RIFFLE_W | ...): of a kernel only these, as far as it provides them.
std::vector<Closure> closures_of(const PluginInstance& instance, std::uint32_t kernel_outputs = ~0U);

// A scene for this closure in these dimensions.
SyntheticScene scene_for(const Closure& closure, int dim);

// Runs it; throws PluginError when it reports an error.
void run(const Closure& closure, const SyntheticBlock& block);

// For each supported dimension an instance at its defaults, and of it each closure. False when there is none. Throws
// PluginError.
bool for_each_closure(const Plugin& plugin, const std::function<void(const PluginInstance&, const Closure&)>& work);

}  // namespace riffle::check
