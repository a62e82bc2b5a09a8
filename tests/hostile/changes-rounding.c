/* Changes the rounding mode in create and leaves it so. */
#include <fenv.h>

#include "hostile.h"

static void* create(int32_t dim, const riffle_value* const* values, riffle_error* error) {
  fesetround(FE_UPWARD);
  return create_any(dim, values, error);
}

DRAG_PASS(run_drag)
DRAG_PLUGIN("changes-rounding", create, drag_parameters)
GOOD_LIBRARY
