/* Cannot be created, and says why. */
#include <string.h>

#include "hostile.h"

static void* create(int32_t dim, const riffle_value* const* values, riffle_error* error) {
  (void)dim, (void)values;
  strcpy(error->message, "coefficient = 0.01 does not suit this bed");
  return NULL;
}

DRAG_PASS(run_drag)
DRAG_PLUGIN("refuses-create", create, drag_parameters)
GOOD_LIBRARY
