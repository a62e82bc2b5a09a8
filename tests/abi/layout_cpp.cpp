// The memory layout of the boundary as a C++ compiler sees it; layout_c.c is its twin.
#include <cstddef>
#include <type_traits>

#include "riffle/abi.h"

#define SIZE(structure, bytes)                                        \
  static_assert(sizeof(structure) == (bytes), "size of " #structure); \
  static_assert(std::is_standard_layout_v<structure>, "" #structure); \
  static_assert(std::is_trivially_copyable_v<structure>, "" #structure);
#define OFFSET(structure, member, bytes) \
  static_assert(offsetof(structure, member) == (bytes), "offset of " #structure "." #member);
#define VALUE(enumerator, value) static_assert((enumerator) == (value), "value of " #enumerator);
#include "layout.inc"

// A plugin function that may throw does not fit into the table: noexcept is part of the pointer's type.
static_assert(!std::is_assignable_v<riffle_run_fn&, int32_t (*)(const void*, const riffle_block*, riffle_error*)>);
