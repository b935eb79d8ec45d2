/* Errors and times of all methods of a table on one set of samples. */
#ifndef FOOTPOINT_BENCH_MEASURE_H
#define FOOTPOINT_BENCH_MEASURE_H

#include "../../evolve/input/scene.h"
#include "../../evolve/surface/sample.h"
#include "../support/error_stats.h"
#include "bench_methods.h"

/** Turns that each method takes: most, and usually. */
enum { BENCH_ROUNDS = 41 };

enum bench_mode { BENCH_SCALAR, BENCH_BATCH, BENCH_MODES };
extern const char *const bench_mode_name[BENCH_MODES];

struct bench_result {
    const struct bench_method *method;
    const struct segment_kind *kind;
    struct rival_tuning tuning;
    struct bench_counts ops;         /* of a search, on average */
    struct error_stats xi, eta, gap; /* gap: over the square root of the segment's area */
    double ns[BENCH_MODES];          /* of a search, median of the turns */
    double ns_min[BENCH_MODES];
    double ratio[BENCH_MODES]; /* converged Newton's median over this one's */
    double noise[BENCH_MODES]; /* half of the turns' interquartile range of the ratio, over its median */
};

/** The methods of a table that a scene can use; result[0] is converged Newton. */
struct bench_run {
    struct bench_result *result; /* owned */
    int count;
};

/** What a method finds for n samples; not a number where it finds nothing. */
void bench_find(const struct bench_result *r, const struct sample *const *s, size_t n, double (*found)[2]);

/** Tune the methods on training samples; measure errors on all of the set (at most 600000, evenly spread), operations
 *  and times on fewer, each method taking 1..BENCH_ROUNDS turns. */
struct bench_run bench_measure(const struct bench_table *table, const struct scene *scene,
                               const struct sample_set *training, const struct sample_set *set, size_t rounds);
void bench_run_free(struct bench_run *run);

#endif
