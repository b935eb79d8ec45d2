/* Every search that footpoint-bench compares, in tables: one for each instruction set that the methods are compiled
 * for. See bench_methods.c. */
#ifndef FOOTPOINT_BENCH_METHODS_H
#define FOOTPOINT_BENCH_METHODS_H

#include "../../codegen/genome/segment_kind.h"
#include "../rivals/rivals_tuned.h"

#include <stddef.h>

enum { BENCH_BLOCK = 128, BENCH_COLUMN = BENCH_BLOCK + 8 };

/** What an iteration writes that did not converge. */
#define BENCH_NO_ANSWER 1e300

/** One search: nodes, S after the last of the segment's, and xi, eta of the step before, which some methods start from.
 */
struct bench_input {
    double x[SEGMENT_VECTORS + 1][3], before[2];
};

/** Searches by columns, and what was found.  Columns begin on cache lines, of different sets. */
struct bench_block {
    _Alignas(64) double x[SEGMENT_INPUTS][BENCH_COLUMN];
    double before[2][BENCH_COLUMN], xi[BENCH_COLUMN], eta[BENCH_COLUMN];
};

struct bench_counts {
    long mul, div, add, sqrt;
};

/** What is chosen for a scene before a method runs: nothing, where it starts, or coefficients that it is linear in. */
enum bench_tune { TUNE_NOTHING, TUNE_POINT, TUNE_COEFFICIENTS };

struct bench_method {
    const char *name;
    const char *kind;  /* of segments */
    const char *scene; /* the one it was made for, or NULL: any */
    int ours;
    int depth_only; /* finds no xi, eta */
    enum rival_start start;
    enum bench_tune tune;
    int coefficients;         /* of each output */
    struct bench_counts ops;  /* of a whole search; of iterations until they stand, of the first step ... */
    struct bench_counts step; /* ... and of a later one */
    /* One search for each of n inputs, not vectorised over them. */
    void (*scalar)(const struct bench_input *restrict in, size_t n, const struct rival_tuning *restrict t,
                   double (*restrict found)[2]);
    /* BENCH_BLOCK searches, vectorised if the compiler can; NULL: the method has no such form. */
    void (*batch)(struct bench_block *restrict b, const struct rival_tuning *restrict t);
    /* Steps that an iteration takes until it stands; NULL: its steps are fixed. */
    int (*steps)(const struct bench_input *in, const struct rival_tuning *t);
};

/** For each kind of segment converged Newton stands first. */
struct bench_table {
    const char *isa, *flags;
    const struct bench_method *method;
    int count;
};

/** The table for an instruction set, NULL for the best that this machine has.  NULL if it is unknown or not there. */
const struct bench_table *bench_table_for(const char *isa);

#endif
