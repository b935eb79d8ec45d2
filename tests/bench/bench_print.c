/* See bench_print.h. */
#include "bench_print.h"

#include "../../codegen/genome/base.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef __clang__
#define COMPILER "clang " __clang_version__
#else
#define COMPILER "gcc " __VERSION__
#endif

/* Once, before the first row: a scene that cannot be read leaves nothing on standard output. */
static bool is_first(void)
{
    static bool done;
    const bool first = !done;
    done = true;
    return first;
}

static bool has_mode(const struct bench_result *r, int mode)
{
    return mode != BENCH_BATCH || r->method->batch;
}

/* ---- everything ---- */

void bench_print_csv(const struct scene *scene, const char *sample, const struct bench_table *table,
                     const struct bench_run *run)
{
    if (is_first())
        puts("scene,sample,method,ours,mode,mul,div,add,sqrt,ns,ratio,mean_xi,p99_xi,max_xi,mean_eta,p99_eta,max_eta,"
             "failures,mean_gap,p99_gap,max_gap,ns_min,noise,isa,compiler");
    for (const struct bench_result *r = run->result; r < run->result + run->count; r++)
        for (int mode = 0; mode < BENCH_MODES; mode++)
            if (has_mode(r, mode))
                printf("%s,%s,%s,%d,%s,%ld,%ld,%ld,%ld,%.2f,%.2f,%.3e,%.3e,%.3e,%.3e,%.3e,%.3e,%zu,%.3e,%.3e,%.3e,%.2f,"
                       "%.4f,%s,%s\n",
                       scene->name, sample, r->method->name, r->method->ours, bench_mode_name[mode], r->ops.mul,
                       r->ops.div, r->ops.add, r->ops.sqrt, r->ns[mode], r->ratio[mode], r->xi.mean, r->xi.p99,
                       r->xi.max, r->eta.mean, r->eta.p99, r->eta.max, r->xi.failures, r->gap.mean, r->gap.p99,
                       r->gap.max, r->ns_min[mode], r->noise[mode], table->isa, COMPILER);
}

static void print_head(const struct bench_table *table)
{
    printf("footpoint-bench " FOOTPOINT_VERSION ", all methods compiled by " COMPILER " %s\n", table->flags);
}

void bench_print_all(const struct scene *scene, const char *sample, const struct bench_table *table,
                     const struct bench_run *run)
{
    if (is_first()) {
        print_head(table);
        puts(
            "*: ours; ns: of one search, least and median; ratio: converged Newton's median in the same mode over this "
            "one's;\nnoise: per cent, half of the interquartile range of the ratio over the rounds; gap: over the "
            "square root of the segment's area;\npinball finds no xi, eta: --contact\n");
        printf("%-14s %-6s   %-34s %-6s %4s %3s %4s %4s %7s %7s %6s %5s %8s %8s %8s %8s %8s %8s %8s %8s %8s %8s\n",
               "scene", "sample", "method", "mode", "mul", "div", "add", "sqrt", "ns_min", "ns", "ratio", "noise",
               "mean_xi", "p99_xi", "max_xi", "mean_eta", "p99_eta", "max_eta", "mean_gap", "p99_gap", "max_gap",
               "failures");
    }
    for (const struct bench_result *r = run->result; r < run->result + run->count; r++)
        for (int mode = 0; mode < BENCH_MODES; mode++)
            if (has_mode(r, mode))
                printf("%-14s %-6s %c %-34s %-6s %4ld %3ld %4ld %4ld %7.2f %7.2f %6.2f %5.1f %8.1e %8.1e %8.1e %8.1e "
                       "%8.1e %8.1e %8.1e %8.1e %8.1e %8zu\n",
                       scene->name, sample, r->method->ours ? '*' : ' ', r->method->name, bench_mode_name[mode],
                       r->ops.mul, r->ops.div, r->ops.add, r->ops.sqrt, r->ns_min[mode], r->ns[mode], r->ratio[mode],
                       100 * r->noise[mode], r->xi.mean, r->xi.p99, r->xi.max, r->eta.mean, r->eta.p99, r->eta.max,
                       r->gap.mean, r->gap.p99, r->gap.max, r->xi.failures);
}

/* ---- the front ---- */

static double mean_of(const struct bench_result *r)
{
    return fmax(r->xi.mean, r->eta.mean);
}

static bool is_answer(const struct bench_result *r)
{
    return !r->method->depth_only && r->xi.failures == 0 && r->eta.failures == 0 && mean_of(r) < 1;
}

/* Whether no other method leaves r behind in one of the modes. */
static bool is_on_front(const struct bench_run *run, const struct bench_result *r, int mode)
{
    if (!is_answer(r) || !has_mode(r, mode))
        return false;
    for (const struct bench_result *q = run->result; q < run->result + run->count; q++)
        if (is_answer(q) && has_mode(q, mode) && q->ns[mode] <= r->ns[mode] && mean_of(q) <= mean_of(r) &&
            (q->ns[mode] < r->ns[mode] || mean_of(q) < mean_of(r)))
            return false;
    return true;
}

static int by_error(const void *a, const void *b)
{
    const double x = mean_of(*(const struct bench_result *const *)a),
                 y = mean_of(*(const struct bench_result *const *)b);
    return (x < y) - (x > y);
}

static void print_row(const struct bench_result *r)
{
    printf("%c %-34s %4ld %3ld %4ld %4ld %8.1f", r->method->ours ? '*' : ' ', r->method->name, r->ops.mul, r->ops.div,
           r->ops.add, r->ops.sqrt, r->ns[BENCH_SCALAR]);
    if (has_mode(r, BENCH_BATCH))
        printf(" %8.2f", r->ns[BENCH_BATCH]);
    else
        printf(" %8s", "-");
    printf(" %8.1f %8.1e %8.1e %8.1e\n", r->ratio[BENCH_SCALAR], mean_of(r), fmax(r->xi.p99, r->eta.p99),
           fmax(r->xi.max, r->eta.max));
}

void bench_print_front(const struct scene *scene, const struct bench_table *table, const struct bench_run *run)
{
    const struct bench_result **const front = calloc((size_t)run->count, sizeof *front);
    size_t n = 0;
    if (is_first()) {
        print_head(table);
        puts("*: ours; ns: of one search, one at a time and over arrays; faster: converged Newton's time over this "
             "one's, "
             "one at a time;\nerror: the larger of those of xi and eta");
    }
    for (const struct bench_result *r = run->result; front && r < run->result + run->count; r++)
        if (r == run->result || is_on_front(run, r, BENCH_SCALAR) || is_on_front(run, r, BENCH_BATCH))
            front[n++] = r;
    if (front)
        qsort(front, n, sizeof *front, by_error);
    printf("\n%s: the front of %d methods, all others with --all\n  %-34s %4s %3s %4s %4s %8s %8s %8s %8s %8s %8s\n",
           scene->name, run->count, "method", "mul", "div", "add", "sqrt", "ns", "arrays", "faster", "mean", "99 %",
           "worst");
    for (size_t i = 0; i < n; i++)
        print_row(front[i]);
    free(front);
}
