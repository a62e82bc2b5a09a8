/* Its run function is C++ and throws. */
#include "hostile.h"

extern int32_t throwing_run(const void* self, const riffle_block* block, riffle_error* error);

DRAG_LIBRARY("throws-in-run", throwing_run)
