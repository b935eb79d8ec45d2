/* Prints the bench's results; see bench_print.h. */
#include "bench_print.h"

#include "../../codegen/base/base.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifdef __clang__
#define COMPILER "clang " __clang_version__
#else
#define COMPILER "gcc " __VERSION__
#endif

/* Returns true once, before the first row, so that a scene that cannot be read leaves standard output empty. */
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
             "failures,mean_gap,p99_gap,max_gap,ns_min,noise,question,isa,compiler");
    for (const struct bench_result *r = run->result; r < run->result + run->count; r++)
        for (int mode = 0; mode < BENCH_MODES; mode++) {
            const struct error_stats *const e = r->error[mode];
            if (has_mode(r, mode))
                printf("%s,%s,%s,%d,%s,%ld,%ld,%ld,%ld,%.2f,%.2f,%.3e,%.3e,%.3e,%.3e,%.3e,%.3e,%zu,%.3e,%.3e,%.3e,%.2f,"
                       "%.4f,%s,%s,%s\n",
                       scene->name, sample, r->method->name, r->method->ours, bench_mode_name[mode], r->ops.mul,
                       r->ops.div, r->ops.add, r->ops.sqrt, r->ns[mode], r->ratio[mode], e[0].mean, e[0].p99, e[0].max,
                       e[1].mean, e[1].p99, e[1].max, e[0].failures, e[2].mean, e[2].p99, e[2].max, r->ns_min[mode],
                       r->noise[mode], bench_question_name[r->method->question], table->isa, COMPILER);
        }
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
        puts("*: ours; operations: 0 where they are not counted; mode: chain (dependent calls), scalar (independent "
             "calls), batch (arrays);\nns: of one search, least and median; ratio: the median of Newton, converged or "
             "fair, the quicker, asked the same, in the same mode\nover this one's; noise: per cent, half of the "
             "interquartile range of the ratio over the rounds; gap: or distance, over the square\nroot of the "
             "segment's area; with derivatives, errors of these; pinball finds no xi, eta: --contact\n");
        printf("%-14s %-6s   %-40s %-6s %4s %3s %4s %4s %7s %7s %6s %5s %8s %8s %8s %8s %8s %8s %8s %8s %8s %8s\n",
               "scene", "sample", "method", "mode", "mul", "div", "add", "sqrt", "ns_min", "ns", "ratio", "noise",
               "mean_xi", "p99_xi", "max_xi", "mean_eta", "p99_eta", "max_eta", "mean_gap", "p99_gap", "max_gap",
               "failures");
    }
    for (const struct bench_result *r = run->result; r < run->result + run->count; r++)
        for (int mode = 0; mode < BENCH_MODES; mode++) {
            const struct error_stats *const e = r->error[mode];
            if (has_mode(r, mode))
                printf("%-14s %-6s %c %-40s %-6s %4ld %3ld %4ld %4ld %7.2f %7.2f %6.2f %5.1f %8.1e %8.1e %8.1e %8.1e "
                       "%8.1e %8.1e %8.1e %8.1e %8.1e %8zu\n",
                       scene->name, sample, r->method->ours ? '*' : ' ', r->method->name, bench_mode_name[mode],
                       r->ops.mul, r->ops.div, r->ops.add, r->ops.sqrt, r->ns_min[mode], r->ns[mode], r->ratio[mode],
                       100 * r->noise[mode], e[0].mean, e[0].p99, e[0].max, e[1].mean, e[1].p99, e[1].max, e[2].mean,
                       e[2].p99, e[2].max, e[0].failures);
        }
}

/* ---- the front ---- */

/* Returns the larger error of xi and eta; for closest points and along a direction, the error of the distance. */
static struct error_stats error_of(const struct bench_result *r, int mode)
{
    const struct error_stats *const e = r->error[mode];
    if (r->method->question == ASK_CLOSEST || r->method->question == ASK_ALONG)
        return e[2];
    return (struct error_stats){fmax(e[0].mean, e[1].mean), fmax(e[0].p99, e[1].p99), fmax(e[0].max, e[1].max),
                                e[0].failures};
}

static bool is_answer(const struct bench_result *r, int mode)
{
    const struct error_stats e = error_of(r, mode);
    return !r->method->depth_only && has_mode(r, mode) && e.failures == 0 && e.mean < 1;
}

/* Returns true if no other method beats r in one of the modes. */
static bool is_on_front(const struct bench_run *run, const struct bench_result *r, int mode)
{
    if (!is_answer(r, mode))
        return false;
    for (const struct bench_result *q = run->result; q < run->result + run->count; q++) {
        const double more = error_of(q, mode).mean - error_of(r, mode).mean;
        if (q->method->question == r->method->question && is_answer(q, mode) && q->ns[mode] <= r->ns[mode] &&
            more <= 0 && (q->ns[mode] < r->ns[mode] || more < 0))
            return false;
    }
    return true;
}

static bool is_on_some_front(const struct bench_run *run, const struct bench_result *r)
{
    bool is = false;
    for (int mode = 0; mode < BENCH_MODES; mode++)
        is = is || is_on_front(run, r, mode);
    return is;
}

static int by_error(const void *a, const void *b)
{
    const double x = error_of(*(const struct bench_result *const *)a, BENCH_SCALAR).mean,
                 y = error_of(*(const struct bench_result *const *)b, BENCH_SCALAR).mean;
    return (x < y) - (x > y);
}

static void print_row(const struct bench_result *r)
{
    const struct error_stats e = error_of(r, BENCH_SCALAR);
    printf("%c %-40s", r->method->ours ? '*' : ' ', r->method->name);
    if (r->method->question == ASK_BARE)
        printf(" %4ld %3ld %4ld %4ld", r->ops.mul, r->ops.div, r->ops.add, r->ops.sqrt);
    printf(" %8.1f %8.1f", r->ns[BENCH_CHAIN], r->ns[BENCH_SCALAR]);
    if (has_mode(r, BENCH_BATCH))
        printf(" %8.2f", r->ns[BENCH_BATCH]);
    else
        printf(" %8s", "-");
    printf(" %8.1f %8.1f", r->ratio[BENCH_CHAIN], r->ratio[BENCH_SCALAR]);
    if (has_mode(r, BENCH_BATCH))
        printf(" %8.1f", r->ratio[BENCH_BATCH]);
    else
        printf(" %8s", "-");
    printf(" %8.1e %8.1e %8.1e", e.mean, e.p99, e.max);
    if (e.failures)
        printf(" %zu refused", e.failures);
    puts("");
}

/* Prints a question's title above its rows, with the number of methods that answer it. */
static void print_question(const struct scene *scene, enum bench_question question, int methods)
{
    static const char *const name[BENCH_QUESTIONS] = {"",
                                                      "checked, with gap",
                                                      "checked, eight slave nodes over each segment",
                                                      "closest point of the closed face",
                                                      "along a direction",
                                                      "with derivatives",
                                                      "checked, from an answer 1e-3 of the face away",
                                                      "checked, from an answer 1e-2 of the face away",
                                                      "checked, from an answer 1e-1 of the face away"};
    if (question == ASK_BARE)
        printf("\n%s: the front of %d methods, all others with --all\n  %-40s %4s %3s %4s %4s", scene->name, methods,
               "method", "mul", "div", "add", "sqrt");
    else
        printf("\n%s, %s\n  %-40s", scene->name, name[question], "method");
    printf(" %8s %8s %8s %8s %8s %8s %8s %8s %8s\n", "chain", "calls", "arrays", "x chain", "x calls", "x arrays",
           "mean", "99 %", "worst");
}

static void print_front_of(const struct scene *scene, const struct bench_run *run, enum bench_question question)
{
    const struct bench_result **const front = calloc((size_t)run->count, sizeof *front), *newton = NULL;
    size_t n = 0;
    int methods = 0;
    for (const struct bench_result *r = run->result; front && r < run->result + run->count; r++)
        if (r->method->question == question) {
            newton = newton ? newton : r;
            methods++;
            if (question != ASK_BARE || r == newton || r->method->fair || is_on_some_front(run, r))
                front[n++] = r;
        }
    if (n > 0) {
        qsort(front, n, sizeof *front, by_error);
        print_question(scene, question, methods);
    }
    for (size_t i = 0; i < n; i++)
        print_row(front[i]);
    free(front);
}

void bench_print_front(const struct scene *scene, const struct bench_table *table, const struct bench_run *run)
{
    if (is_first()) {
        print_head(table);
        puts("*: ours; nanoseconds of one search in dependent calls (chain), in independent calls and over arrays; x: "
             "the "
             "time of Newton, converged\nor fair, the quicker, asked the same, over this one's; error: the larger of "
             "those of xi and eta; of closest points and along a\ndirection that of the distance, over the square root "
             "of the segment's area; of derivatives that of those of xi and eta, over the\ngreatest");
    }
    for (int q = 0; q < BENCH_QUESTIONS; q++)
        print_front_of(scene, run, (enum bench_question)q);
}
