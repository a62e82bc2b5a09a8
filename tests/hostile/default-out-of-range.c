/* The default of its parameter is not in the parameter's own range. */
#include "hostile.h"

static const riffle_parameter coefficient = {.size = sizeof(riffle_parameter),
                                             .type = RIFFLE_REAL,
                                             .name = "coefficient",
                                             .unit = "1",
                                             .doc = "friction coefficient",
                                             .fallback = 3,
                                             .min = 0,
                                             .max = 1};
static const riffle_parameter* const parameters[] = {&coefficient, NULL};

DRAG_PASS(run_drag)
DRAG_PLUGIN("default-out-of-range", create_any, parameters)
GOOD_LIBRARY
