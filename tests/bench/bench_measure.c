/* Errors and times; see bench_measure.h.
 *
 * The methods take turns, --rounds times, and the median of a method's turns is its time, so that other load affects
 * all methods alike. The noise is the scatter of the ratio to Newton in the same round. */
#include "bench_measure.h"

#include "../../codegen/base/base.h"
#include "bench_tune.h"

#include <gsl/gsl_sort_double.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { TIMED_BLOCKS = 62, TIMED_SAMPLES = TIMED_BLOCKS * BENCH_BLOCK, REPEATS = 4 };
#define TURN 2e6 /* longest turn, ns */

/* Most cases for errors. If samples are turned into questions, only the timed cases. */
static const size_t most_cases[BENCH_QUESTIONS] = {600000,        600000,        TIMED_SAMPLES,
                                                   TIMED_SAMPLES, TIMED_SAMPLES, TIMED_SAMPLES,
                                                   TIMED_SAMPLES, TIMED_SAMPLES, TIMED_SAMPLES};

const char *const bench_mode_name[BENCH_MODES] = {"chain", "scalar", "batch"};
const char *const bench_question_name[BENCH_QUESTIONS] = {"bare",        "checked",   "over",      "closest",  "along",
                                                          "derivatives", "from_1e-3", "from_1e-2", "from_1e-1"};

static bool has_mode(const struct bench_method *m, int mode)
{
    return mode != BENCH_BATCH || m->batch;
}

/* Calls a method for n inputs of a kind of segment; in BENCH_CHAIN each call waits for the last. */
static void search_calls(const struct bench_result *r, int mode, struct bench_input *in, size_t n,
                         double (*found)[BENCH_FOUND], bench_slopes *slope)
{
    static volatile uint64_t none;
    const struct bench_chain chain = {none, segment_vectors(r->kind)};
    r->method->scalar(in, n, mode == BENCH_CHAIN ? &chain : NULL, &r->tuning, found, slope);
}

/* ---- answers ---- */

/* Derivatives of the last block. */
static struct bench_rows rows;

/* Fills a block with n cases from `first` on; the last case fills the rest. */
static void fill_block(struct bench_block *b, const struct bench_case *c, size_t n)
{
    memset(b->status, 0, sizeof b->status);
    b->rows = &rows;
    for (size_t i = 0; i < BENCH_BLOCK; i++) {
        const struct bench_input *in = &c[i < n ? i : n - 1].in;
        for (size_t k = 0; k < BENCH_COLUMNS; k++)
            b->x[k][i] = in->x[k / 3][k % 3];
        for (size_t k = 0; k < 2; k++)
            b->before[k][i] = in->before[k];
    }
}

static void find_batch(const struct bench_result *r, const struct bench_case *c, size_t n, double (*found)[BENCH_FOUND],
                       bench_slopes *slope)
{
    static struct bench_block b;
    fill_block(&b, c, n);
    r->method->batch(&b, &r->tuning);
    for (size_t i = 0; i < n; i++) {
        found[i][0] = b.status[i] < 0 ? BENCH_NO_ANSWER : b.xi[i];
        found[i][1] = b.eta[i];
        found[i][2] = b.gap[i];
        for (size_t k = 0; k < BENCH_FOUND * SEGMENT_INPUTS && r->method->question == ASK_DERIVATIVES; k++)
            slope[i][k / SEGMENT_INPUTS][k % SEGMENT_INPUTS] =
                rows.slope[k / SEGMENT_INPUTS][k % SEGMENT_INPUTS * BENCH_BLOCK + i];
    }
}

void bench_find(const struct bench_result *r, int mode, const struct bench_case *c, size_t n,
                double (*found)[BENCH_FOUND], bench_slopes *slope)
{
    struct bench_input in[BENCH_BLOCK];
    if (mode == BENCH_BATCH) {
        find_batch(r, c, n, found, slope);
        return;
    }
    for (size_t i = 0; i < n; i++)
        in[i] = c[i].in;
    search_calls(r, mode, in, n, found, slope);
}

static void measure_errors(struct bench_result *r, int mode, const struct bench_cases *cases)
{
    if (r->method->depth_only || !has_mode(r->method, mode)) {
        r->error[mode][0] = r->error[mode][1] = r->error[mode][2] =
            (struct error_stats){(double)NAN, (double)NAN, (double)NAN, 0};
        return;
    }
    static bench_slopes slope[BENCH_BLOCK];
    double found[BENCH_BLOCK][BENCH_FOUND], *error[BENCH_FOUND];
    for (int k = 0; k < BENCH_FOUND; k++)
        error[k] = new_array(cases->n, sizeof *error[k]);
    for (size_t first = 0; first < cases->n; first += BENCH_BLOCK) {
        const size_t n = cases->n - first < BENCH_BLOCK ? cases->n - first : BENCH_BLOCK;
        bench_find(r, mode, cases->of + first, n, found, slope);
        for (size_t i = 0; i < n; i++) {
            double e[BENCH_FOUND];
            bench_errors(r->kind, r->method->question, &cases->of[first + i], found[i], slope[i], e);
            for (int k = 0; k < BENCH_FOUND; k++)
                error[k][first + i] = e[k];
        }
    }
    for (int k = 0; k < BENCH_FOUND; k++) {
        r->error[mode][k] = error_stats_of(error[k], cases->n);
        free(error[k]);
    }
}

/* ---- times ---- */

/* The timed cases, as structures and by columns. */
struct timed {
    struct bench_input *in; /* owned; TIMED_SAMPLES */
    struct bench_block *b;  /* owned; TIMED_BLOCKS */
};

/* Spreads the timed cases evenly over all; repeats them if they are fewer. */
static struct timed timed_new(const struct bench_cases *cases)
{
    struct timed t = {new_array(TIMED_SAMPLES, sizeof *t.in), aligned_alloc(64, TIMED_BLOCKS * sizeof *t.b)};
    struct bench_case block[BENCH_BLOCK];
    for (size_t i = 0; i < TIMED_SAMPLES && t.b; i++) {
        const size_t from = cases->n < TIMED_SAMPLES ? i % cases->n : i * cases->n / TIMED_SAMPLES;
        block[i % BENCH_BLOCK] = cases->of[from];
        t.in[i] = cases->of[from].in;
        if (i % BENCH_BLOCK == BENCH_BLOCK - 1)
            fill_block(&t.b[i / BENCH_BLOCK], block, BENCH_BLOCK);
    }
    return t;
}

static void timed_free(struct timed *t)
{
    free(t->in);
    free(t->b);
}

/* Returns processor time, which excludes other processes. */
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Returns ns per search over `blocks`, spread evenly over all. A block is searched several times while it is in the
 * cache. */
static double time_blocks(const struct bench_result *r, int mode, const struct timed *t, int blocks, int repeats)
{
    static bench_slopes slope[BENCH_BLOCK];
    double found[BENCH_BLOCK][BENCH_FOUND];
    const double start = seconds();
    for (int k = 0; k < blocks; k++)
        for (int repeat = 0; repeat < repeats; repeat++) {
            const int at = k * TIMED_BLOCKS / blocks;
            if (mode == BENCH_BATCH)
                r->method->batch(&t->b[at], &r->tuning);
            else
                search_calls(r, mode, &t->in[at * BENCH_BLOCK], BENCH_BLOCK, found, slope);
        }
    return 1e9 * (seconds() - start) / ((double)blocks * repeats * BENCH_BLOCK);
}

/* Returns the number of blocks in a turn: all, or as many as take about TURN nanoseconds. */
static int blocks_of(const struct bench_result *r, int mode, const struct timed *t)
{
    const double block = time_blocks(r, mode, t, 2, 1) * BENCH_BLOCK * REPEATS;
    const double blocks = TURN / fmax(block, 1);
    return blocks < 1 ? 1 : blocks > TIMED_BLOCKS ? TIMED_BLOCKS : (int)blocks;
}

/* Returns the operations of a search; for an iteration, the first step and the average number of later steps. */
static struct bench_counts counts_of(const struct bench_result *r, const struct timed *t)
{
    const struct bench_counts first = r->method->ops, step = r->method->step;
    double later = 0;
    if (!r->method->steps)
        return first;
    for (size_t i = 0; i < TIMED_SAMPLES; i++) {
        const int n = r->method->steps(&t->in[i], &r->tuning);
        later += (n ? n : RIVAL_STEPS_MAX) - 1;
    }
    later /= TIMED_SAMPLES;
    return (struct bench_counts){
        first.mul + lrint(later * (double)step.mul), first.div + lrint(later * (double)step.div),
        first.add + lrint(later * (double)step.add), first.sqrt + lrint(later * (double)step.sqrt)};
}

/* Returns true if a method applies to a scene. Generated functions apply to their scene, searches that start in A's
 * quarter to scenes in which A is the nearest corner, other questions to scenes with generated functions that answer
 * them. */
static bool runs_on(const struct bench_method *m, const struct scene *scene, const bool asked[BENCH_QUESTIONS])
{
    if (strcmp(m->kind, scene->segment->name) != 0)
        return false;
    if (m->scene)
        return strcmp(m->scene, scene->name) == 0;
    return asked[m->question] && (m->start == RIVAL_CENTRE || scene->order != CORNERS_ANY);
}

/* Finds the questions that generated functions answer. */
static void find_asked(const struct bench_table *table, const struct scene *scene, bool asked[BENCH_QUESTIONS])
{
    for (int q = 0; q < BENCH_QUESTIONS; q++)
        asked[q] = q == ASK_BARE;
    for (int l = 0; l < BENCH_LISTS; l++)
        for (int i = 0; i < table->list[l]->count; i++) {
            const struct bench_method *m = &table->list[l]->method[i];
            if (m->ours && strcmp(m->scene, scene->name) == 0)
                asked[m->question] = true;
        }
}

static void take_times(struct bench_result *r, int mode, size_t rounds, const double ns[BENCH_ROUNDS])
{
    double sorted[BENCH_ROUNDS];
    memcpy(sorted, ns, sizeof sorted);
    gsl_sort(sorted, 1, rounds);
    r->ns[mode] = sorted[rounds / 2];
    r->ns_min[mode] = sorted[0];
}

/* Computes the noise from the times of a method's and of Newton's turns, both indexed by round. */
static void take_noise(struct bench_result *r, int mode, size_t rounds, const double *ns, const double *newton)
{
    double ratio[BENCH_ROUNDS];
    for (size_t i = 0; i < rounds; i++)
        ratio[i] = newton[i] / ns[i];
    gsl_sort(ratio, 1, rounds);
    r->noise[mode] = 0.5 *
                     (gsl_stats_quantile_from_sorted_data(ratio, 1, rounds, 0.75) -
                      gsl_stats_quantile_from_sorted_data(ratio, 1, rounds, 0.25)) /
                     gsl_stats_median_from_sorted_data(ratio, 1, rounds);
}

/* Returns Newton's iteration for the question of method i: converged or fair, whichever has the smaller median. */
static int newton_of(const struct bench_run *run, int i, int mode)
{
    int newton = 0;
    while (run->result[newton].method->question != run->result[i].method->question)
        newton++;
    for (int k = newton + 1; k < run->count; k++) {
        const struct bench_method *const m = run->result[k].method;
        if (m->fair && m->question == run->result[i].method->question &&
            run->result[k].ns[mode] < run->result[newton].ns[mode])
            newton = k;
    }
    return newton;
}

static void measure_times(struct bench_run *run, struct timed timed[BENCH_QUESTIONS], size_t rounds)
{
    double(*ns)[BENCH_MODES][BENCH_ROUNDS] = new_array((size_t)run->count, sizeof *ns);
    int(*blocks)[BENCH_MODES] = new_array((size_t)run->count, sizeof *blocks);
    for (int i = 0; i < run->count; i++)
        for (int mode = 0; mode < BENCH_MODES; mode++)
            if (has_mode(run->result[i].method, mode))
                blocks[i][mode] = blocks_of(&run->result[i], mode, &timed[run->result[i].method->question]);
    for (size_t round = 0; round < rounds; round++)
        for (int mode = 0; mode < BENCH_MODES; mode++)
            for (int i = 0; i < run->count; i++)
                if (has_mode(run->result[i].method, mode))
                    ns[i][mode][round] = time_blocks(&run->result[i], mode, &timed[run->result[i].method->question],
                                                     blocks[i][mode], REPEATS);
    for (int i = 0; i < run->count; i++)
        for (int mode = 0; mode < BENCH_MODES; mode++)
            if (has_mode(run->result[i].method, mode))
                take_times(&run->result[i], mode, rounds, ns[i][mode]);
    for (int i = 0; i < run->count; i++)
        for (int mode = 0; mode < BENCH_MODES; mode++)
            if (has_mode(run->result[i].method, mode)) {
                const int newton = newton_of(run, i, mode);
                take_noise(&run->result[i], mode, rounds, ns[i][mode], ns[newton][mode]);
                run->result[i].ratio[mode] = run->result[newton].ns[mode] / run->result[i].ns[mode];
            }
    free(blocks);
    free(ns);
}

static void add_result(struct bench_run *run, const struct bench_method *m, const struct scene *scene,
                       const struct sample_set *training, const struct timed *timed)
{
    struct bench_result *r = &run->result[run->count++];
    r->method = m;
    r->kind = scene->segment;
    bench_tune(m, scene, training, &r->tuning);
    r->ops = counts_of(r, timed);
    for (int mode = 0; mode < BENCH_MODES; mode++)
        measure_errors(r, mode, &run->cases[m->question]);
}

struct bench_run bench_measure(const struct bench_table *table, const struct scene *scene,
                               const struct sample_set *training, const struct sample_set *set, size_t rounds)
{
    struct bench_run run = {.count = 0};
    struct timed timed[BENCH_QUESTIONS] = {{NULL, NULL}};
    bool asked[BENCH_QUESTIONS];
    size_t most = 0;
    find_asked(table, scene, asked);
    for (int q = 0; q < BENCH_QUESTIONS; q++)
        if (asked[q]) {
            run.cases[q] = bench_cases_new(scene, (enum bench_question)q, set, most_cases[q]);
            timed[q] = timed_new(&run.cases[q]);
        }
    for (int l = 0; l < BENCH_LISTS; l++)
        most += (size_t)table->list[l]->count;
    run.result = new_array(most, sizeof *run.result);
    for (int l = 0; l < BENCH_LISTS; l++)
        for (int i = 0; i < table->list[l]->count; i++) {
            const struct bench_method *m = &table->list[l]->method[i];
            if (runs_on(m, scene, asked))
                add_result(&run, m, scene, training, &timed[m->question]);
        }
    measure_times(&run, timed, rounds);
    for (int q = 0; q < BENCH_QUESTIONS; q++)
        timed_free(&timed[q]);
    return run;
}

void bench_run_free(struct bench_run *run)
{
    for (int q = 0; q < BENCH_QUESTIONS; q++)
        bench_cases_free(&run->cases[q]);
    free(run->result);
}
