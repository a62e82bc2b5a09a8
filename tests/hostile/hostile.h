/* Parts of the hostile plugins: each of them is a good drag plugin but for the one thing that its file is about. Plain C
 * against the boundary alone, as an author without the SDK would write it. */
#ifndef RIFFLE_TESTS_HOSTILE_H
#define RIFFLE_TESTS_HOSTILE_H

#include <riffle/abi.h>
#include <stddef.h>

static const riffle_field field_velocity = {sizeof(riffle_field), RIFFLE_VECTOR, 0, 0, "velocity", "m.s-1", "velocity"};
static const riffle_field field_depth = {sizeof(riffle_field), RIFFLE_SCALAR, 0, 0, "depth", "m", "water depth"};
static const riffle_field field_drag_rate = {
    sizeof(riffle_field),         RIFFLE_SCALAR, RIFFLE_ACCUMULATES | RIFFLE_NOT_NEGATIVE, 0, "drag_rate", "s-1",
    "lambda in du/dt = -lambda u"};

static const riffle_read read_velocity = {sizeof(riffle_read), RIFFLE_AT_I, 0, 0, &field_velocity};
static const riffle_read read_depth = {sizeof(riffle_read), RIFFLE_AT_I, 0, 0, &field_depth};
static const riffle_read* const drag_reads[] = {&read_velocity, &read_depth, NULL};
static const riffle_write write_drag_rate = {sizeof(riffle_write), RIFFLE_SUM, 0, 0, &field_drag_rate};
static const riffle_write* const drag_writes[] = {&write_drag_rate, NULL};

static const riffle_parameter drag_coefficient = {.size = sizeof(riffle_parameter),
                                                  .type = RIFFLE_REAL,
                                                  .name = "coefficient",
                                                  .unit = "1",
                                                  .doc = "friction coefficient",
                                                  .fallback = 0.01,
                                                  .min = 0,
                                                  .max = 1};
static const riffle_parameter* const drag_parameters[] = {&drag_coefficient, NULL};

/* The one state that all instances share: a drag without parameters of its own. */
static inline void* create_any(int32_t dim, const riffle_value* const* values, riffle_error* error) {
  static char instance;
  (void)dim, (void)values, (void)error;
  return &instance;
}
static inline void destroy_any(void* self) {
  (void)self;
}

/* lambda = 0.01 max |u_c| / h */
static inline double drag_of(const riffle_block* block, int64_t k) {
  double largest = 0;
  for (int32_t c = 0; c < block->dim; ++c) {
    const double u = block->in[0][c][k];
    largest = u > largest ? u : -u > largest ? -u : largest;
  }
  return 0.01 * largest / block->in[1][0][k];
}
static inline int32_t run_drag(const void* self, const riffle_block* block, riffle_error* error) {
  (void)self, (void)error;
  for (int64_t k = 0; k < block->n; ++k) block->out[0][0][k] += drag_of(block, k);
  return RIFFLE_OK;
}

#define DRAG_PASS(RUN)                                                \
  static const riffle_pass drag_pass = {.size = sizeof(riffle_pass),  \
                                        .type = RIFFLE_PASS_PARTICLE, \
                                        .name = "friction",           \
                                        .reads = drag_reads,          \
                                        .writes = drag_writes,        \
                                        .run = RUN};                  \
  static const riffle_pass* const drag_passes[] = {&drag_pass, NULL};

#define DRAG_PLUGIN(ID, CREATE, PARAMETERS)                                     \
  static const riffle_plugin drag_plugin = {.size = sizeof(riffle_plugin),      \
                                            .dims = 0xEu,                       \
                                            .id = ID,                           \
                                            .kind = "drag",                     \
                                            .version = "1.0.0",                 \
                                            .summary = "a plugin of the tests", \
                                            .source = "",                       \
                                            .leaves_out = "",                   \
                                            .parameters = PARAMETERS,           \
                                            .passes = drag_passes,              \
                                            .create = CREATE,                   \
                                            .destroy = destroy_any};            \
  static const riffle_plugin* const all_plugins[] = {&drag_plugin, NULL};

#define LIBRARY(MAJOR, MINOR, BYTES)                         \
  RIFFLE_EXPORT const riffle_library riffle_plugin_entry = { \
      sizeof(riffle_library), MAJOR, MINOR, BYTES, "tests", all_plugins};

#define GOOD_LIBRARY LIBRARY(RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR, 8)

/* A whole library whose only fault is in its run function. */
#define DRAG_LIBRARY(ID, RUN)                  \
  DRAG_PASS(RUN)                               \
  DRAG_PLUGIN(ID, create_any, drag_parameters) \
  GOOD_LIBRARY

#endif
