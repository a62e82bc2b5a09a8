/* Calls a function that nobody has. */
#include "hostile.h"

extern double nobody_has_this(double);

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  (void)self, (void)error;
  for (int64_t k = 0; k < block->n; ++k) block->out[0][0][k] += nobody_has_this(1);
  return RIFFLE_OK;
}

DRAG_LIBRARY("undefined-symbol", run)
