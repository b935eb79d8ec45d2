/* Errors and times; see bench_measure.h.
 *
 * The methods take turns, --rounds times, and the median of a method's turns counts, so that whatever else the machine
 * does falls on all of them alike.  How far the ratio to converged Newton, of the same round, scatters is the noise. */
#include "bench_measure.h"

#include "../../codegen/genome/base.h"
#include "../../evolve/surface/surface.h"
#include "bench_input.h"
#include "bench_tune.h"

#include <gsl/gsl_sort_double.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ERROR_SAMPLES = 600000, TIMED_BLOCKS = 78, TIMED_SAMPLES = TIMED_BLOCKS * BENCH_BLOCK, REPEATS = 4 };

const char *const bench_mode_name[BENCH_MODES] = {"scalar", "batch"};

/* The samples that are timed, as structures and by columns. */
struct timed {
    struct bench_input *in; /* owned; TIMED_SAMPLES */
    struct bench_block *b;  /* TIMED_BLOCKS */
};

/* Sample i of `count` spread evenly over the set; the set is repeated if it is smaller. */
static const struct sample *spread(const struct sample_set *set, size_t i, size_t count)
{
    return &set->s[set->n < count ? i % set->n : i * set->n / count];
}

static struct timed timed_new(const struct segment_kind *kind, const struct sample_set *set)
{
    static struct bench_block blocks[TIMED_BLOCKS];
    struct timed t = {new_array(TIMED_SAMPLES, sizeof *t.in), blocks};
    for (size_t i = 0; i < TIMED_SAMPLES; i++) {
        struct bench_block *b = &t.b[i / BENCH_BLOCK];
        t.in[i] = bench_input_of(kind, spread(set, i, TIMED_SAMPLES), i);
        for (size_t k = 0; k < segment_inputs(kind); k++)
            b->x[k][i % BENCH_BLOCK] = t.in[i].x[k / 3][k % 3];
        for (size_t k = 0; k < 2; k++)
            b->before[k][i % BENCH_BLOCK] = t.in[i].before[k];
    }
    return t;
}

/* Of processor time: others' turns on the processor do not count. */
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Nanoseconds per search.  A block is searched several times while it is in the cache. */
static double time_turn(const struct bench_result *r, int mode, struct timed *t)
{
    double found[BENCH_BLOCK][2];
    const double start = seconds();
    for (size_t k = 0; k < TIMED_BLOCKS; k++)
        for (int repeat = 0; repeat < REPEATS; repeat++)
            if (mode == BENCH_BATCH)
                r->method->batch(&t->b[k], &r->tuning);
            else
                r->method->scalar(&t->in[k * BENCH_BLOCK], BENCH_BLOCK, &r->tuning, found);
    return 1e9 * (seconds() - start) / (REPEATS * (double)TIMED_SAMPLES);
}

void bench_find(const struct bench_result *r, const struct sample *const *s, size_t n, double (*found)[2])
{
    struct bench_input in[BENCH_BLOCK];
    for (size_t first = 0; first < n; first += BENCH_BLOCK) {
        const size_t count = n - first < BENCH_BLOCK ? n - first : BENCH_BLOCK;
        for (size_t i = 0; i < count; i++)
            in[i] = bench_input_of(r->kind, s[first + i], first + i);
        r->method->scalar(in, count, &r->tuning, found + first);
    }
    for (size_t i = 0; i < n; i++)
        if (!(fabs(found[i][0]) < BENCH_NO_ANSWER && fabs(found[i][1]) < BENCH_NO_ANSWER))
            found[i][0] = found[i][1] = (double)NAN;
}

/* Of other kinds; the area is that of the parallelogram which the middle spans. */
static double gap_error_of(const struct segment_kind *kind, const struct sample *s, const double at[2])
{
    const struct surface *f = surface_find(kind);
    const double middle = kind->triangle ? 1.0 / 3 : 0;
    double x[SEGMENT_VECTORS][3], r[3], n[3], at_middle[3][3], sum = 0;
    memcpy(x, s->x, sizeof x);
    f->point(f, x, middle, middle, at_middle);
    const double uv = rival_dot(at_middle[1], at_middle[2]);
    const double area = sqrt(rival_dot(at_middle[1], at_middle[1]) * rival_dot(at_middle[2], at_middle[2]) - uv * uv);
    if (!surface_normal(f, x, at[0], at[1], r, n))
        return (double)NAN;
    for (int k = 0; k < 3; k++)
        sum += (s->xs[k] - r[k]) * n[k];
    return fabs(sum - s->gap) / sqrt(area * (kind->triangle ? 0.5 : 4));
}

/* Error of the gap (9) at (xi, eta), over the square root of the segment's area. */
static double gap_error(const struct segment_kind *kind, const struct sample *s, const double at[2])
{
    if (!kind->bilinear)
        return gap_error_of(kind, s, at);
    double u[3], v[3], d[3], ac[3], bd[3], n[3], m[3];
    for (int i = 0; i < 3; i++) {
        const double a = s->x[0][i], b = s->x[1][i], c = s->x[2][i], e = s->x[3][i];
        u[i] = (1 - at[1]) * (b - a) + (1 + at[1]) * (c - e);
        v[i] = (1 - at[0]) * (e - a) + (1 + at[0]) * (c - b);
        d[i] = s->xs[i] - 0.25 * ((1 - at[1]) * ((1 - at[0]) * a + (1 + at[0]) * b) +
                                  (1 + at[1]) * ((1 - at[0]) * e + (1 + at[0]) * c));
        ac[i] = c - a;
        bd[i] = e - b;
    }
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = u[j] * v[k] - u[k] * v[j];
        m[i] = ac[j] * bd[k] - ac[k] * bd[j];
    }
    const double gap = rival_dot(d, n) / sqrt(rival_dot(n, n));
    return fabs(gap - s->gap) / sqrt(0.5 * sqrt(rival_dot(m, m)));
}

static void measure_errors(struct bench_result *r, const struct sample *const *s, size_t n)
{
    if (r->method->depth_only) {
        r->xi = r->eta = r->gap = (struct error_stats){(double)NAN, (double)NAN, (double)NAN, 0};
        return;
    }
    double(*found)[2] = new_array(n, sizeof *found), *error[3];
    for (int k = 0; k < 3; k++)
        error[k] = new_array(n, sizeof *error[k]);
    bench_find(r, s, n, found);
    for (size_t i = 0; i < n; i++) {
        error[0][i] = fabs(found[i][0] - s[i]->xi);
        error[1][i] = fabs(found[i][1] - s[i]->eta);
        error[2][i] = gap_error(r->kind, s[i], found[i]);
    }
    r->xi = error_stats_of(error[0], n);
    r->eta = error_stats_of(error[1], n);
    r->gap = error_stats_of(error[2], n);
    for (int k = 0; k < 3; k++)
        free(error[k]);
    free(found);
}

/* Operations of a search: of an iteration its first step, and the later ones as often as they are taken on average. */
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

/* A generated function is for its scene; a search that starts in A's quarter, for scenes where A is the nearest corner.
 */
static bool runs_on(const struct bench_method *m, const struct scene *scene)
{
    if (strcmp(m->kind, scene->segment->name) != 0)
        return false;
    if (m->scene)
        return strcmp(m->scene, scene->name) == 0;
    return m->start == RIVAL_CENTRE || scene->order != CORNERS_ANY;
}

/* From the times of the turns, in order of the rounds. */
static void take_times(struct bench_result *r, int mode, size_t rounds, double *ns, const double *newton)
{
    double ratio[BENCH_ROUNDS];
    for (size_t i = 0; i < rounds; i++)
        ratio[i] = newton[i] / ns[i];
    gsl_sort(ratio, 1, rounds);
    r->noise[mode] = 0.5 *
                     (gsl_stats_quantile_from_sorted_data(ratio, 1, rounds, 0.75) -
                      gsl_stats_quantile_from_sorted_data(ratio, 1, rounds, 0.25)) /
                     gsl_stats_median_from_sorted_data(ratio, 1, rounds);
    gsl_sort(ns, 1, rounds);
    r->ns[mode] = ns[rounds / 2];
    r->ns_min[mode] = ns[0];
}

static void measure_times(struct bench_run *run, struct timed *t, size_t rounds)
{
    double(*ns)[BENCH_MODES][BENCH_ROUNDS] = new_array((size_t)run->count, sizeof *ns);
    double newton[BENCH_MODES][BENCH_ROUNDS];
    for (size_t round = 0; round < rounds; round++)
        for (int mode = 0; mode < BENCH_MODES; mode++)
            for (int i = 0; i < run->count; i++)
                if (mode == BENCH_SCALAR || run->result[i].method->batch)
                    ns[i][mode][round] = time_turn(&run->result[i], mode, t);
    memcpy(newton, ns[0], sizeof newton);
    for (int i = 0; i < run->count; i++)
        for (int mode = 0; mode < BENCH_MODES; mode++) {
            struct bench_result *r = &run->result[i];
            if (mode == BENCH_SCALAR || r->method->batch)
                take_times(r, mode, rounds, ns[i][mode], newton[mode]);
            r->ratio[mode] = run->result[0].ns[mode] / r->ns[mode];
        }
    free(ns);
}

struct bench_run bench_measure(const struct bench_table *table, const struct scene *scene,
                               const struct sample_set *training, const struct sample_set *set, size_t rounds)
{
    const size_t n = set->n < ERROR_SAMPLES ? set->n : ERROR_SAMPLES;
    struct bench_run run = {new_array((size_t)table->count, sizeof *run.result), 0};
    const struct sample **s = new_array(n, sizeof *s);
    struct timed timed = timed_new(scene->segment, set);
    for (size_t i = 0; i < n; i++)
        s[i] = spread(set, i, n);
    for (int i = 0; i < table->count; i++)
        if (runs_on(&table->method[i], scene)) {
            struct bench_result *r = &run.result[run.count++];
            r->method = &table->method[i];
            r->kind = scene->segment;
            bench_tune(r->method, scene, training, &r->tuning);
            r->ops = counts_of(r, &timed);
            measure_errors(r, s, n);
        }
    measure_times(&run, &timed, rounds);
    free(timed.in);
    free(s);
    return run;
}

void bench_run_free(struct bench_run *run)
{
    free(run->result);
}
