/* Exact simplification. Each expression is read from its end with a stack. A chain of + and - becomes an n-ary sum, a
 * chain of * and / a product, before either becomes a node, so that terms cancel and constants fold wherever they are.
 * The genome's semantics apply: x/x is 1 and reported; x%x is 1 by definition; x%y stays unless y is constant. */
#include "from_genome.h"

#include "constant_text.h"

#include <stdlib.h>
#include <string.h>

/* A sum or a product under construction. `flip` means the sign of every term, or the inverse of every factor. It is
 * applied late, so that a chain of n operators costs n log n. */
struct item {
    bool product, flip;
    fmpq_t coef;        /* of a product; not affected by flip */
    struct edges edges; /* terms or factors; a factor's coefficient is ZERO if it was a divisor, even if no longer */
    size_t divided;     /* of factors: how many at the beginning are known to be ZERO */
};

struct builder {
    const struct genome_file *file;
    struct dag *dag;
    rational *constant;   /* owned: the file's constants */
    struct value *symbol; /* owned */
    struct item *stack;   /* owned */
    size_t depth, room;
};

static rational read_rational(const char *text)
{
    fmpq_t c;
    fmpq_init(c);
    constant_read(c, text);
    const rational r = rational_intern(c);
    fmpq_clear(c);
    return r;
}

static void push_value(struct builder *b, struct value v)
{
    struct item *it = &APPEND(b->stack, b->depth, b->room);
    *it = (struct item){.product = true};
    fmpq_init(it->coef);
    fmpq_set(it->coef, rational_value(v.coef));
    if (v.node != 0)
        edges_add(&it->edges, ONE, v.node, 1);
}

static void flip_edge(const struct item *it, struct edge *e)
{
    if (it->product)
        e->power = -e->power;
    else
        e->coef = rational_neg(e->coef);
}

static struct value make_value(struct builder *b, struct item *it)
{
    for (size_t i = 0; it->flip && i < it->edges.n; i++)
        flip_edge(it, &it->edges.edge[i]);
    for (size_t i = 0; it->product && i < it->edges.n; i++)
        if (it->edges.edge[i].coef == ZERO && it->edges.edge[i].power > 0) /* such as y in x / (1 / y) */
            dag_remove(b->dag, it->edges.edge[i].node);
    it->flip = false;
    it->divided = 0;
    return it->product ? dag_product(b->dag, rational_intern(it->coef), &it->edges)
                       : dag_number(b->dag, dag_sum(b->dag, &it->edges));
}

/* Pops an item as a value. */
static struct value pop_value(struct builder *b)
{
    struct item *it = &b->stack[--b->depth];
    const struct value v = make_value(b, it);
    fmpq_clear(it->coef);
    return v;
}

/* Turns an item into a sum. */
static void as_sum(struct builder *b, struct item *it)
{
    if (!it->product)
        return;
    const struct value v = make_value(b, it);
    if (v.coef != ZERO)
        edges_add(&it->edges, v.coef, v.node, 1);
    it->product = false;
}

static void as_product(struct builder *b, struct item *it)
{
    if (it->product)
        return;
    const struct value v = make_value(b, it);
    fmpq_set(it->coef, rational_value(v.coef));
    if (v.node != 0)
        edges_add(&it->edges, ONE, v.node, 1);
    it->product = true;
}

/* Moves the operands of `second` into `first`, the shorter list into the longer. */
static void merge(struct item *first, struct item *second)
{
    if (first->edges.n < second->edges.n) {
        const struct edges swap = first->edges;
        first->edges = second->edges;
        second->edges = swap;
        const bool flip = first->flip;
        first->flip = second->flip;
        second->flip = flip;
        first->divided = second->divided;
    }
    for (size_t i = 0; i < second->edges.n; i++) {
        struct edge *e = &second->edges.edge[i];
        if (first->flip != second->flip)
            flip_edge(first, e);
        edges_add(&first->edges, e->coef, e->node, e->power);
    }
    edges_clear(&second->edges);
    fmpq_clear(second->coef);
}

static void add(struct builder *b, bool subtract)
{
    struct item *first = &b->stack[b->depth - 1], *second = &b->stack[b->depth - 2];
    as_sum(b, first);
    as_sum(b, second);
    second->flip ^= subtract;
    merge(second, first);
    b->depth--;
}

static bool multiply(struct builder *b, bool divide)
{
    struct item *first = &b->stack[b->depth - 1], *second = &b->stack[b->depth - 2];
    as_product(b, first);
    as_product(b, second);
    if (divide) {
        if (fmpq_is_zero(second->coef))
            return false;
        fmpq_inv(second->coef, second->coef);
        second->flip = !second->flip;
        for (; second->divided < second->edges.n; second->divided++)
            second->edges.edge[second->divided].coef = ZERO;
    }
    rational_scale(second->coef, first->coef);
    merge(second, first);
    b->depth--;
    return true;
}

/* Applies a function. Returns false if it is undefined for a negative constant. */
static bool apply_function(struct builder *b, int gene)
{
#define NODE(gene, ...) [GENE_##gene] = NODE_##gene,
    static const enum node_kind kind[GENE_OPERATORS] = {CHOICES(NODE) UNARY(NODE)};
#undef NODE
    struct value x = pop_value(b), y = {ZERO, 0};
    if (gene_arity(gene) == 2)
        y = pop_value(b);
    push_value(b, dag_function(b->dag, kind[gene], x, y));
    return gene < GENE_UNARY(0) || unary_of[gene - GENE_UNARY(0)].negative || x.node != 0 || rational_sign(x.coef) >= 0;
}

static bool build(struct builder *b, const struct genome_expr *e, struct value *v, struct diag *d)
{
    for (size_t i = e->length; i-- > 0;) {
        const int gene = e->gene[i];
        if (gene < 0)
            push_value(b, dag_constant(b->constant[-1 - gene]));
        else if (gene >= GENE_SYMBOL)
            push_value(b, b->symbol[gene - GENE_SYMBOL]);
        else if (gene == GENE_ADD || gene == GENE_SUB)
            add(b, gene == GENE_SUB);
        else if (gene == GENE_MUL)
            multiply(b, false);
        else if (gene == GENE_NEG) {
            struct item *top = &b->stack[b->depth - 1];
            as_product(b, top);
            fmpq_neg(top->coef, top->coef);
        } else if (gene == GENE_DIV) {
            if (!multiply(b, true))
                return diag_at(d, b->file->path, e->line, 1, "'%s' divides by a value that is always 0", e->name);
        } else if (!apply_function(b, gene))
            return diag_at(d, b->file->path, e->line, 1, "'%s' takes the %s of a value that is always negative",
                           e->name, gene_name(gene));
    }
    *v = pop_value(b);
    return true;
}

/* Counts how often the outputs, and the lets that they need, name each symbol; goes backwards. */
static void count_references(const struct genome_file *f, const struct genome *genome, long *references)
{
    for (size_t k = 0; k < genome->outs; k++)
        for (size_t i = 0; i < genome->out[k].length; i++)
            if (genome->out[k].gene[i] >= GENE_SYMBOL)
                references[genome->out[k].gene[i] - GENE_SYMBOL]++;
    for (size_t k = f->lets; k-- > 0;)
        for (size_t i = 0; references[f->inputs + k] && i < f->let[k].length; i++)
            if (f->let[k].gene[i] >= GENE_SYMBOL)
                references[f->let[k].gene[i] - GENE_SYMBOL]++;
}

static void keep_let(struct dag *g, struct value v, enum keep_lets keep)
{
    struct node *n = &g->node[v.node];
    bool quotient = n->kind == NODE_INVERSE;
    for (size_t i = 0; n->kind == NODE_PRODUCT && i < n->edges; i++)
        quotient |= g->node[n->edge[i].node].kind == NODE_INVERSE;
    if (quotient || (keep == KEEP_ALL && n->kind == NODE_PRODUCT))
        n->kept = true;
}

struct dag *simplify_genome(const struct genome_file *f, const struct genome *genome, enum keep_lets keep,
                            struct diag *d)
{
    const size_t symbols = f->inputs + f->lets;
    struct builder b = {.file = f, .dag = dag_new(f->inputs)};
    long *references = new_array(symbols, sizeof *references);
    bool good = true;
    b.constant = new_array(f->constants, sizeof *b.constant);
    b.symbol = new_array(symbols, sizeof *b.symbol);
    for (size_t i = 0; i < f->constants; i++)
        b.constant[i] = read_rational(f->constant[i].text);
    for (size_t i = 0; i < f->inputs; i++)
        b.symbol[i] = dag_input(b.dag, i);
    count_references(f, genome, references);
    for (size_t i = 0; i < f->lets && good; i++)
        if (references[f->inputs + i] > 0) {
            struct value *v = &b.symbol[f->inputs + i];
            good = build(&b, &f->let[i], v, d);
            if (good && references[f->inputs + i] > 1)
                keep_let(b.dag, *v, keep);
        }
    for (size_t i = 0; i < genome->outs && good; i++) {
        struct value v;
        good = build(&b, &genome->out[i], &v, d);
        if (good)
            dag_add_output(b.dag, genome->out[i].name, v);
    }
    for (size_t i = 0; i < b.depth; i++) {
        edges_clear(&b.stack[i].edges);
        fmpq_clear(b.stack[i].coef);
    }
    free(b.constant);
    free(b.symbol);
    free(b.stack);
    free(references);
    if (rational_take_overflow() && good)
        good = diag_at(d, f->path, genome->line, 1, "genome '%s' has a constant outside the range of double",
                       genome->name);
    if (good)
        return b.dag;
    dag_free(b.dag);
    return NULL;
}
