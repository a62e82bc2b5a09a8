/* Ends the whole program when it does not like its parameters. */
#include <stdlib.h>

#include "hostile.h"

static void* create(int32_t dim, const riffle_value* const* values, riffle_error* error) {
  (void)dim, (void)values, (void)error;
  _Exit(0);
}

DRAG_PASS(run_drag)
DRAG_PLUGIN("exits-in-create", create, drag_parameters)
GOOD_LIBRARY
