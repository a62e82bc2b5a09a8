/* Its create function is C++ and throws. */
#include "hostile.h"

extern void* throwing_create(int32_t dim, const riffle_value* const* values, riffle_error* error);

DRAG_PASS(run_drag)
DRAG_PLUGIN("throws-in-create", throwing_create, drag_parameters)
GOOD_LIBRARY
