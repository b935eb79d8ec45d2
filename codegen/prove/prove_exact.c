/* Compares rational functions exactly; see prove_exact.h. */
#include "prove_exact.h"

#include "../graph/unary.h"
#include "rational_function.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_VARIABLES = 128, MOST_OPS = 50000, POINTS = 16 };

/* A function with arguments that no other variable has. */
struct opaque {
    enum op_kind kind;
    struct ratio argument[2];
    slong variable;
};

struct comparison {
    const struct program *program;
    const int *first;  /* not owned: points_classes, or NULL */
    size_t border;     /* operations from here on belong to the other side */
    const fmpq *input; /* not owned: values of the inputs; NULL: they are variables */
    slong most_terms;  /* of a value that both sides share; larger values become variables */
    struct ring ring;
    struct ratio *value;      /* owned: by operation */
    bool *shared;             /* owned: by the first operation of a class */
    struct ratio *definition; /* owned: by the first operation of a class */
    struct opaque *opaque;    /* owned */
    size_t opaques, opaque_room;
};

/* ---- functions ---- */

static bool same_arguments(struct ring *g, const struct opaque *o, const struct ratio *a, const struct ratio *b)
{
    return ratio_equal(g, &o->argument[0], a) && (!b || ratio_equal(g, &o->argument[1], b));
}

/* Sets r to the variable of this function; b is NULL for a unary function. */
static void set_opaque(struct comparison *c, struct ratio *r, enum op_kind kind, const struct ratio *a,
                       const struct ratio *b)
{
    struct ring *g = &c->ring;
    const bool commutes = kind == OP_MIN || kind == OP_MAX;
    for (size_t i = 0; i < c->opaques; i++) {
        const struct opaque *o = &c->opaque[i];
        if (o->kind == kind && (same_arguments(g, o, a, b) || (commutes && same_arguments(g, o, b, a)))) {
            ratio_set_variable(r, o->variable);
            return;
        }
    }
    struct opaque *o = &APPEND(c->opaque, c->opaques, c->opaque_room);
    o->kind = kind;
    for (int k = 0; k < 2; k++) {
        ratio_init(&o->argument[k]);
        ratio_set(&o->argument[k], k && b ? b : a);
    }
    o->variable = ratio_set_new_variable(g, r);
}

/* Folds min and max of constants or of equal arguments, and functions of a constant with rational values. */
static bool fold(struct ring *g, struct ratio *r, enum op_kind kind, const struct ratio *a, const struct ratio *b)
{
    bool folds = false;
    fmpq_t x, y;
    fmpq_init(x);
    fmpq_init(y);
    if (kind == OP_MIN || kind == OP_MAX) {
        const bool same = ratio_equal(g, a, b);
        folds = same || (ratio_get_rational(g, x, a) && ratio_get_rational(g, y, b));
        if (folds)
            ratio_set(r, same || (fmpq_cmp(x, y) < 0) == (kind == OP_MIN) ? a : b);
    } else {
        folds = ratio_get_rational(g, x, a) && unary_exact(kind - OP_UNARY, x, x);
        if (folds)
            ratio_set_rational(r, x);
    }
    fmpq_clear(x);
    fmpq_clear(y);
    return folds;
}

/* Uses |c a| = |c| |a|. A protected quotient is determined by its quotient and the zeros of its divisor, which a factor
 * does not change. */
static void set_scaled_opaque(struct comparison *c, struct ratio *r, enum op_kind kind, const struct ratio *a,
                              const struct ratio *b)
{
    struct ring *g = &c->ring;
    struct ratio primitive, quotient;
    fmpq_t q;
    fmpq_init(q);
    ratio_init(&primitive);
    ratio_init(&quotient);
    ratio_set(&primitive, kind == OP_ABS ? a : b);
    fmpq_one(primitive.content);
    if (kind == OP_ABS) {
        set_opaque(c, r, kind, &primitive, NULL);
        fmpq_abs(r->content, a->content);
    } else if (ratio_is_zero(b) || ratio_equal(g, a, b)) {
        fmpq_one(q);
        ratio_set_rational(r, q);
    } else {
        ratio_multiply(g, &quotient, a, b, true);
        if (ratio_get_rational(g, q, b))
            ratio_set(r, &quotient);
        else
            set_opaque(c, r, kind, &quotient, &primitive);
    }
    ratio_clear(&primitive);
    ratio_clear(&quotient);
    fmpq_clear(q);
}

static void evaluate(struct comparison *c, const struct op *o, struct ratio *r)
{
    struct ring *g = &c->ring;
    const struct ratio *a = o->a < 0 ? NULL : &c->value[o->a], *b = o->b < 0 ? NULL : &c->value[o->b];
    switch (o->kind) {
    case OP_INPUT:
        break;
    case OP_CONSTANT:
        ratio_set_rational(r, &c->program->constant[o->input]);
        break;
    case OP_NEG:
        ratio_set(r, a);
        fmpq_neg(r->content, r->content);
        break;
    case OP_ADD:
    case OP_SUB:
        ratio_add(g, r, a, b, o->kind == OP_SUB);
        break;
    case OP_MUL:
        ratio_multiply(g, r, a, b, false);
        break;
    case OP_DIV:
        ratio_multiply(g, r, a, b, true);
        break;
    case OP_PDIV:
        set_scaled_opaque(c, r, o->kind, a, b);
        break;
    default:
        if (fold(g, r, o->kind, a, b))
            break;
        if (o->kind == OP_ABS)
            set_scaled_opaque(c, r, o->kind, a, b);
        else
            set_opaque(c, r, o->kind, a, b);
    }
}

/* ---- shared values ---- */

/* Turns the first value of a class that both sides have into a variable if it is large. The others become multiples of
 * that variable once this is proved. */
static void share(struct comparison *c, int op)
{
    struct ring *g = &c->ring;
    struct ratio *r = &c->value[op];
    const int first = c->first ? c->first[op] : -1;
    if (g->stopped || first < 0 || !c->shared[first])
        return;
    if (op == first) {
        c->shared[op] = ratio_length(g, r) > c->most_terms && g->used < g->variables;
        if (c->shared[op]) {
            ratio_set(&c->definition[op], r);
            ratio_set_new_variable(g, r);
        }
        return;
    }
    if (!ratio_is_zero(r) && ratio_proportional(g, r, &c->definition[first])) {
        fmpq_t factor;
        fmpq_init(factor);
        fmpq_div(factor, r->content, c->definition[first].content);
        ratio_set(r, &c->value[first]);
        fmpq_set(r->content, factor);
        fmpq_clear(factor);
    }
}

static void mark_shared(struct comparison *c)
{
    for (size_t i = c->border; c->first && i < c->program->ops; i++) {
        const int first = c->first[i];
        if (first >= (int)c->program->inputs && first < (int)c->border)
            c->shared[first] = true;
    }
}

/* Returns the largest possible number of variables. */
static slong count_variables(const struct comparison *c, const bool *read)
{
    slong n = 0;
    for (size_t i = 0; i < c->program->ops; i++)
        n += (i < c->program->inputs && read[i]) + (c->program->op[i].kind >= OP_FUNCTION) + c->shared[i];
    return n;
}

static enum verdict compare(struct comparison *c, const bool *read)
{
    const struct program *p = c->program;
    const size_t half = p->outputs / 2;
    for (size_t i = 0; i < p->inputs; i++)
        if (c->input)
            ratio_set_rational(&c->value[i], &c->input[i]);
        else if (read[i])
            ratio_set_new_variable(&c->ring, &c->value[i]);
    for (size_t i = p->inputs; i < p->ops && !c->ring.stopped; i++) {
        evaluate(c, &p->op[i], &c->value[i]);
        share(c, (int)i);
    }
    bool same = true;
    for (size_t i = 0; i < half && !c->ring.stopped; i++)
        same = same && ratio_equal(&c->ring, &c->value[p->output[i]], &c->value[p->output[half + i]]);
    return c->ring.stopped ? UNDECIDED : same ? EQUAL : DIFFERENT;
}

static enum verdict compare_with(struct comparison c, const bool *read)
{
    const size_t ops = c.program->ops;
    c.shared = new_array(ops, sizeof *c.shared);
    mark_shared(&c);
    const slong variables = count_variables(&c, read);
    ring_init(&c.ring, variables < MOST_VARIABLES ? variables : MOST_VARIABLES);
    c.value = new_array(ops, sizeof *c.value);
    c.definition = new_array(ops, sizeof *c.definition);
    for (size_t i = 0; i < ops; i++) {
        ratio_init(&c.value[i]);
        ratio_init(&c.definition[i]);
    }
    const enum verdict verdict = compare(&c, read);
    for (size_t i = 0; i < ops; i++) {
        ratio_clear(&c.value[i]);
        ratio_clear(&c.definition[i]);
    }
    for (size_t i = 0; i < 2 * c.opaques; i++)
        ratio_clear(&c.opaque[i / 2].argument[i % 2]);
    ring_clear(&c.ring);
    free(c.value);
    free(c.definition);
    free(c.opaque);
    free(c.shared);
    return verdict;
}

/* Returns true if the values differ at any of several rational points. As long as values stay small, min, max and abs
 * choose there as in the code. At half of the points, values coincide and divisors of protected quotients vanish. */
static bool differ_at_points(const struct program *p, size_t border, const bool *read)
{
    fmpq *input = _fmpq_vec_init((slong)p->inputs);
    bool differ = false;
    for (unsigned point = 0; point < POINTS && !differ; point++) {
        for (size_t i = 0; i < p->inputs; i++) {
            const unsigned long h = (point * 1000003 + i) * 0x9e3779b97f4a7c15u >> 32;
            if (point % 2)
                fmpq_set_si(&input[i], (slong)(h % 5) - 2, 2);
            else
                fmpq_set_si(&input[i], (slong)(h % 509) - 254, 1UL << h % 13);
        }
        const struct comparison c = {.program = p, .border = border, .input = input};
        differ = compare_with(c, read) == DIFFERENT;
    }
    _fmpq_vec_clear(input, (slong)p->inputs);
    return differ;
}

static bool has_functions(const struct program *p)
{
    for (size_t i = 0; i < p->ops; i++)
        if (p->op[i].kind >= OP_FUNCTION)
            return true;
    return false;
}

enum verdict exact_compare(const struct program *p, size_t border, const struct points *points)
{
    static const slong most_terms[] = {WORD_MAX, 64, 8, 1};
    enum verdict verdict = UNDECIDED;
    if (p->ops > MOST_OPS)
        return UNDECIDED;
    bool *read = program_reads(p);
    if (has_functions(p) && differ_at_points(p, border, read)) {
        free(read);
        return DIFFERENT;
    }
    int *first = points ? points_classes(points) : NULL;
    for (size_t i = 0; i < sizeof most_terms / sizeof *most_terms && verdict != EQUAL; i++) {
        const bool plain = most_terms[i] == WORD_MAX;
        const struct comparison c = {
            .program = p, .first = plain ? NULL : first, .border = border, .most_terms = most_terms[i]};
        if (!plain && !first)
            break;
        verdict = compare_with(c, read);
        if (plain && verdict == DIFFERENT)
            break;
        if (verdict == DIFFERENT) /* in terms of shared values, which may hide a relation */
            verdict = UNDECIDED;
    }
    free(first);
    free(read);
    return verdict;
}
