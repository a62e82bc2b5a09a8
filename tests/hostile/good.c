/* Nothing wrong: what the others would be without their fault. */
#include "hostile.h"

DRAG_LIBRARY("good", run_drag)
