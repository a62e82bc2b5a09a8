/* Crashes when it is created. */
#include <signal.h>

#include "hostile.h"

static void* create(int32_t dim, const riffle_value* const* values, riffle_error* error) {
  raise(SIGSEGV);
  return create_any(dim, values, error);
}

DRAG_PASS(run_drag)
DRAG_PLUGIN("crashes-in-create", create, drag_parameters)
GOOD_LIBRARY
