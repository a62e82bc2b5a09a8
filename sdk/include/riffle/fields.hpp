// The dictionary of riffle/fields.h as C++ constants: riffle::fields::velocity, riffle::fields::kernel_gradient, ...
#pragma once

#include "riffle/fields.h"

namespace riffle::fields {

#define RIFFLE_DETAIL_FIELD(name, shape, flags, unit, meaning) \
  inline constexpr riffle_field name{sizeof(riffle_field), shape, flags, 0, #name, unit, meaning};
RIFFLE_FIELDS(RIFFLE_DETAIL_FIELD)
RIFFLE_PAIR_FIELDS(RIFFLE_DETAIL_FIELD)
#undef RIFFLE_DETAIL_FIELD

#define RIFFLE_DETAIL_FIELD(name, shape, flags, unit, meaning) &name,
// All of them, ended by a null pointer.
inline constexpr const riffle_field* dictionary[] = {RIFFLE_FIELDS(RIFFLE_DETAIL_FIELD)
                                                         RIFFLE_PAIR_FIELDS(RIFFLE_DETAIL_FIELD) nullptr};
#undef RIFFLE_DETAIL_FIELD

}  // namespace riffle::fields
