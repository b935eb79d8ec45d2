/* Every search that footpoint-bench compares, in tables: one for each instruction set that the methods are compiled
 * for. See bench_methods.c. */
#ifndef FOOTPOINT_BENCH_METHODS_H
#define FOOTPOINT_BENCH_METHODS_H

#include "../../codegen/genome/segment_kind.h"
#include "../rivals/rivals_kept.h"

#include <stddef.h>
#include <stdint.h>

/** A block is no power of 2: rows of derivatives are as far apart as it is long, and would drive each other out of a
 *  cache. */
enum { BENCH_BLOCK = 160, BENCH_COLUMN = BENCH_BLOCK + 8 };

enum { BENCH_OVER = 8 };

/** Makes each search wait for the one before: coordinate 0 of vector `slave` takes the bits of what was found, masked by
 *  `none`, which is 0 and which no compiler knows. */
struct bench_chain {
    uint64_t none;
    size_t slave;
};

/** What is asked.  A method answers one of these; its time is compared with that of converged Newton, asked the same, or
 *  fair Newton, whichever is the quicker. */
enum bench_question {
    ASK_BARE,        /* xi and eta, nothing checked: NAME_at, NAME_n */
    ASK_CHECKED,     /* with gap and status: NAME, NAME_checked_n */
    ASK_OVER,        /* the same, BENCH_OVER slave nodes over each segment: NAME one by one, NAME_over_n */
    ASK_CLOSEST,     /* the closest point of the closed face: NAME_closest, NAME_closest_n */
    ASK_ALONG,       /* where the line through S in a direction meets the face: footpoint_SCENE_along, _along_n */
    ASK_DERIVATIVES, /* of xi, eta and gap by all coordinates, search and all: NAME_gradients, NAME_gradients_n */
    ASK_FROM_NEAR,   /* with gap and status, from an answer 1e-3 of the face away: NAME_from, NAME_from_n */
    ASK_FROM,        /* 1e-2 of it */
    ASK_FROM_FAR,    /* 1e-1 of it */
    BENCH_QUESTIONS
};
extern const char *const bench_question_name[BENCH_QUESTIONS];

/** What an iteration writes that did not converge. */
#define BENCH_NO_ANSWER 1e300

enum { BENCH_VECTORS = SEGMENT_VECTORS + 2, BENCH_COLUMNS = 3 * BENCH_VECTORS };

/** One search: nodes, S after the last of the segment's, and after it a direction; and xi, eta of the step before, which
 *  some methods start from. */
struct bench_input {
    double x[BENCH_VECTORS][3], before[2];
};

/** What one search finds: xi, eta and, where it is asked for, the gap or distance. */
enum { BENCH_FOUND = 3 };

/** Derivatives of what is found by all coordinates, in the order of x. */
typedef double bench_slopes[BENCH_FOUND][SEGMENT_INPUTS];

/** Derivatives of a block: element j of search i is element j BENCH_BLOCK + i; and other rows that come with them.  All
 *  blocks write to the same. */
struct bench_rows {
    double slope[BENCH_FOUND][SEGMENT_INPUTS * BENCH_BLOCK], rest[4][SEGMENT_VECTORS * BENCH_BLOCK];
};

/** Searches by columns, and what was found.  Columns begin on cache lines, of different sets. */
struct bench_block {
    _Alignas(64) double x[BENCH_COLUMNS][BENCH_COLUMN];
    double before[2][BENCH_COLUMN], xi[BENCH_COLUMN], eta[BENCH_COLUMN], gap[BENCH_COLUMN];
    int status[BENCH_COLUMN], region[BENCH_COLUMN];
    struct bench_rows *rows; /* not owned */
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
    enum bench_question question;
    int ours;
    int fair;       /* fair Newton: a time is over its own if that is less than converged Newton's */
    int depth_only; /* finds no xi, eta */
    enum rival_start start;
    enum bench_tune tune;
    int coefficients; /* of each output */
    struct bench_counts
        ops; /* of a whole search, 0 if not counted; of iterations until they stand, of the first step ... */
    struct bench_counts step; /* ... and of a later one */
    /* One search for each of n inputs, not vectorised over them: independent calls if `chain` is NULL, otherwise each
     * waits for the one before, and `in` is written to.  Only ASK_DERIVATIVES needs `slope`. */
    void (*scalar)(struct bench_input *restrict in, size_t n, const struct bench_chain *restrict chain,
                   const struct rival_tuning *restrict t, double (*restrict found)[BENCH_FOUND],
                   bench_slopes *restrict slope);
    /* BENCH_BLOCK searches, vectorised if the compiler can; NULL: the method has no such form. */
    void (*batch)(struct bench_block *restrict b, const struct rival_tuning *restrict t);
    /* Steps that an iteration takes until it stands; NULL: its steps are fixed. */
    int (*steps)(const struct bench_input *in, const struct rival_tuning *t);
};

struct bench_list {
    const struct bench_method *method;
    int count;
};

enum { BENCH_LISTS = 2 };

/** For each kind of segment, and for each question about it, converged Newton stands first. */
struct bench_table {
    const char *isa, *flags;
    const struct bench_list *list[BENCH_LISTS]; /* bare searches; all others */
};

/** The table for an instruction set, NULL for the best that this machine has.  NULL if it is unknown or not there. */
const struct bench_table *bench_table_for(const char *isa);

#endif
