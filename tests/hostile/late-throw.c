/* Throws after one second, through a table written in C. */
#include "late.h"

extern int32_t throwing_run(const void* self, const riffle_block* block, riffle_error* error);

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  return block->time > late ? throwing_run(self, block, error) : run_drag(self, block, error);
}

DRAG_LIBRARY("late-throw", run)
