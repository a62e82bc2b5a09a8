/* A pass without a function. */
#include "hostile.h"

DRAG_LIBRARY("null-run", NULL)
