/* riffle/abi.h: the whole contract between the Riffle host and its plugins.
 *
 * Plain C11. No C++, Eigen or library type crosses this line, no exception crosses it, and memory is freed by the side
 * that allocated it. Every struct starts with its own size; members are only ever appended (which raises the minor
 * version; any other change raises the major). While the major version is 0 the host also wants the same minor or an
 * older one, and nothing is promised between minors.
 *
 * Thread tags. [main]: one thread at a time, never while a [block] call is in flight.
 *              [block]: any worker thread, concurrently for disjoint blocks with the same `self`, therefore const.
 *
 * Arrays are in structure-of-arrays form: one contiguous array of double per component, 64-byte aligned unless said.
 * Units are SI; the dictionary of fields with their meaning and sign is riffle/fields.h.
 */
#ifndef RIFFLE_ABI_H
#define RIFFLE_ABI_H

#include <stdint.h>

#define RIFFLE_ABI_MAJOR 0u
#define RIFFLE_ABI_MINOR 2u

#if defined(_WIN32)
#define RIFFLE_EXPORT __declspec(dllexport)
#else
#define RIFFLE_EXPORT __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
#define RIFFLE_NOEXCEPT noexcept /* part of the type since C++17: a throwing function does not compile here */
extern "C" {
#else
#define RIFFLE_NOEXCEPT
#endif

/* ---- Status --------------------------------------------------------------------------------------------------- */

enum {
  RIFFLE_OK = 0,
  RIFFLE_ERROR = 1 /* stop the run; everything already computed stays sound and is written */
};

typedef struct riffle_error { /* owned by the host, filled by the plugin when it returns RIFFLE_ERROR */
  uint32_t size;
  char message[508]; /* UTF-8, NUL-terminated; one sentence that names the parameter or particle at fault */
} riffle_error;

/* ---- Parameters ----------------------------------------------------------------------------------------------- */

enum { /* riffle_parameter.type */
  RIFFLE_REAL = 0,
  RIFFLE_INTEGER = 1,
  RIFFLE_BOOLEAN = 2,
  RIFFLE_CHOICE = 3,  /* one word of `choices` */
  RIFFLE_TEXT = 4,    /* free text, e.g. a file name; relative paths are made absolute when flag RIFFLE_PATH is set */
  RIFFLE_FUNCTION = 5 /* of x, y, z, t: constant, piecewise values, formula or CSV table in the manifest */
};

enum { /* riffle_parameter.flags */
  RIFFLE_REQUIRED = 1u << 0,
  RIFFLE_ABOVE_MIN = 1u << 1, /* the minimum itself is excluded */
  RIFFLE_BELOW_MAX = 1u << 2, /* the maximum itself is excluded */
  RIFFLE_PATH = 1u << 3
};

typedef struct riffle_parameter {
  uint32_t size, type, flags, reserved;
  const char *name;    /* TOML key, [a-z][a-z0-9_]* */
  const char *unit;    /* SI base units as powers: "kg.m-3", "m2.s-1", "1" */
  const char *doc;     /* one line: meaning, and how to choose */
  const char *choices; /* RIFFLE_CHOICE: "first|second|third", else NULL */
  const char *inherit; /* manifest quantity whose value is the default, e.g. "fluid.gravity"; NULL: `fallback` */
  double fallback, min, max;
  const char *fallback_text; /* default of a choice or text */
} riffle_parameter;

typedef struct riffle_function { /* owned by the host, valid until the plugin instance is destroyed; [main] and [block] */
  uint32_t size, reserved;
  const void *context;
  /* out[k] = f(x[k], y[k], z[k], t) for k < n; y and z may be NULL (taken as 0) */
  void (*evaluate)(const void *context, int64_t n, const double *x, const double *y, const double *z, double t,
                   double *out) RIFFLE_NOEXCEPT;
} riffle_function;

typedef struct riffle_value { /* one per parameter, in the order declared; present, in range, in SI */
  uint32_t size, given;       /* given: 1 when the manifest sets it, 0 when it is the default */
  double number;              /* real, integer, boolean (0 or 1), choice (index into `choices`) */
  const char *text;           /* choice and text */
  const riffle_function *function;
} riffle_value;

/* ---- Fields ---------------------------------------------------------------------------------------------------- */

enum { /* riffle_field.shape: components in dim dimensions */
  RIFFLE_SCALAR = 0,    /* 1 */
  RIFFLE_VECTOR = 1,    /* dim */
  RIFFLE_SYMMETRIC = 2, /* dim (dim + 1) / 2: xx, xy, yy, xz, yz, zz */
  RIFFLE_TENSOR = 3     /* dim * dim, row by row */
};

enum { /* riffle_field.flags */
  RIFFLE_ACCUMULATES = 1u << 0, /* several passes may add to it (RIFFLE_SUM); the host zeroes it first */
  RIFFLE_NOT_NEGATIVE = 1u << 1, /* the host stops the run and names the writer when a value is below zero */
  RIFFLE_PER_PAIR = 1u << 2,     /* one value per pair, alive while one block is processed (unless kept) */
  RIFFLE_NEEDED = 1u << 3        /* in riffle_plugin.initial: the manifest must give it (depth always) */
};

typedef struct riffle_field {
  uint32_t size, shape, flags, reserved;
  const char *name;    /* full standard term, [a-z][a-z0-9_]* */
  const char *unit;    /* as for parameters; the exponent d is the dimension: "m-d", "md" */
  const char *meaning; /* one line with the sign convention */
} riffle_field;

/* ---- Passes ---------------------------------------------------------------------------------------------------- */

enum { /* riffle_read.where */
  RIFFLE_AT_I = 0,       /* the particle's own value; in pair passes repeated for each of its pairs.
                            For kernel outputs: evaluated with the smoothing length of i */
  RIFFLE_AT_J = 1,       /* the neighbour's value; for kernel outputs: with the smoothing length of j */
  RIFFLE_DIFFERENCE = 2, /* value at i minus value at j, formed by the host in double precision */
  RIFFLE_MEAN = 3,       /* (value at i + value at j) / 2; for kernel outputs: with the mean smoothing length */
  RIFFLE_PAIR = 4        /* a per-pair field: geometry or another pass's pair output */
};

enum { /* riffle_read.flags */
  RIFFLE_OPTIONAL = 1u << 0, /* in[k] is NULL when nobody provides the field */
  RIFFLE_PREVIOUS = 1u << 1  /* the value left by the last evaluation (warm start); kept in checkpoints; no ordering */
};

typedef struct riffle_read {
  uint32_t size, where, flags, reserved;
  const riffle_field *field;
} riffle_read;

enum { /* riffle_write.how */
  RIFFLE_SET = 0, /* particle and global passes: this pass alone writes the field. Pair passes: a per-pair field */
  RIFFLE_SUM = 1, /* pair passes: contributions summed over neighbours. Particle passes: use += */
  RIFFLE_MIN = 2, /* pair passes: smallest contribution over neighbours (+infinity without neighbours) */
  RIFFLE_MAX = 3  /* pair passes: largest contribution (-infinity without neighbours) */
};

enum { RIFFLE_KEEP = 1u << 0 }; /* riffle_write.flags: store this per-pair field for the whole list, for a global pass */

typedef struct riffle_write {
  uint32_t size, how, flags, reserved;
  const riffle_field *field;
} riffle_write;

enum { /* particle roles, as bits of a mask */
  RIFFLE_FLUID = 1u << 0,
  RIFFLE_WALL = 1u << 1,
  RIFFLE_INFLOW = 1u << 2,
  RIFFLE_OUTFLOW = 1u << 3,
  RIFFLE_PISTON = 1u << 4,
  RIFFLE_PROBE = 1u << 5, /* a point to look at fields: target of passes, never a source unless asked for */
  RIFFLE_ALL_ROLES = (1u << 6) - 1u
}; /* ghosts (mirror and periodic images) have the role of their origin */

enum { /* riffle_pass.type */
  RIFFLE_PASS_PARTICLE = 0, /* its own particle only */
  RIFFLE_PASS_PAIR = 1,     /* flat arrays over pairs */
  RIFFLE_PASS_GLOBAL = 2    /* all particles at once, one thread: elliptic solves */
};

enum { /* riffle_pass.neighbours: which pairs (i, j) are listed, kappa = the kernel's support in units of l */
  RIFFLE_GATHER = 0,  /* r < kappa l_i */
  RIFFLE_SCATTER = 1, /* r < kappa l_j */
  RIFFLE_EITHER = 2   /* r < kappa max(l_i, l_j) */
};

enum { /* riffle_pass.flags */
  RIFFLE_WITH_SELF = 1u << 0,  /* pair passes: also the pair (i, i) with r = 0, as summation density needs */
  RIFFLE_INITIAL = 1u << 1,    /* runs once, at t = 0; what it writes are constant attributes of the particle */
  RIFFLE_OCCASIONAL = 1u << 2, /* runs between steps, every `every` steps or `interval` seconds (filters) */
  RIFFLE_IF_PROVIDED = 1u << 3, /* dropped without error when a field it reads has no writer */
  RIFFLE_STEADY = 1u << 4 /* what it writes follows from what it reads alone, not from time, dt or memory: it need not run
                             for particles around which nothing has changed */
};

typedef struct riffle_block {
  uint32_t size;
  int32_t dim;
  int64_t n;     /* pairs (pair passes: padded to a multiple of 4, arrays readable and writable to the next 8) or particles */
  int64_t first; /* particle passes: index of the first particle. Pair passes: index of the first target */
  double time, dt;
  const double *const *const *in; /* in[k][c]: component c of reads[k]; n values each */
  double *const *const *out;      /* out[k][c]: component c of writes[k] */
} riffle_block;

typedef struct riffle_pairs { /* the whole neighbour list, for global passes */
  uint32_t size, reserved;
  int64_t n_owned, n_all;       /* targets are 0 .. n_owned-1; neighbours n_owned .. n_all-1 are images */
  const int64_t *begin, *count; /* entries of target i: begin[i] .. begin[i] + count[i] - 1 */
  const int32_t *neighbour;
  const int32_t *origin; /* [n_all - n_owned]: the owned particle of each image */
} riffle_pairs;

typedef int32_t (*riffle_run_fn)(const void *self, const riffle_block *block, riffle_error *error) RIFFLE_NOEXCEPT;
typedef int32_t (*riffle_global_fn)(const void *self, const riffle_block *block, const riffle_pairs *pairs,
                                    riffle_error *error) RIFFLE_NOEXCEPT;

typedef struct riffle_pass {
  uint32_t size, type, targets, sources; /* role masks; 0 means: targets fluid, sources all but probes */
  uint32_t neighbours, flags;
  const char *name;                  /* shown by `explain` and in messages */
  const riffle_read *const *reads;   /* NULL-terminated */
  const riffle_write *const *writes; /* NULL-terminated */
  const char *iteration;             /* NULL, or the name of the riffle_iteration this pass belongs to */
  const char *when;                  /* NULL, or "parameter=value|value": active only then */
  const char *every, *interval;      /* occasional passes: the integer / real parameters that hold steps / seconds */
  riffle_run_fn run;                 /* pair and particle passes [block] */
  riffle_global_fn run_global;       /* global passes [main]; kept pair fields come in list order */
} riffle_pass;

typedef struct riffle_iteration { /* passes repeated together until max(residual) <= tolerance */
  uint32_t size, reserved;
  const char *name;
  const riffle_field *residual;              /* per particle, written by a pass of the iteration */
  const char *tolerance, *maximum_iterations; /* names of the parameters that hold them */
} riffle_iteration;

typedef struct riffle_vote { /* on the time step */
  uint32_t size, targets;
  uint32_t scaled; /* 1: multiplied by [time] cfl; 0: taken as it is */
  uint32_t reserved;
  const char *name; /* "acoustic", "viscous": shown in the log as the limiter */
  const char *when; /* as for passes */
  const riffle_read *const *reads; /* at i only; a vote whose reads nobody provides is dropped */
  /* the largest stable step over the particles of the block, +infinity if none [block] */
  double (*limit)(const void *self, const riffle_block *block) RIFFLE_NOEXCEPT;
} riffle_vote;

typedef struct riffle_evolved { /* d field / dt = rate - damping * field */
  uint32_t size, flags;
  const riffle_field *field, *rate;
  const riffle_field *damping; /* NULL, or a rate [1/s] >= 0 applied point-implicitly when somebody writes it */
  const char *when;            /* as for passes: evolved only then */
} riffle_evolved;

/* ---- Kinds with functions of their own -------------------------------------------------------------------------- */

enum { /* kernel outputs, as bits; order of out[] in evaluate */
  RIFFLE_W = 1u << 0,       /* W(r, l) */
  RIFFLE_F = 1u << 1,       /* (dW/dr) / r, finite at r = 0, never positive */
  RIFFLE_W_L = 1u << 2,     /* dW/dl */
  RIFFLE_W_RR = 1u << 3,    /* d2W/dr2 */
  RIFFLE_W_RL = 1u << 4,    /* d2W/(dr dl) */
  RIFFLE_W_LL = 1u << 5,    /* d2W/dl2 */
  RIFFLE_KERNEL_OUTPUTS = 6
};

typedef struct riffle_kernel {
  uint32_t size, provides;
  double support;  /* kappa: W and all it provides are exactly 0 for r >= kappa l */
  double integral; /* of W over space: 1, or what lattice normalisation makes of it */
} riffle_kernel;

typedef struct riffle_points {
  uint32_t size;
  int32_t dim;
  int64_t n;
  const double *x[3];
  double time;
} riffle_points;

enum { RIFFLE_MIRROR = 0, RIFFLE_SHIFT = 1 }; /* riffle_editor.image */

/* What a boundary may do between steps. Indices are those of the owned particles at the moment of the call; additions
 * come at the end; removals take effect after the call. All functions [main]. */
typedef struct riffle_editor {
  uint32_t size;
  int32_t dim;
  int64_t count; /* owned particles, additions excluded */
  double time, dt;
  double *state; /* the plugin's own numbers (riffle_plugin.state_size), kept in checkpoints */
  void *context;
  const double *reach; /* [count] how far each particle sees, skin of the lists included                */
  const uint32_t *role;                                                                       /* [count] */
  const double *(*read)(void *context, const char *field, int32_t component) RIFFLE_NOEXCEPT; /* NULL if absent */
  double *(*write)(void *context, const char *field, int32_t component) RIFFLE_NOEXCEPT;      /* NULL if absent */
  int64_t (*add)(void *context, uint32_t role, int64_t like) RIFFLE_NOEXCEPT; /* a copy of particle `like`; its index */
  void (*remove)(void *context, int64_t index) RIFFLE_NOEXCEPT;
  void (*retag)(void *context, int64_t index, uint32_t role) RIFFLE_NOEXCEPT;
  /* an image of particle `origin` (or of an image, for corners): RIFFLE_MIRROR in the plane through a[] with normal
     axis `axis`, RIFFLE_SHIFT by the vector a[]; returns the image's index (count, count + 1, ...) */
  int64_t (*image)(void *context, int64_t origin, uint32_t how, int32_t axis, const double *a) RIFFLE_NOEXCEPT;
} riffle_editor;

/* What a scene offers to every plugin (riffle_plugin.connect); owned by the host, outlives every instance. [main] [block] */
typedef struct riffle_services {
  uint32_t size;
  int32_t dim;
  uint32_t has_bed, has_width; /* 1 when the scene names a plugin of that kind */
  double low[3], high[3];      /* of the domain, by axis: x | x z | x y z */
  const void *context;
  /* level[k] = b(x[k], y[k]) [m] and its gradient [1]; a flat bed at 0 when there is none. y, slope_x and slope_y may be
     NULL (y: 0) */
  void (*bed)(const void *context, int64_t n, const double *x, const double *y, double *level, double *slope_x,
              double *slope_y) RIFFLE_NOEXCEPT;
  /* width[k] = B(x[k]) [m] and dB/dx [1], which may be NULL; 1 m when there is none */
  void (*width)(const void *context, int64_t n, const double *x, double *width, double *slope) RIFFLE_NOEXCEPT;
  double spacing; /* initial.particles.spacing [m]; 0 when particles are placed by count */
  uint32_t starts_from_reference; /* 1 when an initial field begins as the reference has it */
  uint32_t reserved;
  /* For whoever runs the scene, in connect: one sentence about what can be computed and yet is doubtful. [main] */
  void (*warn)(const void *context, const char *sentence) RIFFLE_NOEXCEPT;
} riffle_services;

/* A plugin that an equation set cannot be run with. */
typedef struct riffle_refusal {
  uint32_t size, reserved;
  const char *kind;
  const char *id;     /* NULL: every one of that kind but "none" */
  const char *reason; /* why, and what to do; ends the sentence "... cannot be used with ...: " */
} riffle_refusal;

/* ---- Plugin, library --------------------------------------------------------------------------------------------- */

typedef struct riffle_plugin {
  uint32_t size;
  uint32_t dims; /* bit d set: dimension d supported */
  const char *id, *kind, *version, *summary;
  const char *source;  /* author, year, equation numbers */
  const char *leaves_out; /* what the model does not contain, and where it fails; "" if nothing worth a line */
  const riffle_parameter *const *parameters; /* this and all tables below NULL-terminated, or NULL when empty */
  const riffle_pass *const *passes;
  const riffle_iteration *const *iterations;
  const riffle_vote *const *votes;
  const riffle_evolved *const *evolved;
  const riffle_field *const *initial; /* equations: fields that [initial] of the manifest must or may give */
  const riffle_field *conserved;      /* equations: the per-particle amount in the mass ledger */
  const char *requires_integrator;    /* "a|b": integrators that it can be run with; NULL: any */

  /* [main] NULL and a message on failure; values[k] belongs to parameters[k] */
  void *(*create)(int32_t dim, const riffle_value *const *values, riffle_error *error) RIFFLE_NOEXCEPT;
  void (*destroy)(void *self) RIFFLE_NOEXCEPT; /* [main] */

  /* kernel */
  void (*kernel)(const void *self, riffle_kernel *out) RIFFLE_NOEXCEPT; /* [main] */
  /* for k < n: out[b][k] for each bit b of `want`, at distance r[k] with smoothing length 1 / inverse_l[k] (the host
     inverts once per particle, so that no closure divides per pair) [block] */
  int32_t (*evaluate_kernel)(const void *self, int64_t n, const double *r, const double *inverse_l, uint32_t want,
                             double *const *out) RIFFLE_NOEXCEPT;

  /* boundary */
  int32_t state_size;
  int32_t reserved;
  int32_t (*begin)(const void *self, const riffle_editor *editor, riffle_error *error) RIFFLE_NOEXCEPT; /* once, t = 0 */
  int32_t (*edit)(const void *self, const riffle_editor *editor, riffle_error *error) RIFFLE_NOEXCEPT;  /* each step */
  int32_t (*images)(const void *self, const riffle_editor *editor, riffle_error *error) RIFFLE_NOEXCEPT; /* new list */

  /* reference: values[row][k] and the scale that makes its error relative; one row per component of the fields of
     `gives`, in their order (scalar: 1, vector: dim, ...); defined[k] = 0 where there is no answer */
  const riffle_field *const *gives;
  int32_t (*evaluate_reference)(const void *self, const riffle_points *points, double *const *values,
                                double *const *scales, uint8_t *defined, riffle_error *error) RIFFLE_NOEXCEPT;

  const riffle_refusal *const *refuses; /* equations: what they cannot be run with */
  /* Any kind: called once, when all plugins of the scene exist, before t = 0. [main] */
  int32_t (*connect)(void *self, const riffle_services *services, riffle_error *error) RIFFLE_NOEXCEPT;
  /* bed: value = level [m]; width: value = width [m]; slopes are their derivatives (at a jump: of the flat parts).
     y, slope_x, slope_y may be NULL. [main] [block] */
  int32_t (*evaluate_profile)(const void *self, int64_t n, const double *x, const double *y, double *value,
                              double *slope_x, double *slope_y, riffle_error *error) RIFFLE_NOEXCEPT;
} riffle_plugin;

typedef struct riffle_library {
  uint32_t size;
  uint32_t abi_major, abi_minor; /* of the header this library was compiled with */
  uint32_t real_bytes;           /* 8 */
  const char *build;             /* compiler and flags: provenance only */
  const riffle_plugin *const *plugins; /* NULL-terminated */
} riffle_library;

/* The one exported symbol of a plugin library. */
RIFFLE_EXPORT extern const riffle_library riffle_plugin_entry;

#ifdef __cplusplus
}
#endif
#endif /* RIFFLE_ABI_H */
