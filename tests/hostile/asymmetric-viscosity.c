/* Divides by the depth of i instead of the mean: the pair (j, i) gets another value, so momentum is lost. */
#include "hostile.h"

static const riffle_field approach = {
    sizeof(riffle_field), RIFFLE_SCALAR, RIFFLE_PER_PAIR, 0, "approach", "m2.s-1", "(u_i - u_j) . (x_i - x_j)"};
static const riffle_field viscous_pressure = {sizeof(riffle_field),
                                              RIFFLE_SCALAR,
                                              RIFFLE_PER_PAIR,
                                              0,
                                              "viscous_pressure",
                                              "m2.s-2",
                                              "Pi_ij times the mean density or depth"};
static const riffle_read read_approach = {sizeof(riffle_read), RIFFLE_PAIR, 0, 0, &approach};
static const riffle_read* const reads[] = {&read_approach, &read_depth, NULL};
static const riffle_write write_it = {sizeof(riffle_write), RIFFLE_SET, 0, 0, &viscous_pressure};
static const riffle_write* const writes[] = {&write_it, NULL};

static int32_t run(const void* self, const riffle_block* block, riffle_error* error) {
  (void)self, (void)error;
  for (int64_t k = 0; k < block->n; ++k) {
    const double closing = block->in[0][0][k] < 0 ? block->in[0][0][k] : 0;
    block->out[0][0][k] = closing * closing / (block->in[1][0][k] * block->in[1][0][k]);
  }
  return RIFFLE_OK;
}

static const riffle_pass pass = {.size = sizeof(riffle_pass),
                                 .type = RIFFLE_PASS_PAIR,
                                 .name = "viscosity",
                                 .reads = reads,
                                 .writes = writes,
                                 .run = run};
static const riffle_pass* const passes[] = {&pass, NULL};
static const riffle_plugin plugin = {.size = sizeof(riffle_plugin),
                                     .dims = 0xEu,
                                     .id = "asymmetric",
                                     .kind = "viscosity",
                                     .version = "1.0.0",
                                     .summary = "a plugin of the tests",
                                     .source = "",
                                     .leaves_out = "",
                                     .passes = passes,
                                     .create = create_any,
                                     .destroy = destroy_any};
static const riffle_plugin* const all_plugins[] = {&plugin, NULL};
GOOD_LIBRARY
