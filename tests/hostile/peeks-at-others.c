/* Smooths the depth with that of the next particle of the block, which is some particle or other. */
#include "hostile.h"

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  const double* depth = block->in[1][0];
  (void)self, (void)error;
  for (int64_t k = 0; k < block->n; ++k) {
    const double next = k + 1 < block->n ? depth[k + 1] : depth[k];
    block->out[0][0][k] += drag_of(block, k) * depth[k] / (0.5 * (depth[k] + next));
  }
  return RIFFLE_OK;
}

DRAG_LIBRARY("peeks-at-others", run)
