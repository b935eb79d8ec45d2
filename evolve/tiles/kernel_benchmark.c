/* Measures the evaluator's speed for every register width. */
#include "kernel_benchmark.h"

#include "../common/stream.h"
#include "../genotype/tree.h"
#include "kernel.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SAMPLES = 28672, VARIABLES = 8, GENOMES = 64, LONGEST = 250, ROUNDS = 7 };

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
    struct genome_file *program;
    struct genes tree[GENOMES];
    int gene[GENOMES][LONGEST];
    size_t genes;
};

static double kernel_sum(const struct workload *w, const struct genes *t, struct kernel *k)
{
    const struct kernel_task task = {t->gene, t->length, w->program->constant, &w->table};
    return kernel_error_sum(k, &task, VARIABLES, INFINITY);
}

/* Makes random genomes with finite values, so that evaluation never stops early. */
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
    for (size_t i = 0; i < GENOMES; i++) {
        struct genes *t = &w->tree[i];
        t->gene = w->gene[i];
        do
            tree_random(rng, &genes, 16, false, kind->longest, t);
        while (t->length < kind->shortest || !isfinite(kernel_sum(w, t, k)));
        w->genes += t->length;
    }
    gsl_rng_free(rng);
}

/* Returns processor time in seconds, which excludes other processes. */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Returns the seconds that all genomes take. */
static double lap(const struct workload *w, struct kernel *k)
{
    volatile double sink;
    const double start = now();
    for (size_t i = 0; i < GENOMES; i++)
        sink = kernel_sum(w, &w->tree[i], k);
    (void)sink;
    return now() - start;
}

static void race(struct kernel *const kernel[KERNEL_WIDTHS], const struct kind *kind, FILE *stream)
{
    static struct workload w;
    double best[KERNEL_WIDTHS];
    fill(&w, kernel[KERNEL_PLAIN], kind);
    for (int round = 0; round < ROUNDS; round++)
        for (int i = 0; i < KERNEL_WIDTHS; i++)
            if (kernel[i])
                best[i] = fmin(round == 0 ? INFINITY : best[i], lap(&w, kernel[i]));
    for (int i = 0; i < KERNEL_WIDTHS; i++)
        if (kernel[i])
            fprintf(stream, "footpoint%s,%d,%.3e\n", kind->name, kernel_bits((enum kernel_width)i),
                    (double)w.genes * SAMPLES / best[i]);
    genome_file_free(w.program);
    columns_free(&w.table);
}

void evolve_benchmark(FILE *stream)
{
    struct kernel *kernel[KERNEL_WIDTHS];
    for (int k = 0; k < KERNEL_WIDTHS; k++)
        kernel[k] = kernel_supports((enum kernel_width)k) ? kernel_new((enum kernel_width)k) : NULL;
    fprintf(stream, "engine,bits,genes_samples_per_s\n");
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        race(kernel, &kinds[i], stream);
    for (int k = 0; k < KERNEL_WIDTHS; k++)
        kernel_free(kernel[k]);
}
