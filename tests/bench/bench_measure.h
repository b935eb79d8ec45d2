/* Errors and times of all methods of a table on one set of samples. */
#ifndef FOOTPOINT_BENCH_MEASURE_H
#define FOOTPOINT_BENCH_MEASURE_H

#include "../../evolve/input/scene.h"
#include "../support/error_stats.h"
#include "bench_cases.h"

/** Turns that each method takes: most, and usually. */
enum { BENCH_ROUNDS = 41 };

/** Three clocks: dependent calls, each of which waits for the one before; independent calls, which the processor
 *  overlaps; loops over arrays. */
enum bench_mode { BENCH_CHAIN, BENCH_SCALAR, BENCH_BATCH, BENCH_MODES };
extern const char *const bench_mode_name[BENCH_MODES];

struct bench_result {
    const struct bench_method *method;
    const struct segment_kind *kind;
    struct rival_tuning tuning;
    struct bench_counts ops;                            /* of a search, on average */
    struct error_stats error[BENCH_MODES][BENCH_FOUND]; /* of xi, eta and gap, as bench_errors says */
    double ns[BENCH_MODES];                             /* of a search, median of the turns */
    double ns_min[BENCH_MODES];
    double
        ratio[BENCH_MODES]; /* the median of Newton, asked the same, over this one's: converged or fair, the quicker */
    double noise[BENCH_MODES]; /* half of the turns' interquartile range of the ratio, over its median */
};

/** The methods of a table that a scene can use; the first of each question is converged Newton. */
struct bench_run {
    struct bench_result *result; /* owned */
    int count;
    struct bench_cases cases[BENCH_QUESTIONS]; /* owned; none of questions that there is no function of ours for */
};

/** What a method finds for n cases, BENCH_BLOCK at most; xi is BENCH_NO_ANSWER where it finds nothing. */
void bench_find(const struct bench_result *r, int mode, const struct bench_case *c, size_t n,
                double (*found)[BENCH_FOUND], bench_slopes *slope);

/** Tune the methods on training samples; measure errors of bare and checked searches on all of the set (at most 600000,
 *  evenly spread), other errors, operations and times on fewer, each method taking 1..BENCH_ROUNDS turns. */
struct bench_run bench_measure(const struct bench_table *table, const struct scene *scene,
                               const struct sample_set *training, const struct sample_set *set, size_t rounds);
void bench_run_free(struct bench_run *run);

#endif
