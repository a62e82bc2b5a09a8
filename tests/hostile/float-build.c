/* A build with numbers of 4 bytes. */
#include "hostile.h"

DRAG_PASS(run_drag)
DRAG_PLUGIN("float-build", create_any, drag_parameters)
LIBRARY(RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR, 4)
