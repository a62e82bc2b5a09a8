#include "host/plugins/check/closure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <deque>

#include "host/plugins/call.hpp"
#include "host/plugins/contracts.hpp"
#include "host/plugins/descriptor_checks.hpp"
#include "riffle/fields.hpp"

namespace riffle::check {
namespace {

constexpr riffle_read read_as(std::uint32_t where, const riffle_field& field) {
  return {sizeof(riffle_read), where, 0, 0, &field};
}
constexpr riffle_write set_to(const riffle_field& field) {
  return {sizeof(riffle_write), RIFFLE_SET, 0, 0, &field};
}

// ---- kernel: distance and inverse smoothing length in, all outputs that it provides out ----

constexpr riffle_field inverse_length{sizeof(riffle_field), RIFFLE_SCALAR, 0, 0, "inverse_smoothing_length", "m-1", ""};
constexpr riffle_read kernel_reads[] = {read_as(RIFFLE_PAIR, fields::distance), read_as(RIFFLE_MEAN, inverse_length)};
constexpr const riffle_read* kernel_read_table[] = {&kernel_reads[0], &kernel_reads[1], nullptr};
constexpr riffle_write kernel_writes[] = {set_to(fields::kernel),      set_to(fields::kernel_gradient),
                                          set_to(fields::kernel_dl),   set_to(fields::kernel_drr),
                                          set_to(fields::kernel_drdl), set_to(fields::kernel_dldl)};

struct KernelAsPass {
  const PluginInstance* instance;
  std::uint32_t provides = 0;
  std::vector<const riffle_write*> writes;

  static std::int32_t run(const void* self, const riffle_block* block, riffle_error*) noexcept {
    const auto& kernel = *static_cast<const KernelAsPass*>(self);
    double* out[RIFFLE_KERNEL_OUTPUTS] = {};
    std::size_t next = 0;
    for (unsigned b = 0; b < RIFFLE_KERNEL_OUTPUTS; ++b) {
      if ((kernel.provides >> b & 1U) != 0) out[b] = block->out[next++][0];
    }
    return kernel.instance->table().evaluate_kernel(kernel.instance->self(), block->n, block->in[0][0], block->in[1][0],
                                                    kernel.provides, out);
  }
};

Closure kernel_closure(const PluginInstance& instance, std::uint32_t outputs) {
  riffle_kernel description{};
  description.size = sizeof description;
  instance.table().kernel(instance.self(), &description);
  const std::uint32_t provides = description.provides & outputs;
  auto kernel = std::make_shared<KernelAsPass>(KernelAsPass{&instance, provides, {}});
  for (unsigned b = 0; b < RIFFLE_KERNEL_OUTPUTS; ++b) {
    if ((provides >> b & 1U) != 0) kernel->writes.push_back(&kernel_writes[b]);
  }
  kernel->writes.push_back(nullptr);
  Closure closure{.name = "evaluate", .self = kernel.get(), .owner = kernel};
  closure.pass.size = sizeof(riffle_pass);
  closure.pass.type = RIFFLE_PASS_PAIR;
  closure.pass.flags = RIFFLE_WITH_SELF;
  closure.pass.name = "evaluate";
  closure.pass.reads = kernel_read_table;
  closure.pass.writes = kernel->writes.data();
  closure.pass.run = &KernelAsPass::run;
  return closure;
}

// ---- reference: position in; values, their scales and whether they are defined out ----

constexpr riffle_field defined_field{sizeof(riffle_field), RIFFLE_SCALAR, 0, 0, "defined", "1", ""};
constexpr riffle_read reference_reads[] = {read_as(RIFFLE_AT_I, fields::position)};
constexpr const riffle_read* reference_read_table[] = {&reference_reads[0], nullptr};

struct ReferenceAsPass {
  const PluginInstance* instance;
  std::deque<riffle_write> writes;
  std::vector<const riffle_write*> table;

  static std::int32_t run(const void* self, const riffle_block* block, riffle_error* error) noexcept {
    const auto& reference = *static_cast<const ReferenceAsPass*>(self);
    riffle_points points{sizeof(riffle_points), block->dim, block->n, {}, block->time};
    for (int c = 0; c < block->dim; ++c) points.x[c] = block->in[0][c];
    std::vector<double*> values, scales;
    const std::size_t gives = Table(reference.instance->table().gives).size();
    for (std::size_t f = 0; f < gives; ++f) {
      const Shape shape = static_cast<Shape>(reference.instance->table().gives[f]->shape);
      for (int c = 0; c < components(shape, block->dim); ++c) {
        values.push_back(block->out[2 * f][c]);
        scales.push_back(block->out[2 * f + 1][c]);
      }
    }
    std::vector<std::uint8_t> defined(static_cast<std::size_t>(block->n), 0);
    const std::int32_t status = reference.instance->table().evaluate_reference(
        reference.instance->self(), &points, values.data(), scales.data(), defined.data(), error);
    for (std::int64_t k = 0; k < block->n; ++k) {
      const bool is_defined = defined[static_cast<std::size_t>(k)] != 0;
      block->out[2 * gives][0][k] = is_defined ? 1 : 0;
      if (is_defined) continue;
      for (double* column : values) column[k] = 0;  // whatever it left there means nothing
      for (double* column : scales) column[k] = 0;
    }
    return status;
  }
};

Closure reference_closure(const PluginInstance& instance) {
  auto reference = std::make_shared<ReferenceAsPass>(ReferenceAsPass{&instance, {}, {}});
  for (const riffle_field* field : Table(instance.table().gives)) {
    reference->writes.push_back(set_to(*field));
    reference->writes.push_back(set_to(*field));
  }
  reference->writes.push_back(set_to(defined_field));
  for (const riffle_write& write : reference->writes) reference->table.push_back(&write);
  reference->table.push_back(nullptr);
  Closure closure{.name = "evaluate", .self = reference.get(), .owner = reference};
  closure.pass.size = sizeof(riffle_pass);
  closure.pass.type = RIFFLE_PASS_PARTICLE;
  closure.pass.name = "evaluate";
  closure.pass.reads = reference_read_table;
  closure.pass.writes = reference->table.data();
  closure.pass.run = &ReferenceAsPass::run;
  return closure;
}

}  // namespace

std::vector<Closure> closures_of(const PluginInstance& instance, std::uint32_t kernel_outputs) {
  std::vector<Closure> closures;
  if (instance.kind() == "kernel") closures.push_back(kernel_closure(instance, kernel_outputs));
  if (instance.kind() == "reference") closures.push_back(reference_closure(instance));
  for (const riffle_pass* pass : Table(instance.table().passes)) {
    if (pass->type == RIFFLE_PASS_GLOBAL || !is_active(instance, pass->when)) continue;
    closures.push_back({.name = fmt::format("pass \"{}\"", pass->name), .pass = *pass, .self = instance.self()});
  }
  return closures;
}

SyntheticScene scene_for(const Closure& closure, int dim) {
  SyntheticScene scene;
  scene.dim = dim;
  scene.with_self = (closure.pass.flags & RIFFLE_WITH_SELF) != 0;
  return scene;
}

void run(const Closure& closure, const SyntheticBlock& block) {
  riffle_error error = no_error();
  if (run_pass(closure.pass, closure.self, block.block(), error) == RIFFLE_OK) return;
  throw PluginError(fmt::format("{} fails on made-up numbers: {}", closure.name, message_of(error)));
}

bool for_each_closure(const Plugin& plugin, const std::function<void(const PluginInstance&, const Closure&)>& work) {
  bool any = false;
  for (const int dim : plugin.description.dimensions) {
    const PluginInstance instance(plugin, dim, default_values(plugin.description));
    for (const Closure& closure : closures_of(instance)) {
      any = true;
      work(instance, closure);
    }
  }
  return any;
}

}  // namespace riffle::check
