/* Pushes slow water instead of holding it back. */
#include "hostile.h"

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  (void)self, (void)error;
  for (int64_t k = 0; k < block->n; ++k) block->out[0][0][k] += drag_of(block, k) - 0.25;
  return RIFFLE_OK;
}

DRAG_LIBRARY("negative-drag", run)
