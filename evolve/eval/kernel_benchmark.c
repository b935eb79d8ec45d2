/* The evaluator against a plain interpreter, which copies every leaf to its stack and computes gene by gene, block by
 * block.  Both are built for every width of registers. */
#include "kernel_benchmark.h"

#include "../common/stream.h"
#include "../genotype/tree.h"
#include "kernel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SAMPLES = 28672, VARIABLES = 8, GENOMES = 64, LONGEST = 250, ROUNDS = 7, BLOCK = 256 };

static const struct kind {
    const char *name;
    size_t operations, shortest, longest;
} kinds[] = {
    {"", 3, 50, LONGEST},
    {"-rational", 4, 50, LONGEST},
    {"-short", 3, 15, 15},
};

struct workload {
    struct columns table; /* VARIABLES columns and the target */
    struct columns_float single;
    struct genome_file *program;
    struct tree tree[GENOMES];
    int gene[GENOMES][LONGEST];
    size_t genes;
};

#define REAL double
#define INTERPRETER interpret_double
#include "kernel_benchmark_interpreter.h"
#define REAL float
#define INTERPRETER interpret_float
#include "kernel_benchmark_interpreter.h"

#define INTERPRET(name, target)                                                                                        \
    target static double name(const struct workload *w, const struct tree *t, bool single)                             \
    {                                                                                                                  \
        return single ? interpret_float(t, w->single.data, w->single.room, w->program->constant)                       \
                      : interpret_double(t, w->table.data, w->table.room, w->program->constant);                       \
    }
INTERPRET(interpret_plain, )
#if defined __x86_64__
INTERPRET(interpret_256, __attribute__((target("avx2,fma,bmi2"))))
#if defined __clang__
INTERPRET(interpret_512, __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"))))
#else
INTERPRET(interpret_512, __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl,prefer-vector-width=512"))))
#endif
#endif

static double interpreter_sum(const struct workload *w, const struct tree *t, enum kernel_width width, bool single)
{
    switch (width) {
#if defined __x86_64__
    case KERNEL_512:
        return interpret_512(w, t, single);
    case KERNEL_256:
        return interpret_256(w, t, single);
#endif
    default:
        return interpret_plain(w, t, single);
    }
}

static double kernel_sum(const struct workload *w, const struct tree *t, struct kernel *k, bool single)
{
    const struct kernel_task task = {t->gene, t->length, w->program->constant, &w->table};
    return single ? kernel_error_sum_float(k, &task, &w->single, VARIABLES, INFINITY)
                  : kernel_error_sum(k, &task, VARIABLES, INFINITY);
}

/* Random genomes whose values are finite, so that every engine evaluates them to the end. */
static void fill(struct workload *w, struct kernel *k, const struct kind *kind)
{
    static int symbol[VARIABLES], constant[4], operation[] = {GENE_ADD, GENE_SUB, GENE_MUL, GENE_PDIV};
    static const char *const text[] = {"-0.35", "0.5", "1.25", "2"};
    const struct gene_set genes = {symbol, VARIABLES, constant, 4, operation, kind->operations, 0};
    gsl_rng *rng = stream_new();
    stream_key(rng, 0, 0, 0, 0);
    *w = (struct workload){.table = columns_new(SAMPLES, VARIABLES + 1), .program = genome_file_new("benchmark")};
    for (int i = 0; i < VARIABLES; i++)
        symbol[i] = GENE_SYMBOL + i;
    for (int i = 0; i < 4; i++)
        constant[i] = -1 - (int)genome_add_constant(w->program, text[i]);
    for (size_t j = 0; j <= VARIABLES; j++)
        for (size_t i = 0; i < SAMPLES; i++)
            columns_at(&w->table, j)[i] = 2 * gsl_rng_uniform(rng) - 1;
    w->single = columns_float_new(&w->table);
    for (size_t i = 0; i < GENOMES; i++) {
        struct tree *t = &w->tree[i];
        t->gene = w->gene[i];
        do
            tree_random(rng, &genes, 16, false, kind->longest, t);
        while (t->length < kind->shortest || !isfinite(kernel_sum(w, t, k, true)));
        w->genes += t->length;
    }
    gsl_rng_free(rng);
}

/* Processor time in seconds: other processes of the machine count for nothing. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds for all genomes, with the kernel, or the interpreter of that width if `k` is NULL. */
static double lap(const struct workload *w, struct kernel *k, enum kernel_width width, bool single)
{
    volatile double sink;
    const double start = now();
    for (size_t i = 0; i < GENOMES; i++)
        sink = k ? kernel_sum(w, &w->tree[i], k, single) : interpreter_sum(w, &w->tree[i], width, single);
    (void)sink;
    return now() - start;
}

static void race(struct kernel *const kernel[KERNEL_WIDTHS], const struct kind *kind, FILE *stream)
{
    static struct workload w;
    double best[2][2][KERNEL_WIDTHS]; /* by engine, precision and width */
    fill(&w, kernel[KERNEL_PLAIN], kind);
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < 4 * KERNEL_WIDTHS; i++) {
            const int engine = i / 2 % 2, single = i % 2, width = i / 4;
            double *b = &best[engine][single][width];
            if (kernel[width])
                *b = fmin(round == 0 ? INFINITY : *b,
                          lap(&w, engine == 0 ? NULL : kernel[width], (enum kernel_width)width, single == 1));
        }
    for (int i = 0; i < 4 * KERNEL_WIDTHS; i++) {
        const int engine = i / (2 * KERNEL_WIDTHS), single = i / KERNEL_WIDTHS % 2, width = i % KERNEL_WIDTHS;
        if (kernel[width])
            fprintf(stream, "%s%s,%s,%d,%.3e\n", engine == 0 ? "interpreter" : "footpoint", kind->name,
                    single ? "float" : "double", kernel_bits((enum kernel_width)width),
                    (double)w.genes * SAMPLES / best[engine][single][width]);
    }
    genome_file_free(w.program);
    columns_float_free(&w.single);
    columns_free(&w.table);
}

void evolve_benchmark(FILE *stream)
{
    struct kernel *kernel[KERNEL_WIDTHS];
    for (int k = 0; k < KERNEL_WIDTHS; k++)
        kernel[k] = kernel_supports((enum kernel_width)k) ? kernel_new((enum kernel_width)k) : NULL;
    fprintf(stream, "engine,precision,bits,genes_samples_per_s\n");
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        race(kernel, &kinds[i], stream);
    for (int k = 0; k < KERNEL_WIDTHS; k++)
        kernel_free(kernel[k]);
}
