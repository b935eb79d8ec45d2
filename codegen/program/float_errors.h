/* Measures errors of emitted float code on samples that footpoint-evolve --samples wrote. */
#ifndef FOOTPOINT_FLOAT_ERRORS_H
#define FOOTPOINT_FLOAT_ERRORS_H

#include "program.h"

/* Parts: held out on the grid of a scene, if it has a grid; held out off it; another distribution. */
enum { MEASURE_PARTS = 3, MEASURE_EVEN = 2 };

struct measure_samples {
    size_t inputs, n, room, width;
    double *row; /* owned: n rows of `width`: the part (MEASURE_PARTS more if climbing found it), inputs, xi, eta */
};

/** |value - truth| of an output on a part. */
struct measure_error {
    size_t n;
    double mean, p99, max; /* infinite if a value is not finite */
    double climbed;        /* the largest error, climbing from the worst samples included; 0: not climbed */
};

/** Reads evolution's errors of xi and eta: "n %zu mean %.3e %.3e p99 %.3e %.3e max %.3e %.3e", and perhaps " climbing %.3e %.3e". */
bool measure_errors_read(const char *text, struct measure_error e[2]);

/** Returns true if mean or 99 % differ by a factor of more than 1.5. */
bool measure_differs(const struct measure_error *a, const struct measure_error *b);

struct measured {
    struct measure_error error[MEASURE_PARTS][2]; /* indexed by part and output, xi and eta */
};

/** The names "heldout", "heldout_random", "heldout_even", indexed by part. */
extern const char *const measure_part[MEASURE_PARTS];

/** Reads a file whose columns are the inputs of f, a segment, and xi, eta.  Samples that climbing found may follow a part, as
 *  NAME_climbing.  Returns false with *d filled. */
bool measure_read(const char *path, const struct genome_file *f, struct measure_samples *s, struct diag *d);
void measure_samples_free(struct measure_samples *s);

/** Measures a program whose outputs are xi and eta, as the float code computes them, with coordinates relative to the segment or
 *  not. */
struct measured measure_program(const struct genome_file *f, const struct program *p, bool relative,
                                const struct measure_samples *s);

#endif
