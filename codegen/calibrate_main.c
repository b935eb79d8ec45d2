/* footpoint-calibrate: measures the costs of operations on this machine and writes a cost file (cost.h).
 *
 * Each operation runs in a loop, in double and in float: STEPS times on each of LENGTH numbers, which stay in the first
 * cache and are independent, so that the compiler vectorises. All loops alternate, ROUNDS times. A cost is the median
 * over the rounds of a loop's time over the time of additions in the same round, so that other activity of the machine
 * affects both. */
#include "base/options.h"
#include "base/outfile.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { LENGTH = 480, STEPS = 4, PASSES = 50, ROUNDS = 801, FEWEST_ROUNDS = 5 };
#define MOST_SECONDS 1.5 /* no round begins after that */

#ifdef __clang__
#define COMPILER __VERSION__
#else
#define COMPILER "gcc " __VERSION__
#endif
#if defined __AVX512F__
#define MACHINE " for AVX-512"
#elif defined __AVX__
#define MACHINE " for AVX"
#elif defined __SSE2__
#define MACHINE " for SSE2"
#else
#define MACHINE ""
#endif

enum precision { DOUBLE, FLOAT, PRECISIONS };
enum operation { MUL, ADD, DIV, SQRT, COMPARE, OPERATIONS };
static const char *const precision_name[PRECISIONS] = {"double", "float"};
static const char *const operation_name[OPERATIONS] = {"mul", "add", "div", "sqrt", "compare"};

/* Second operands. Each step undoes the previous one, so that values stay in the usual range. Minima take theirs from
 * arrays: if they were fixed, compilers would find a shorter form. */
static const double operand[OPERATIONS][2] = {
    [MUL] = {1.37, 1 / 1.37}, [ADD] = {1.37, -1.37}, [DIV] = {1.37, 1 / 1.37}, [SQRT] = {1.37, 1.37}};

#define INLINE static inline __attribute__((always_inline))

/* The loops of a precision. At each call the operation is constant, so a single expression remains. */
#define DEFINE_LOOPS(real, root)                                                                                       \
    struct numbers_##real {                                                                                            \
        real x[LENGTH], y[LENGTH], least[STEPS][LENGTH], operand[2];                                                   \
    };                                                                                                                 \
    INLINE real step_##real(enum operation o, real t, real b)                                                          \
    {                                                                                                                  \
        return o == MUL ? t * b : o == ADD ? t + b : o == DIV ? t / b : o == SQRT ? root(t) : t < b ? t : b;           \
    }                                                                                                                  \
    INLINE void throughput_##real(enum operation o, struct numbers_##real *n)                                          \
    {                                                                                                                  \
        const real b = n->operand[0], c = n->operand[1];                                                               \
        _Pragma("omp simd") for (int i = 0; i < LENGTH; i++)                                                           \
        {                                                                                                              \
            real t = n->x[i];                                                                                          \
            for (int k = 0; k < STEPS; k++)                                                                            \
                t = step_##real(o, t, o == COMPARE ? n->least[k][i] : k % 2 ? c : b);                                  \
            n->y[i] = t;                                                                                               \
        }                                                                                                              \
    }                                                                                                                  \
    INLINE void loop_##real(enum operation o, struct numbers_##real *n)                                                \
    {                                                                                                                  \
        for (int pass = 0; pass < PASSES; pass++) {                                                                    \
            throughput_##real(o, n);                                                                                   \
            __asm__ volatile("" : : "r"(n) : "memory"); /* pretends that all of *n is read and written here */         \
        }                                                                                                              \
    }                                                                                                                  \
    static void run_##real(enum operation o, struct numbers_##real *n)                                                 \
    {                                                                                                                  \
        switch (o) {                                                                                                   \
        case MUL:                                                                                                      \
            loop_##real(MUL, n);                                                                                       \
            break;                                                                                                     \
        case ADD:                                                                                                      \
            loop_##real(ADD, n);                                                                                       \
            break;                                                                                                     \
        case DIV:                                                                                                      \
            loop_##real(DIV, n);                                                                                       \
            break;                                                                                                     \
        case SQRT:                                                                                                     \
            loop_##real(SQRT, n);                                                                                      \
            break;                                                                                                     \
        default:                                                                                                       \
            loop_##real(COMPARE, n);                                                                                   \
        }                                                                                                              \
    }                                                                                                                  \
    static double seconds_##real(enum operation o)                                                                     \
    {                                                                                                                  \
        static struct numbers_##real n;                                                                                \
        n.operand[0] = (real)operand[o][0];                                                                            \
        n.operand[1] = (real)operand[o][1];                                                                            \
        for (int i = 0; i < LENGTH; i++) {                                                                             \
            n.x[i] = (real)(1 + (i * 137 % LENGTH + 0.3) / LENGTH);                                                    \
            for (int k = 0; k < STEPS; k++)                                                                            \
                n.least[k][i] = (real)(1 + (i * (139 + 4 * k) % LENGTH + 0.3) / LENGTH);                               \
        }                                                                                                              \
        const double start = now();                                                                                    \
        run_##real(o, &n);                                                                                             \
        return fmax(now() - start, 1e-9);                                                                              \
    }

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

DEFINE_LOOPS(double, sqrt)
DEFINE_LOOPS(float, sqrtf)

/* Costs in units of an addition of the same precision. */
struct costs {
    double of[PRECISIONS][OPERATIONS];
};

static struct costs run_round(void)
{
    struct costs costs;
    for (int p = 0; p < PRECISIONS; p++) {
        double *c = costs.of[p];
        for (int o = 0; o < OPERATIONS; o++)
            c[o] = (p == DOUBLE ? seconds_double : seconds_float)((enum operation)o);
        const double unit = c[ADD];
        for (int o = 0; o < OPERATIONS; o++)
            c[o] /= unit;
    }
    return costs;
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static struct costs measure(void)
{
    static struct costs round[ROUNDS];
    static double sorted[ROUNDS];
    struct costs median;
    size_t rounds = 0;
    for (const double start = now(); rounds < ROUNDS && (rounds < FEWEST_ROUNDS || now() - start < MOST_SECONDS);)
        round[rounds++] = run_round();
    for (int p = 0; p < PRECISIONS; p++)
        for (int o = 0; o < OPERATIONS; o++) {
            for (size_t i = 0; i < rounds; i++)
                sorted[i] = round[i].of[p][o];
            qsort(sorted, rounds, sizeof *sorted, compare_doubles);
            median.of[p][o] = sorted[rounds / 2];
        }
    return median;
}

static void print_costs(const struct costs *c, FILE *stream)
{
    fputs("footpoint-costs 1\n"
          "# Measured by footpoint-calibrate " FOOTPOINT_VERSION " as compiled by " COMPILER MACHINE ".\n"
          "# Unit: an addition of the same row; medians of interleaved rounds.\n"
          "#       ",
          stream);
    for (int o = 0; o < OPERATIONS; o++)
        fprintf(stream, " %7s", operation_name[o]);
    for (int p = 0; p < PRECISIONS; p++) {
        fprintf(stream, "\n# %-6s", precision_name[p]);
        for (int o = 0; o < OPERATIONS; o++)
            fprintf(stream, " %7.2f", c->of[p][o]);
    }
    fputc('\n', stream);
    for (int o = 0; o < OPERATIONS; o++)
        fprintf(stream, "%s %.2f\n", operation_name[o], c->of[DOUBLE][o]);
}

static bool write_costs(const struct costs *c, const char *path, struct diag *d)
{
    struct outfile out;
    if (!path) {
        print_costs(c, stdout);
        return true;
    }
    if (!outfile_open(&out, path, d))
        return false;
    print_costs(c, out.stream);
    return outfile_commit(&out, d);
}

struct calibrate_options {
    const char *output; /* NULL: standard output */
};

#define AT(member) offsetof(struct calibrate_options, member)
static const struct option_row rows[] = {
    {"output", 'o', OPTION_TEXT, AT(output), "FILE", .help = "file to write (default: standard output)"}};
static const struct option_table table = {
    .program = "footpoint-calibrate",
    .usage = "usage: footpoint-calibrate [-o FILE]\nMeasures the costs of operations on this machine, in about a "
             "second, and writes a cost file for footpoint-codegen.\n",
    .notes = "Exit status: 0 done, 2 usage, 3 I/O.\n",
    .row = rows,
    .rows = sizeof rows / sizeof *rows,
    .unknown = "unknown option or missing value: %s (try --help)",
    .lacking = "unknown option or missing value: %s (try --help)",
    .surplus = "unexpected argument: %s (try --help)"};

int main(int argc, char **argv)
{
    struct calibrate_options o = {0};
    struct diag d;
    const enum options_outcome outcome = options_read(&table, argc, argv, &o, NULL, &d);
    if (outcome != OPTIONS_READ)
        return options_end(&table, outcome, &d);
    const struct costs costs = measure();
    return exit_status(write_costs(&costs, o.output, &d), &d);
}
