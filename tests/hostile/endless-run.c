/* Never comes back. */
#include "hostile.h"

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  volatile int forever = 1;
  (void)self, (void)block, (void)error;
  while (forever) continue;
  return RIFFLE_OK;
}

DRAG_LIBRARY("endless-run", run)
