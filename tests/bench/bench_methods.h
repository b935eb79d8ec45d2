/* Tables of every search that footpoint-bench compares, one table for each instruction set. See bench_methods.c. */
#ifndef FOOTPOINT_BENCH_METHODS_H
#define FOOTPOINT_BENCH_METHODS_H

#include "../../codegen/genome/segment_kind.h"
#include "../rivals/rivals_kept.h"

#include <stddef.h>
#include <stdint.h>

/** A block's length is no power of 2, because rows of derivatives, which are a block apart, would evict each other from
 *  the cache. */
enum { BENCH_BLOCK = 160, BENCH_COLUMN = BENCH_BLOCK + 8 };

enum { BENCH_OVER = 8 };

/** Makes each search wait for the last: coordinate 0 of vector `slave` receives the bits of the answer, masked by
 *  `none`, which is 0 but unknown to compilers. */
struct bench_chain {
    uint64_t none;
    size_t slave;
};

/** The questions. A method answers one of them. Its time is compared with Newton's iteration for the same question,
 *  converged or fair, whichever is faster. */
enum bench_question {
    ASK_BARE,        /* only xi and eta, unchecked: NAME_at, NAME_n */
    ASK_CHECKED,     /* with gap and status: NAME, NAME_checked_n */
    ASK_OVER,        /* the same for BENCH_OVER slave nodes over each segment: calls of NAME, NAME_over_n */
    ASK_CLOSEST,     /* the closest point of the closed face: NAME_closest, NAME_closest_n */
    ASK_ALONG,       /* intersection of the face with a line through S: footpoint_SCENE_along, _along_n */
    ASK_DERIVATIVES, /* derivatives by all coordinates, with the search: NAME_gradients, NAME_gradients_n */
    ASK_FROM_NEAR,   /* with gap and status, from an answer off by 1e-3 of the face: NAME_from, NAME_from_n */
    ASK_FROM,        /* off by 1e-2 */
    ASK_FROM_FAR,    /* off by 1e-1 */
    BENCH_QUESTIONS
};
extern const char *const bench_question_name[BENCH_QUESTIONS];

/** xi of an iteration that did not converge. */
#define BENCH_NO_ANSWER 1e300

enum { BENCH_VECTORS = SEGMENT_VECTORS + 2, BENCH_COLUMNS = 3 * BENCH_VECTORS };

/** One search: the segment's nodes, then S, then a direction; and the last step's xi and eta, from which some methods
 *  start. */
struct bench_input {
    double x[BENCH_VECTORS][3], before[2];
};

/** Results of one search: xi, eta and, for some questions, the gap or distance. */
enum { BENCH_FOUND = 3 };

/** Derivatives of the results by all coordinates, in the order of x. */
typedef double bench_slopes[BENCH_FOUND][SEGMENT_INPUTS];

/** Derivatives of a block: element j of search i is at j BENCH_BLOCK + i; and the rows that come with them. All blocks
 *  write to the same rows. */
struct bench_rows {
    double slope[BENCH_FOUND][SEGMENT_INPUTS * BENCH_BLOCK], rest[4][SEGMENT_VECTORS * BENCH_BLOCK];
};

/** Searches by columns, and their results. Columns begin on cache lines of different sets. */
struct bench_block {
    _Alignas(64) double x[BENCH_COLUMNS][BENCH_COLUMN];
    double before[2][BENCH_COLUMN], xi[BENCH_COLUMN], eta[BENCH_COLUMN], gap[BENCH_COLUMN];
    int status[BENCH_COLUMN], region[BENCH_COLUMN];
    struct bench_rows *rows; /* not owned */
};

struct bench_counts {
    long mul, div, add, sqrt;
};

/** What a scene determines before a method runs: nothing, a starting point, or coefficients in which it is linear. */
enum bench_tune { TUNE_NOTHING, TUNE_POINT, TUNE_COEFFICIENTS };

struct bench_method {
    const char *name;
    const char *kind;  /* kind of segment */
    const char *scene; /* the scene of a generated function, or NULL: any */
    enum bench_question question;
    int ours;
    int fair;       /* fair Newton, which replaces converged Newton in ratios if it is faster */
    int depth_only; /* finds no xi and eta */
    enum rival_start start;
    enum bench_tune tune;
    int coefficients; /* number per output */
    struct bench_counts
        ops; /* of a whole search, 0 if not counted; for iterations that converge, of the first step ... */
    struct bench_counts step; /* ... and of a later step */
    /* Searches n inputs, not vectorised: independent calls if `chain` is NULL; otherwise each call waits for the last,
     * and `in` is changed. Only ASK_DERIVATIVES needs `slope`. */
    void (*scalar)(struct bench_input *restrict in, size_t n, const struct bench_chain *restrict chain,
                   const struct rival_tuning *restrict t, double (*restrict found)[BENCH_FOUND],
                   bench_slopes *restrict slope);
    /* Searches BENCH_BLOCK inputs, vectorised if the compiler can; NULL: the method has no such form. */
    void (*batch)(struct bench_block *restrict b, const struct rival_tuning *restrict t);
    /* Returns the steps until an iteration converges; NULL: its number of steps is fixed. */
    int (*steps)(const struct bench_input *in, const struct rival_tuning *t);
};

struct bench_list {
    const struct bench_method *method;
    int count;
};

enum { BENCH_LISTS = 2 };

/** Converged Newton comes first for each kind of segment and each question. */
struct bench_table {
    const char *isa, *flags;
    const struct bench_list *list[BENCH_LISTS]; /* [0] bare searches, [1] all others */
};

/** Returns the table for an instruction set, or for NULL the best that this machine supports. Returns NULL if it is
 *  unknown or unsupported. */
const struct bench_table *bench_table_for(const char *isa);

#endif
