/* Measures the evaluator's speed on random trees. */
#include "tree_benchmark.h"

#include "../common/stream.h"
#include "../genotype/tree.h"
#include "lines_run.h"

#include <math.h>
#include <stdlib.h>
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

static double error_sum(const struct workload *w, const struct genes *t, struct lines_run *r)
{
    return lines_tree_error(r, t->gene, t->length, w->program->constant, VARIABLES, INFINITY);
}

/* Makes random genomes with finite values, so that evaluation never stops early. */
static void fill(struct workload *w, const struct kind *kind)
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
    struct lines_run *r = lines_run_new(NULL, &w->table);
    for (size_t i = 0; i < GENOMES; i++) {
        struct genes *t = &w->tree[i];
        t->gene = w->gene[i];
        do
            tree_random(rng, &genes, 16, false, kind->longest, t);
        while (t->length < kind->shortest || !isfinite(error_sum(w, t, r)));
        w->genes += t->length;
    }
    lines_run_free(r);
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
static double lap(const struct workload *w, struct lines_run *r)
{
    volatile double sink;
    const double start = now();
    for (size_t i = 0; i < GENOMES; i++)
        sink = error_sum(w, &w->tree[i], r);
    (void)sink;
    return now() - start;
}

void evolve_benchmark(FILE *stream)
{
    static struct workload w;
    fprintf(stream, "engine,genes_samples_per_s\n");
    for (const struct kind *k = kinds; k < kinds + sizeof kinds / sizeof *kinds; k++) {
        fill(&w, k);
        struct lines_run *r = lines_run_new(NULL, &w.table);
        double best = INFINITY;
        for (int round = 0; round < ROUNDS; round++)
            best = fmin(best, lap(&w, r));
        fprintf(stream, "footpoint%s,%.3e\n", k->name, (double)w.genes * SAMPLES / best);
        lines_run_free(r);
        genome_file_free(w.program);
        columns_free(&w.table);
    }
}
