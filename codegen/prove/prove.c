/* Proof that code equals its genome; see prove.h.  Genome and code become one list of operations over the same inputs,
 * so that whatever evaluates the one evaluates the other; nothing of the passes in between is used. */
#include "prove.h"

#include "prove_exact.h"
#include "prove_points.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The operations of genome and program; the genome's outputs come first, then the program's. */
struct sides {
    struct program *both; /* owned */
    int *symbol;          /* owned: operation of a symbol */
    int *stack;           /* owned */
    size_t depth, stack_room;
    int border; /* operations from here on are the program's */
};

static int add_number(struct program *p, const char *text)
{
    fmpq_t q;
    fmpq_init(q);
    decimal_read(q, text + (*text == '-' || *text == '+'));
    if (*text == '-')
        fmpq_neg(q, q);
    const int op = program_add_constant(p, q, false);
    fmpq_clear(q);
    return op;
}

/* An expression from its end, as a stack machine; the number of its operation. */
static int add_expression(struct sides *s, const struct genome_file *f, const struct genome_expr *e)
{
    static const enum op_kind kind[GENE_OPERATORS] = {
        [GENE_ADD] = OP_ADD, [GENE_SUB] = OP_SUB, [GENE_MUL] = OP_MUL, [GENE_DIV] = OP_DIV,   [GENE_PDIV] = OP_PDIV,
        [GENE_MIN] = OP_MIN, [GENE_MAX] = OP_MAX, [GENE_NEG] = OP_NEG, [GENE_SQRT] = OP_SQRT, [GENE_ABS] = OP_ABS};
    s->depth = 0;
    for (size_t i = e->length; i-- > 0;) {
        const int gene = e->gene[i];
        int op;
        if (gene < 0)
            op = add_number(s->both, f->constant[-1 - gene].text);
        else if (gene >= GENE_SYMBOL)
            op = s->symbol[gene - GENE_SYMBOL];
        else {
            const int a = s->stack[--s->depth], b = gene_arity(gene) == 2 ? s->stack[--s->depth] : -1;
            op = program_add(s->both, kind[gene], a, b);
        }
        grow_array(&s->stack, s->depth, &s->stack_room, sizeof *s->stack);
        s->stack[s->depth++] = op;
    }
    return s->stack[0];
}

/* The lets that the outputs need. */
static void mark_needed(const struct genome_file *f, const struct genome *genome, bool *needed)
{
    for (size_t k = f->lets + genome->outs; k-- > 0;) {
        const struct genome_expr *e = k < f->lets ? &f->let[k] : &genome->out[k - f->lets];
        for (size_t i = 0; (k >= f->lets || needed[f->inputs + k]) && i < e->length; i++)
            if (e->gene[i] >= GENE_SYMBOL)
                needed[e->gene[i] - GENE_SYMBOL] = true;
    }
}

static void add_genome(struct sides *s, const struct genome_file *f, const struct genome *genome)
{
    bool *needed = new_array(f->inputs + f->lets, sizeof *needed);
    s->symbol = new_array(f->inputs + f->lets, sizeof *s->symbol);
    mark_needed(f, genome, needed);
    for (size_t i = 0; i < f->inputs; i++) {
        s->symbol[i] = program_add(s->both, OP_INPUT, -1, -1);
        s->both->op[i].input = (int)i;
    }
    for (size_t i = 0; i < f->lets; i++)
        if (needed[f->inputs + i])
            s->symbol[f->inputs + i] = add_expression(s, f, &f->let[i]);
    for (size_t i = 0; i < genome->outs; i++)
        s->both->output[s->both->outputs++] = add_expression(s, f, &genome->out[i]);
    free(needed);
}

static void add_program(struct sides *s, const struct program *p)
{
    const int shift = (int)s->both->ops - (int)p->inputs, inputs = (int)p->inputs;
    for (size_t i = p->inputs; i < p->ops; i++) {
        const struct op *o = &p->op[i];
        if (o->kind == OP_CONSTANT)
            program_add_constant(s->both, &p->constant[o->input], o->quotient);
        else
            program_add(s->both, o->kind, o->a < inputs ? o->a : o->a + shift, o->b < inputs ? o->b : o->b + shift);
    }
    for (size_t i = 0; i < p->outputs; i++)
        s->both->output[s->both->outputs++] = p->output[i] < inputs ? p->output[i] : p->output[i] + shift;
}

static bool differ(const struct genome_file *f, const struct genome *genome, struct diag *d)
{
    return diag_at(d, f->path, genome->line, 1, "internal error: the code made for genome '%s' does not equal it",
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
           diag_at(d, f->path, genome->line, 1, "genome '%s' is of too high a degree to be proved equal to its code",
                   genome->name);
}

bool prove_equal(const struct genome_file *f, const struct genome *genome, const struct program *p, struct proof *how,
                 struct diag *d)
{
    struct sides s = {.both = new_array(1, sizeof *s.both)};
    s.both->inputs = f->inputs;
    s.both->output = new_array(2 * genome->outs, sizeof *s.both->output);
    add_genome(&s, f, genome);
    s.border = (int)s.both->ops;
    add_program(&s, p);
    const bool good = prove(f, genome, &s, how, d);
    program_free(s.both);
    free(s.symbol);
    free(s.stack);
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
