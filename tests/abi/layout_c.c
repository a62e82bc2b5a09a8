/* The memory layout of the boundary as a C compiler sees it; layout_cpp.cpp is its twin. */
#include <assert.h>
#include <stddef.h>

#include "riffle/abi.h"

#define SIZE(structure, bytes) static_assert(sizeof(structure) == (bytes), "size of " #structure);
#define OFFSET(structure, member, bytes) \
  static_assert(offsetof(structure, member) == (bytes), "offset of " #structure "." #member);
#define VALUE(enumerator, value) static_assert((enumerator) == (value), "value of " #enumerator);
#include "layout.inc"
