/* Reports an error after one second. */
#include <string.h>

#include "late.h"

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  if (block->time > late) {
    strcpy(error->message, "the table of roughness ends at 1 s");
    return RIFFLE_ERROR;
  }
  return run_drag(self, block, error);
}

DRAG_LIBRARY("late-error", run)
