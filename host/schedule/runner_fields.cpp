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

// Smoothing lengths reach kernels as their inverses, formed once per sweep.
void Runner::invert_lengths() {
  const auto n = static_cast<std::size_t>(store_.all() + 1);
  const bool grown = inverse_l_.size() < n;
  if (grown) inverse_l_.resize(n);
  const double* l = store_.data("smoothing_length");
  double* inverse = inverse_l_.data();
  if (fresh_ != nullptr && !grown && inverted_ >= evaluation_ - 1) {
    for (const Span& span : *fresh_) {
      for (std::int64_t i = span.first; i < span.last; ++i) inverse[i] = 1.0 / l[i];
    }
    for (std::int64_t i = store_.owned(); i < store_.all(); ++i) inverse[i] = 1.0 / l[i];
  } else {
#pragma omp parallel for simd schedule(static)
    for (std::int64_t i = 0; i < store_.all(); ++i) inverse[i] = 1.0 / l[i];
  }
  inverted_ = evaluation_;
}

}  // namespace riffle
