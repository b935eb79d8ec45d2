/* What tests of searches share: random samples, judges, a place for what is found. */
#ifndef FOOTPOINT_SEARCH_FIXTURE_H
#define FOOTPOINT_SEARCH_FIXTURE_H

#include "../../evolve/common/decimal.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/fit/fit_constants.h"
#include "../../evolve/fit/grow.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { X = GENE_SYMBOL, Y, Z, W };

struct fixture {
    gsl_rng *rng;
    struct genome_file *program;
    struct columns table;   /* X, Y, ... and behind them the goal */
    struct judge *judge[3]; /* by norm */
    struct fitter *fitter;
    struct grow_plan plan; /* for the test to make */
    struct seeds front;    /* what was found */
};

/* All columns hold random numbers from -width to width. */
static inline struct fixture *fixture_new(uint64_t key, size_t samples, size_t symbols, double width)
{
    struct fixture *f = new_array(1, sizeof *f);
    f->rng = stream_new();
    stream_key(f->rng, key, 0, 0, 0);
    f->program = genome_file_new("test");
    f->table = columns_new(samples, symbols + 1);
    for (size_t j = 0; j < f->table.count; j++)
        for (size_t i = 0; i < samples; i++)
            columns_at(&f->table, j)[i] = width * (2 * gsl_rng_uniform(f->rng) - 1);
    for (int norm = NORM_MEAN; norm <= NORM_MAX; norm++)
        f->judge[norm] = judge_new(f->program, &f->table, (enum scene_norm)norm);
    f->fitter = fitter_new(&f->table);
    return f;
}

static inline int teardown(void **state)
{
    struct fixture *f = *state;
    seeds_free(&f->front);
    fitter_free(f->fitter);
    for (int norm = NORM_MEAN; norm <= NORM_MAX; norm++)
        judge_free(f->judge[norm]);
    columns_free(&f->table);
    genome_file_free(f->program);
    gsl_rng_free(f->rng);
    free(f);
    return 0;
}

#endif
