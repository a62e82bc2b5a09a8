/* Says that it speaks this version, but its structs have another size: a header that was tampered with. */
#include "hostile.h"

static const riffle_pass drag_pass = {.size = sizeof(riffle_pass) - 8,
                                      .type = RIFFLE_PASS_PARTICLE,
                                      .name = "friction",
                                      .reads = drag_reads,
                                      .writes = drag_writes,
                                      .run = run_drag};
static const riffle_pass* const drag_passes[] = {&drag_pass, NULL};
DRAG_PLUGIN("wrong-size", create_any, drag_parameters)
GOOD_LIBRARY
