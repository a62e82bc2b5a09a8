// What the host does not take on trust of a pass: fields that must never be negative.
#include <cmath>

#include "host/schedule/runner.hpp"

namespace riffle {

void Runner::check_signs(const PassNode& writer, std::int64_t first, std::int64_t last) {
  for (const auto& w : writer.writes) {
    const FieldDescription& field = graph_.fields()[static_cast<std::size_t>(w.field)].description;
    if (!field.not_negative || field_[static_cast<std::size_t>(w.field)] == nullptr) continue;
    const double* values = field_[static_cast<std::size_t>(w.field)]->component[0].data();
    for (std::int64_t i = first; i < last; ++i) {
      if (values[i] >= 0) continue;
      const std::string particle = " at particle " + std::to_string(store_.ids()[static_cast<std::size_t>(i)]);
      fail(writer, std::isnan(values[i])
                       ? field.name + " is no number" + particle
                       : field.name + " = " + std::to_string(values[i]) + particle + "; it must never be negative");
      return;
    }
  }
}

void Runner::check_signs_of_all(const PassNode& writer) {
  for (int role = 0; role < role_count; ++role) {
    if ((writer.targets & 1u << role) != 0) check_signs(writer, store_.role_begin(role), store_.role_begin(role + 1));
  }
}

}  // namespace riffle
