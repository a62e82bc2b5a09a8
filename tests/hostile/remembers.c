/* Keeps state between calls, so that results depend on who was called before. */
#include "hostile.h"

static double calls;

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  (void)self, (void)error;
  calls += 1;
  for (int64_t k = 0; k < block->n; ++k) block->out[0][0][k] += drag_of(block, k) * calls;
  return RIFFLE_OK;
}

DRAG_LIBRARY("remembers", run)
