/* Does on loading what crtfastmath.o does, which GCC before 13 links into every library built with -ffast-math: flushes
 * subnormal numbers to zero, for the whole program. Written out, so that the test does not depend on the compiler. */
#include "hostile.h"

#if defined(__x86_64__)
#include <xmmintrin.h>
__attribute__((constructor)) static void flush_to_zero(void) {
  _mm_setcsr(_mm_getcsr() | 0x8040u);
}
#else
#include <fenv.h>
__attribute__((constructor)) static void round_down(void) {
  fesetround(FE_DOWNWARD);
}
#endif

DRAG_LIBRARY("fast-math", run_drag)
