/* Gives drag "duplicate", as duplicate-two does. */
#include "hostile.h"

DRAG_LIBRARY("duplicate", run_drag)
