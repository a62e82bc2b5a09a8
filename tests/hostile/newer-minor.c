/* Built against a boundary that this program does not know yet. */
#include "hostile.h"

DRAG_PASS(run_drag)
DRAG_PLUGIN("newer-minor", create_any, drag_parameters)
LIBRARY(RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR + 6, 8)
