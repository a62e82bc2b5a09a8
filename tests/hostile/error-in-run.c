/* Reports an error when it runs. */
#include <string.h>

#include "hostile.h"

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  (void)self, (void)block;
  strcpy(error->message, "the bed has no grain size here");
  return RIFFLE_ERROR;
}

DRAG_LIBRARY("error-in-run", run)
