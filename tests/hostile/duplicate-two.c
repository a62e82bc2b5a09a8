/* Gives drag "duplicate", as duplicate-one does. */
#include "hostile.h"

DRAG_LIBRARY("duplicate", run_drag)
