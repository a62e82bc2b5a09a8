/* Casts const away and makes depths positive in place: right on its own, and a mystery to every pass after it. */
#include "hostile.h"

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  double* depth = (double*)block->in[1][0];
  (void)self, (void)error;
  for (int64_t k = 0; k < block->n; ++k) {
    depth[k] = depth[k] < 0 ? -depth[k] : depth[k];
    block->out[0][0][k] += drag_of(block, k);
  }
  return RIFFLE_OK;
}

DRAG_LIBRARY("writes-inputs", run)
