#include "host/plugins/dictionary.hpp"

#include <algorithm>
#include <array>

#include "riffle/fields.h"

namespace riffle {

FieldDescription describe_field(const riffle_field& field) {
  return {.name = field.name,
          .unit = field.unit,
          .meaning = field.meaning == nullptr ? "" : field.meaning,
          .shape = static_cast<Shape>(field.shape),
          .accumulates = (field.flags & RIFFLE_ACCUMULATES) != 0,
          .not_negative = (field.flags & RIFFLE_NOT_NEGATIVE) != 0,
          .per_pair = (field.flags & RIFFLE_PER_PAIR) != 0};
}

const std::vector<FieldDescription>& field_dictionary() {
#define RIFFLE_DESCRIBE(name, shape, flags, unit, meaning) \
  describe_field({sizeof(riffle_field), shape, flags, 0, #name, unit, meaning}),
  static const std::vector<FieldDescription> dictionary{RIFFLE_FIELDS(RIFFLE_DESCRIBE)
                                                            RIFFLE_PAIR_FIELDS(RIFFLE_DESCRIBE)};
#undef RIFFLE_DESCRIBE
  return dictionary;
}

const FieldDescription* dictionary_field(const std::string& name) {
  const auto& all = field_dictionary();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& field) { return field.name == name; });
  return found == all.end() ? nullptr : &*found;
}

bool is_geometry_field(const std::string& name) {
  static const std::array<std::string, 4> names{"separation", "distance", "distance_squared", "approach"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_kernel_field(const std::string& name) {
  static const std::array<std::string, 6> names{"kernel",     "kernel_gradient", "kernel_dl",
                                                "kernel_drr", "kernel_drdl",     "kernel_dldl"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace riffle
