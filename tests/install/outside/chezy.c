/* Bed friction after Chezy, in plain C against riffle/abi.h alone:
 *
 *   lambda = g |u| / (C^2 h)   so that du/dt = -lambda u
 *
 * What the C++ face writes for a plugin stands here in full, as an author in C, Fortran or Rust has to write it. */
#include <math.h>
#include <riffle/abi.h>
#include <stdio.h>
#include <stdlib.h>

struct chezy {
  int32_t dim;
  double gravity, coefficient;
};

/* ---- Fields and parameters ---- */

#define FIELD(shape, flags, name, unit, meaning) \
  { sizeof(riffle_field), shape, flags, 0, name, unit, meaning }
static const riffle_field velocity = FIELD(RIFFLE_VECTOR, 0, "velocity", "m.s-1", "velocity of the water");
static const riffle_field depth = FIELD(RIFFLE_SCALAR, 0, "depth", "m", "water depth");
static const riffle_field drag_rate =
    FIELD(RIFFLE_SCALAR, RIFFLE_ACCUMULATES | RIFFLE_NOT_NEGATIVE, "drag_rate", "s-1", "lambda in du/dt = -lambda u");

static const riffle_read read_velocity = {sizeof(riffle_read), RIFFLE_AT_I, 0, 0, &velocity};
static const riffle_read read_depth = {sizeof(riffle_read), RIFFLE_AT_I, 0, 0, &depth};
static const riffle_read* const reads[] = {&read_velocity, &read_depth, NULL};
static const riffle_write write_drag_rate = {sizeof(riffle_write), RIFFLE_SUM, 0, 0, &drag_rate};
static const riffle_write* const writes[] = {&write_drag_rate, NULL};

static const riffle_parameter gravity = {sizeof(riffle_parameter),
                                         RIFFLE_REAL,
                                         RIFFLE_ABOVE_MIN,
                                         0,
                                         "gravity",
                                         "m.s-2",
                                         "acceleration of gravity",
                                         NULL,
                                         "fluid.gravity",
                                         9.81,
                                         0,
                                         100,
                                         NULL};
static const riffle_parameter coefficient = {sizeof(riffle_parameter),
                                             RIFFLE_REAL,
                                             0,
                                             0,
                                             "coefficient",
                                             "m1/2.s-1",
                                             "Chezy's C: 30 for a weedy channel, 90 for smooth concrete",
                                             NULL,
                                             NULL,
                                             50,
                                             1,
                                             1000,
                                             NULL};
static const riffle_parameter* const parameters[] = {&gravity, &coefficient, NULL};

/* ---- Functions ---- */

static void* create(int32_t dim, const riffle_value* const* values, riffle_error* error) {
  struct chezy* self = malloc(sizeof *self);
  if (self == NULL) {
    snprintf(error->message, sizeof error->message, "no memory left for the coefficients");
    return NULL;
  }
  self->dim = dim;
  self->gravity = values[0]->number;
  self->coefficient = values[1]->number;
  return self;
}

static void destroy(void* self) {
  free(self);
}

static int32_t run(const void* state, const riffle_block* block, riffle_error* error) {
  const struct chezy* self = state;
  const double* h = block->in[1][0];
  double* rate = block->out[0][0];
  const double factor = self->gravity / (self->coefficient * self->coefficient);
  (void)error;
  for (int64_t k = 0; k < block->n; ++k) {
    double squared_speed = 0;
    for (int32_t c = 0; c < self->dim; ++c) squared_speed += block->in[0][c][k] * block->in[0][c][k];
    rate[k] += factor * sqrt(squared_speed) / h[k];
  }
  return RIFFLE_OK;
}

/* ---- Tables ---- */

static const riffle_pass friction = {.size = sizeof(riffle_pass),
                                     .type = RIFFLE_PASS_PARTICLE,
                                     .name = "friction",
                                     .reads = reads,
                                     .writes = writes,
                                     .run = run};
static const riffle_pass* const passes[] = {&friction, NULL};

static const riffle_plugin plugin = {.size = sizeof(riffle_plugin),
                                     .dims = 1u << 1 | 1u << 2,
                                     .id = "chezy",
                                     .kind = "drag",
                                     .version = "1.0.0",
                                     .summary = "Bed friction after Chezy",
                                     .source = "Chezy (1775)",
                                     .leaves_out = "the side walls of a narrow channel",
                                     .parameters = parameters,
                                     .passes = passes,
                                     .create = create,
                                     .destroy = destroy};
static const riffle_plugin* const plugins[] = {&plugin, NULL};

const riffle_library riffle_plugin_entry = {sizeof(riffle_library), RIFFLE_ABI_MAJOR, RIFFLE_ABI_MINOR,
                                            sizeof(double),         "plain C",        plugins};
