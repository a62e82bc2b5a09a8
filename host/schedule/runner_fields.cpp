// The arrays that a sweep works on, and the first failure in it.
#include <algorithm>

#include "host/schedule/runner.hpp"

namespace riffle {

double* Runner::component(int field, int component) const {
  return field_[static_cast<std::size_t>(field)]->component[static_cast<std::size_t>(component)].data();
}

const double* Runner::source(const Source& s) const {
  return s.inverse_length ? inverse_l_.data() : component(s.field, s.component);
}

void Runner::clear(int field, std::uint32_t roles) {
  for (auto& array : field_[static_cast<std::size_t>(field)]->component) {
    for (int role = 0; role < role_count; ++role) {
      if ((roles & 1u << role) != 0)
        std::fill(array.data() + store_.role_begin(role), array.data() + store_.role_begin(role + 1), 0.0);
    }
  }
}

void Runner::fail(const PassNode& failed, const std::string& message) {
#pragma omp critical(riffle_runner_failure)
  {
    const auto& plugin = graph_.plugins()[static_cast<std::size_t>(failed.plugin)];
    std::string line = plugin.kind + " " + failed.label + ": " + message;
    if (failure_.empty() || line < failure_) failure_ = std::move(line);
  }
}

}  // namespace riffle
