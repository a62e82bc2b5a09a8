/* Crashes while it is loaded, before anything of it can be looked at. */
#include <signal.h>

#include "hostile.h"

__attribute__((constructor)) static void crash(void) {
  raise(SIGSEGV);
}

DRAG_LIBRARY("crashes-on-load", run_drag)
