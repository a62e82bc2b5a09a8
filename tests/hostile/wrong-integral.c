/* The cubic spline with the factor of two dimensions in every dimension, as once happened to somebody. */
#include "hostile.h"

static double shape(double q) {
  return q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : q < 2 ? 0.25 * (2 - q) * (2 - q) * (2 - q) : 0;
}
static double slope(double q) {
  return q < 1 ? -3 + 2.25 * q : q < 2 ? -0.75 * (2 - q) * (2 - q) / q : 0;
}

static const double sigma = 0.45472840883398667; /* 10 / (7 pi) */

static void* create(int32_t dim, const riffle_value* const* values, riffle_error* error) {
  static int32_t dims[] = {0, 1, 2, 3};
  (void)values, (void)error;
  return &dims[dim];
}
static void describe(const void* self, riffle_kernel* out) {
  (void)self;
  out->provides = RIFFLE_W | RIFFLE_F;
  out->support = 2;
  out->integral = 1;
}
static int32_t evaluate(const void* self, int64_t n, const double* r, const double* inverse_l, uint32_t want,
                        double* const* out) {
  for (int64_t k = 0; k < n; ++k) {
    double scale = sigma;
    for (int32_t d = 0; d < *(const int32_t*)self; ++d) scale *= inverse_l[k];
    if (want & RIFFLE_W) out[0][k] = scale * shape(r[k] * inverse_l[k]);
    if (want & RIFFLE_F) out[1][k] = scale * inverse_l[k] * inverse_l[k] * slope(r[k] * inverse_l[k]);
  }
  return RIFFLE_OK;
}

static const riffle_plugin plugin = {.size = sizeof(riffle_plugin),
                                     .dims = 0xEu,
                                     .id = "wrong-integral",
                                     .kind = "kernel",
                                     .version = "1.0.0",
                                     .summary = "a plugin of the tests",
                                     .source = "",
                                     .leaves_out = "",
                                     .create = create,
                                     .destroy = destroy_any,
                                     .kernel = describe,
                                     .evaluate_kernel = evaluate};
static const riffle_plugin* const all_plugins[] = {&plugin, NULL};
GOOD_LIBRARY
