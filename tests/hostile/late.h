/* Parts of plugins that are good until the water has run for a while, which no check before a run can foresee: in the
 * tests' scenes a run lasts longer than `late`, made-up blocks are earlier. */
#ifndef RIFFLE_TESTS_LATE_H
#define RIFFLE_TESTS_LATE_H

#include "hostile.h"

static const double late = 1.0; /* s */

#endif
