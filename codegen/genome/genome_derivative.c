/* Derivatives of values, in genome text. For each let that a value uses and that depends on the variable, a further let
 * is added, its derivative by the rules of calculus; see genome_reader.h. Zeros are omitted here; the graph simplifies
 * the rest. */
#include "../base/text.h"
#include "genome_reader.h"

#include <stdlib.h>
#include <string.h>

/* The derivative of an expression; without genes if it is 0. */
struct text {
    int *gene; /* owned */
    size_t n, room;
};

/* An expression on the stack: its genes and its derivative. */
struct operand {
    const int *gene; /* not owned */
    size_t length;
    struct text slope;
};

struct derivation {
    struct genome_reader *r;
    const char *target; /* not owned: prefix of the names of hidden lets */
    int by, line;
    int *slope; /* owned: indexed by let, the gene of its derivative; 0 if that is 0 */
};

static void put(struct text *t, int gene)
{
    APPEND(t->gene, t->n, t->room) = gene;
}

static void put_all(struct text *t, const int *gene, size_t n)
{
    for (size_t i = 0; i < n; i++)
        put(t, gene[i]);
}

/* Appends the contribution of operand `of`, x or y, to the derivative of an operation, by the text of genes.h. */
static void put_derivative(const struct derivation *v, struct text *t, const char *text, const struct operand *x,
                           const struct operand *y, const struct operand *of)
{
    char word[16];
    for (size_t n; (n = strcspn(text, " ")) > 0; text += n + (text[n] == ' ')) {
        snprintf(word, sizeof word, "%.*s", (int)n, text);
        if (strcmp(word, "s") == 0)
            put_all(t, of->slope.gene, of->slope.n);
        else if (strcmp(word, "a") == 0)
            put_all(t, x->gene, x->length);
        else if (strcmp(word, "b") == 0)
            put_all(t, y->gene, y->length);
        else
            put(t, gene_of_name(word) < 0 ? -1 - (int)genome_add_constant(v->r->file, word) : gene_of_name(word));
    }
}

/* Derives an operation; at least one operand must have a derivative. */
static bool derive_operation(const struct derivation *v, int gene, const struct operand *x, const struct operand *y,
                             struct text *t)
{
#define OF_TWO(gene, text, value, slope_a, slope_b, by_a, by_b) [GENE_##gene] = {by_a, by_b},
#define OF_ONE(gene, text, value, slope, by_a, ...) [GENE_##gene] = {by_a, ""},
    static const char *const by[GENE_OPERATORS][2] = {GENES_OF_TWO(OF_TWO) GENES_OF_ONE(OF_ONE)};
    const char *by_x = by[gene][0], *by_y = by[gene][1];
    if (!by_x)
        return diag_at(v->r->d, v->r->file->path, v->line, 1, "'%s' is not differentiable everywhere", gene_name(gene));
    if (gene == GENE_DIV)
        put(t, GENE_DIV);
    if (x->slope.n && y->slope.n) {
        const bool minus = strncmp(by_y, "neg ", 4) == 0;
        put(t, minus ? GENE_SUB : GENE_ADD);
        by_y += minus ? 4 : 0;
    }
    if (x->slope.n)
        put_derivative(v, t, by_x, x, y, x);
    if (y->slope.n)
        put_derivative(v, t, by_y, x, y, y);
    if (gene == GENE_DIV)
        put_all(t, y->gene, y->length);
    return true;
}

/* Returns the gene of a symbol's derivative, or 0 if that is 0. */
static int slope_of(const struct derivation *v, int gene)
{
    const struct genome_file *f = v->r->file;
    if (gene == v->by)
        return -1 - (int)genome_add_constant(v->r->file, "1");
    return gene < GENE_SYMBOL + (int)f->inputs ? 0 : v->slope[gene - GENE_SYMBOL - (int)f->inputs];
}

/* Derives an expression into the reader's genes, from its end, as a stack machine. */
static bool derive_expression(struct derivation *v, const struct genome_expr *e)
{
    struct operand *stack = new_array(e->length, sizeof *stack);
    size_t depth = 0;
    bool good = true;
    for (size_t i = e->length; good && i-- > 0;) {
        const int gene = e->gene[i], operands = gene_arity(gene);
        const struct operand none = {0};
        const struct operand x = operands > 0 ? stack[--depth] : none, y = operands > 1 ? stack[--depth] : none;
        struct operand z = {e->gene + i, 1 + x.length + y.length, {0}};
        const int slope = operands == 0 ? slope_of(v, gene) : 0;
        if (slope)
            put(&z.slope, slope);
        if (x.slope.n || y.slope.n)
            good = derive_operation(v, gene, &x, &y, &z.slope);
        free(x.slope.gene);
        free(y.slope.gene);
        stack[depth++] = z;
    }
    v->r->genes = 0;
    for (size_t i = 0; good && i < stack[0].slope.n; i++)
        put_gene(v->r, stack[0].slope.gene[i]);
    for (size_t i = 0; i < depth; i++)
        free(stack[i].slope.gene);
    free(stack);
    return good;
}

/* Returns an array indexed by let: the last let needs it. */
static bool *needed_lets(const struct genome_file *f, size_t lets)
{
    const int first = GENE_SYMBOL + (int)f->inputs;
    bool *needed = new_array(lets, sizeof *needed);
    if (lets > 0)
        needed[lets - 1] = true;
    for (size_t i = lets; i-- > 0;)
        for (size_t k = 0; needed[i] && k < f->let[i].length; k++)
            if (f->let[i].gene[k] >= first)
                needed[f->let[i].gene[k] - first] = true;
    return needed;
}

/* Turns the reader's genes into a single gene: a new let "TARGET.LET", unless they are a single gene or empty (0). */
static bool hide_slope(struct derivation *v, size_t let)
{
    const char *name = v->r->file->let[let].name, *inner = strrchr(name, '.');
    if (v->r->genes <= 1) {
        v->slope[let] = v->r->genes ? v->r->gene[0] : 0;
        return true;
    }
    char *hidden = new_joined(v->target, ".", inner ? inner + 1 : name);
    const bool good = add_number(v->r, hidden, v->line, &v->slope[let]);
    free(hidden);
    return good;
}

bool derive(struct genome_reader *r, int of, int by, const char *target, int line, int *gene)
{
    const int first = GENE_SYMBOL + (int)r->file->inputs;
    const size_t lets = of >= first ? (size_t)(of - first) + 1 : 0;
    struct derivation v = {r, target, by, line, new_array(lets, sizeof *v.slope)};
    bool *needed = needed_lets(r->file, lets), good = true;
    for (size_t i = 0; good && i < lets; i++)
        if (needed[i] && first + (int)i != by) {
            const struct genome_expr let = r->file->let[i];
            good = derive_expression(&v, &let) && hide_slope(&v, i);
        }
    *gene = slope_of(&v, of);
    if (*gene == 0)
        *gene = -1 - (int)genome_add_constant(r->file, "0");
    free(needed);
    free(v.slope);
    return good;
}
