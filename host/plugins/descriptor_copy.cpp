#include "host/plugins/descriptor_copy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory_resource>

namespace riffle {
namespace {

constexpr std::size_t longest_table = 4096;  // entries; a longer one has lost its null pointer

class Copier {
 public:
  Copier(std::uint32_t abi_minor, Problems& problems)
      : same_version_(abi_minor == RIFFLE_ABI_MINOR),
        problems_(problems),
        memory_(std::make_shared<std::pmr::monotonic_buffer_resource>()) {}

  std::shared_ptr<const void> owner() const { return memory_; }

  const riffle_plugin* plugin(const riffle_plugin& from) {
    riffle_plugin* to = copy(&from, "riffle_plugin");
    if (to == nullptr) return nullptr;
    to->parameters = table(to->parameters, "riffle_parameter", [](auto*) {});
    to->passes = table(to->passes, "riffle_pass", [&](riffle_pass* pass) {
      pass->reads = reads(pass->reads);
      pass->writes =
          table(pass->writes, "riffle_write", [&](riffle_write* write) { write->field = field(write->field); });
    });
    to->iterations = table(to->iterations, "riffle_iteration",
                           [&](riffle_iteration* iteration) { iteration->residual = field(iteration->residual); });
    to->votes = table(to->votes, "riffle_vote", [&](riffle_vote* vote) { vote->reads = reads(vote->reads); });
    to->evolved = table(to->evolved, "riffle_evolved", [&](riffle_evolved* evolved) {
      evolved->field = field(evolved->field);
      evolved->rate = field(evolved->rate);
      evolved->damping = field(evolved->damping);
    });
    to->initial = table(to->initial, "riffle_field", [](auto*) {});
    to->conserved = field(to->conserved);
    to->gives = table(to->gives, "riffle_field", [](auto*) {});
    to->refuses = table(to->refuses, "riffle_refusal", [](auto*) {});
    return to;
  }

 private:
  // The struct on a zeroed one of our version; nullptr when absent or of impossible size.
  template <class T>
  T* copy(const T* from, const char* type) {
    if (from == nullptr) return nullptr;
    const std::uint32_t size = from->size;
    if (size < sizeof(std::uint32_t) || size > sizeof(T) || (same_version_ && size != sizeof(T))) {
      problems_.add(fmt::format("a {} has size {}, but it has {} in version {}.{} of the boundary", type, size,
                                sizeof(T), RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR));
      return nullptr;
    }
    auto* to = static_cast<T*>(memory_->allocate(sizeof(T), alignof(T)));
    std::memset(static_cast<void*>(to), 0, sizeof(T));
    std::memcpy(static_cast<void*>(to), from, size);
    to->size = sizeof(T);
    return to;
  }

  // The null-terminated table with its elements copied and then completed by `finish`; never nullptr.
  template <class T, class Finish>
  const T* const* table(const T* const* from, const char* type, Finish finish) {
    std::size_t count = 0;
    while (from != nullptr && from[count] != nullptr && count < longest_table) ++count;
    if (count == longest_table) {
      problems_.add(fmt::format("a table of {} does not end with a null pointer", type));
      count = 0;
    }
    auto** to = static_cast<const T**>(memory_->allocate((count + 1) * sizeof(const T*), alignof(const T*)));
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (T* item = copy(from[k], type)) {
        finish(item);
        to[kept++] = item;
      }
    }
    to[kept] = nullptr;
    return to;
  }

  const riffle_field* field(const riffle_field* from) { return copy(from, "riffle_field"); }

  const riffle_read* const* reads(const riffle_read* const* from) {
    return table(from, "riffle_read", [&](riffle_read* read) { read->field = field(read->field); });
  }

  bool same_version_;
  Problems& problems_;
  std::shared_ptr<std::pmr::monotonic_buffer_resource> memory_;
};

}  // namespace

CopiedPlugin copy_descriptor(const riffle_plugin& plugin, std::uint32_t abi_minor, Problems& problems) {
  Copier copier(abi_minor, problems);
  const riffle_plugin* table = copier.plugin(plugin);
  return {table, copier.owner()};
}

}  // namespace riffle
