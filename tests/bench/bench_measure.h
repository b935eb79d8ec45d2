/* Errors and times of all methods of a table on one set of samples. */
#ifndef FOOTPOINT_BENCH_MEASURE_H
#define FOOTPOINT_BENCH_MEASURE_H

#include "../../evolve/input/scene.h"
#include "../support/error_stats.h"
#include "bench_cases.h"

/** Largest and usual number of turns of each method. */
enum { BENCH_ROUNDS = 41 };

/** Three modes: dependent calls, each of which waits for the last; independent calls, which the processor overlaps;
 *  loops over arrays. */
enum bench_mode { BENCH_CHAIN, BENCH_SCALAR, BENCH_BATCH, BENCH_MODES };
extern const char *const bench_mode_name[BENCH_MODES];

struct bench_result {
    const struct bench_method *method;
    const struct segment_kind *kind;
    struct rival_tuning tuning;
    struct bench_counts ops;                            /* average of a search */
    struct error_stats error[BENCH_MODES][BENCH_FOUND]; /* of xi, eta and gap, see bench_errors */
    double ns[BENCH_MODES];                             /* ns per search, median of the turns */
    double ns_min[BENCH_MODES];
    double ratio[BENCH_MODES]; /* median of Newton for the same question (the faster) over the method's median */
    double noise[BENCH_MODES]; /* half the interquartile range of the turns' ratios over their median */
};

/** The methods of a table that suit a scene; converged Newton comes first for each question. */
struct bench_run {
    struct bench_result *result; /* owned */
    int count;
    struct bench_cases cases[BENCH_QUESTIONS]; /* owned; empty for questions without a generated function */
};

/** Computes a method's answers to n cases, at most BENCH_BLOCK; xi is BENCH_NO_ANSWER if it finds nothing. */
void bench_find(const struct bench_result *r, int mode, const struct bench_case *c, size_t n,
                double (*found)[BENCH_FOUND], bench_slopes *slope);

/** Tunes the methods on training samples, then measures. Errors of bare and checked searches use all samples of the set
 *  (at most 600000, evenly spread). Other errors, operations and times use fewer; each method takes 1..BENCH_ROUNDS
 *  turns. */
struct bench_run bench_measure(const struct bench_table *table, const struct scene *scene,
                               const struct sample_set *training, const struct sample_set *set, size_t rounds);
void bench_run_free(struct bench_run *run);

#endif
