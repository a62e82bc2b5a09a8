/* Divides zero by zero for the fourth particle after one second. */
#include "late.h"

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  (void)self, (void)error;
  for (int64_t k = 0; k < block->n; ++k) {
    const double nothing = block->time > late && block->first + k == 3 ? 0.0 : 1.0;
    block->out[0][0][k] += drag_of(block, k) * nothing / nothing;
  }
  return RIFFLE_OK;
}

DRAG_LIBRARY("late-nan", run)
