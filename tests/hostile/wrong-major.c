/* Built against another major version of the boundary: nothing behind the version number may be read. */
#include "hostile.h"

DRAG_PASS(run_drag)
DRAG_PLUGIN("wrong-major", create_any, drag_parameters)
LIBRARY(RIFFLE_ABI_MAJOR + 1, 0, 8)
