/* Not hostile but old: built against an earlier minor version, in which a plugin ended before `kernel` and a pass before
 * `run_global`. It must load, with what it lacks taken as absent. */
#include "hostile.h"

static const riffle_pass drag_pass = {.size = offsetof(riffle_pass, run_global),
                                      .type = RIFFLE_PASS_PARTICLE,
                                      .name = "friction",
                                      .reads = drag_reads,
                                      .writes = drag_writes,
                                      .run = run_drag,
                                      .run_global = (riffle_global_fn)1}; /* behind the end: must not be believed */
static const riffle_pass* const drag_passes[] = {&drag_pass, NULL};
static const riffle_plugin drag_plugin = {.size = offsetof(riffle_plugin, kernel),
                                          .dims = 0xEu,
                                          .id = "older-minor",
                                          .kind = "drag",
                                          .version = "1.0.0",
                                          .summary = "a plugin of the tests",
                                          .source = "",
                                          .leaves_out = "",
                                          .parameters = drag_parameters,
                                          .passes = drag_passes,
                                          .create = create_any,
                                          .destroy = destroy_any,
                                          .state_size = -7};
static const riffle_plugin* const all_plugins[] = {&drag_plugin, NULL};
LIBRARY(RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR - 1, 8)
