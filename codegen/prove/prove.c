/* Proves that code equals its genome; see prove.h. Genome and code become a single list of operations over the same
 * inputs, so that the same evaluator handles both. It shares no code with the passes in between. */
#include "prove.h"

#include "../program/genome_program.h"
#include "prove_exact.h"
#include "prove_points.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The operations of genome and program; the genome's outputs come first, then the program's. */
struct sides {
    const struct program *both;
    int border; /* operations from here on belong to the program */
};

/* Marks the lets that the outputs need. */
static void mark_needed(const struct genome_file *f, const struct genome *genome, bool *needed)
{
    for (size_t k = f->lets + genome->outs; k-- > 0;) {
        const struct genome_expr *e = k < f->lets ? &f->let[k] : &genome->out[k - f->lets];
        for (size_t i = 0; (k >= f->lets || needed[f->inputs + k]) && i < e->length; i++)
            if (e->gene[i] >= GENE_SYMBOL)
                needed[e->gene[i] - GENE_SYMBOL] = true;
    }
}

static void add_genome(struct genome_program *b, const struct genome *genome)
{
    const struct genome_file *f = b->file;
    bool *needed = new_array(f->inputs + f->lets, sizeof *needed);
    mark_needed(f, genome, needed);
    for (size_t i = 0; i < f->lets; i++)
        if (needed[f->inputs + i])
            b->symbol[f->inputs + i] = genome_program_add(b, &f->let[i]);
    for (size_t i = 0; i < genome->outs; i++)
        b->program->output[b->program->outputs++] = genome_program_add(b, &genome->out[i]);
    free(needed);
}

static void add_program(struct program *both, const struct program *p)
{
    const int shift = program_append(both, p, NULL), inputs = (int)p->inputs;
    for (size_t i = 0; i < p->outputs; i++)
        both->output[both->outputs++] = p->output[i] < inputs ? p->output[i] : p->output[i] + shift;
}

static bool differ(const struct genome_file *f, const struct genome *genome, struct diag *d)
{
    return diag_at(d, f->path, genome->line, 1, "internal error: code made for genome '%s' does not equal it",
                   genome->name);
}

static bool prove(const struct genome_file *f, const struct genome *genome, const struct sides *s, struct proof *how,
                  struct diag *d)
{
    const struct program *both = s->both;
    const size_t outs = genome->outs;
    int divisor;
    struct points *x = points_new(both, &divisor);
    if (!x && divisor >= s->border)
        return differ(f, genome, d);
    if (!x && divisor >= 0)
        return diag_at(d, f->path, genome->line, 1, "genome '%s' divides by a value that is always 0", genome->name);
    *how = (struct proof){.points = x ? 2 : 0, .bits = x ? x->bits : 0, .log2_failure = x ? x->log2_failure : 0};
    enum verdict verdict = exact_compare(both, (size_t)s->border, x);
    for (size_t i = 0; x && verdict == UNDECIDED && i < outs; i++)
        if (!points_equal(x, both->output[i], both->output[outs + i]))
            verdict = DIFFERENT;
    points_free(x);
    if (verdict == DIFFERENT)
        return differ(f, genome, d);
    how->exact = verdict == EQUAL;
    return how->exact || how->points ||
           diag_at(d, f->path, genome->line, 1, "degree of genome '%s' is too high to prove its code equal",
                   genome->name);
}

bool prove_equal(const struct genome_file *f, const struct genome *genome, const struct program *p, struct proof *how,
                 struct diag *d)
{
    struct genome_program b = genome_program_start(f, 2 * genome->outs);
    add_genome(&b, genome);
    const struct sides s = {b.program, (int)b.program->ops};
    add_program(b.program, p);
    const bool good = prove(f, genome, &s, how, d);
    program_free(genome_program_end(&b));
    return good;
}

void proof_print(const struct proof *how, char text[120])
{
    if (how->exact)
        snprintf(text, 120, "proved equal to the genome as rational functions over Q");
    else
        snprintf(text, 120,
                 "equal to the genome at %d random points modulo a %lu-bit prime: chance of error below 2^%.0f",
                 how->points, how->bits, ceil(how->log2_failure));
}
