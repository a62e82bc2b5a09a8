/* Uses a name of the dictionary for something else. */
#include "hostile.h"

static const riffle_field rate_in_minutes = {
    sizeof(riffle_field), RIFFLE_SCALAR, RIFFLE_ACCUMULATES, 0, "drag_rate", "s", "a time"};
static const riffle_write write_it = {sizeof(riffle_write), RIFFLE_SUM, 0, 0, &rate_in_minutes};
static const riffle_write* const writes[] = {&write_it, NULL};
static const riffle_pass drag_pass = {.size = sizeof(riffle_pass),
                                      .type = RIFFLE_PASS_PARTICLE,
                                      .name = "friction",
                                      .reads = drag_reads,
                                      .writes = writes,
                                      .run = run_drag};
static const riffle_pass* const drag_passes[] = {&drag_pass, NULL};
DRAG_PLUGIN("wrong-unit", create_any, drag_parameters)
GOOD_LIBRARY
