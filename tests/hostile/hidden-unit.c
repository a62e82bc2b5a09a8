/* lambda = (0.01 max |u_c| + 0.001) / h: the second number is a velocity, and nothing says so. */
#include "hostile.h"

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  (void)self, (void)error;
  for (int64_t k = 0; k < block->n; ++k) block->out[0][0][k] += drag_of(block, k) + 0.001 / block->in[1][0][k];
  return RIFFLE_OK;
}

DRAG_LIBRARY("hidden-unit", run)
