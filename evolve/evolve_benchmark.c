/* The evaluator against a plain interpreter, which copies every leaf to its stack and computes gene by gene, block by
 * block. */
#include "evolve_benchmark.h"

#include "kernel.h"
#include "stream.h"
#include "tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SAMPLES = 28672, VARIABLES = 8, GENOMES = 64, SHORTEST = 50, LONGEST = 250, ROUNDS = 5 };

struct workload {
    struct columns table; /* VARIABLES columns and the target */
    struct genome_file *program;
    struct tree tree[GENOMES];
    int gene[GENOMES][LONGEST];
    size_t genes;
};

#define EACH(expression)                                                                                               \
    for (size_t i = 0; i < KERNEL_BLOCK; i++)                                                                          \
    y[i] = (expression)

static double plain_error_sum(const struct workload *w, const struct tree *t, double (*stack)[KERNEL_BLOCK])
{
    double sum = 0;
    for (size_t row = 0; row < SAMPLES; row += KERNEL_BLOCK) {
        double(*top)[KERNEL_BLOCK] = stack; /* one past the top */
        for (size_t g = t->length; g-- > 0;) {
            const int gene = t->gene[g];
            if (gene_arity(gene) == 2)
                top--;
            else
                top++;
            double *y = top[-1];
            const double *x = top[0]; /* popped: the operand read last is the first one */
            switch (gene) {
            case GENE_ADD:
                EACH(x[i] + y[i]);
                break;
            case GENE_SUB:
                EACH(x[i] - y[i]);
                break;
            case GENE_MUL:
                EACH(x[i] * y[i]);
                break;
            case GENE_PDIV:
                EACH(y[i] == 0 ? 1 : x[i] / y[i]);
                break;
            default:
                if (gene >= GENE_SYMBOL)
                    memcpy(y, columns_at(&w->table, (size_t)(gene - GENE_SYMBOL)) + row, sizeof *stack);
                else
                    EACH(w->program->constant[-1 - gene].value);
            }
        }
        for (size_t i = 0; i < KERNEL_BLOCK; i++)
            sum += fabs(stack[0][i] - columns_at(&w->table, VARIABLES)[row + i]);
    }
    return sum;
}

static double error_sum(const struct workload *w, const struct tree *t, struct kernel *k)
{
    const struct kernel_task task = {t->gene, t->length, w->program->constant, &w->table};
    return kernel_error_sum(k, &task, VARIABLES, INFINITY);
}

/* Random genomes whose values are finite, so that every engine evaluates them to the end. */
static void fill(struct workload *w, struct kernel *k, size_t operations)
{
    static int symbol[VARIABLES], constant[4], operation[] = {GENE_ADD, GENE_SUB, GENE_MUL, GENE_PDIV};
    static const char *const text[] = {"-0.35", "0.5", "1.25", "2"};
    const struct gene_set genes = {symbol, VARIABLES, constant, 4, operation, operations};
    gsl_rng *rng = stream_new();
    stream_key(rng, 0, 0, 0, 0);
    w->table = columns_new(SAMPLES, VARIABLES + 1);
    w->program = genome_file_new("benchmark");
    for (int i = 0; i < VARIABLES; i++)
        symbol[i] = GENE_SYMBOL + i;
    for (int i = 0; i < 4; i++)
        constant[i] = -1 - (int)genome_add_constant(w->program, text[i]);
    for (size_t j = 0; j <= VARIABLES; j++)
        for (size_t i = 0; i < SAMPLES; i++)
            columns_at(&w->table, j)[i] = 2 * gsl_rng_uniform(rng) - 1;
    for (size_t i = 0; i < GENOMES; i++) {
        w->tree[i].gene = w->gene[i];
        do
            tree_random(rng, &genes, 16, false, LONGEST, &w->tree[i]);
        while (w->tree[i].length < SHORTEST || !isfinite(error_sum(w, &w->tree[i], k)));
        w->genes += w->tree[i].length;
    }
    gsl_rng_free(rng);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Engine 0 is the interpreter, engine 1 + w the kernel of width w. */
static void race(struct kernel *const kernel[KERNEL_WIDTHS], const char *suffix, size_t operations, FILE *stream)
{
    static struct workload w;
    static double stack[LONGEST][KERNEL_BLOCK];
    double best[1 + KERNEL_WIDTHS];
    volatile double sink;
    w = (struct workload){0};
    fill(&w, kernel[KERNEL_PLAIN], operations);
    for (int e = 0; e <= KERNEL_WIDTHS; e++)
        best[e] = INFINITY;
    for (int round = 0; round < ROUNDS; round++)
        for (int e = 0; e <= KERNEL_WIDTHS; e++) {
            const double start = now();
            for (size_t i = 0; i < GENOMES && (e == 0 || kernel[e - 1]); i++)
                sink = e == 0 ? plain_error_sum(&w, &w.tree[i], stack) : error_sum(&w, &w.tree[i], kernel[e - 1]);
            best[e] = fmin(best[e], now() - start);
        }
    (void)sink;
    for (int e = 0; e <= KERNEL_WIDTHS; e++)
        if (e == 0 || kernel[e - 1])
            fprintf(stream, "%s%s,double,%d,%.3e\n", e == 0 ? "interpreter" : "footpoint", suffix,
                    kernel_bits(e == 0 ? KERNEL_PLAIN : (enum kernel_width)(e - 1)),
                    (double)w.genes * SAMPLES / best[e]);
    genome_file_free(w.program);
    columns_free(&w.table);
}

void evolve_benchmark(FILE *stream)
{
    struct kernel *kernel[KERNEL_WIDTHS];
    for (int k = 0; k < KERNEL_WIDTHS; k++)
        kernel[k] = kernel_supports((enum kernel_width)k) ? kernel_new((enum kernel_width)k) : NULL;
    fprintf(stream, "engine,precision,bits,genes_samples_per_s\n");
    race(kernel, "", 3, stream);
    race(kernel, "-rational", 4, stream);
    for (int k = 0; k < KERNEL_WIDTHS; k++)
        kernel_free(kernel[k]);
}
