/* Enclosures of a program's values; see enclosure.h. */
#include "enclosure.h"

#include "affine.h"

#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SLOPES = 1 << 22, ROUNDS = 2, SHORT = 32 /* operations */, DEPTH = 3 };

struct interval interval_around(const fmpq *q)
{
    struct interval x;
    mpfr_t y;
    mpfr_init2(y, 53);
    fmpq_get_mpfr(y, q, MPFR_RNDD);
    x.lo = mpfr_get_d(y, MPFR_RNDD);
    fmpq_get_mpfr(y, q, MPFR_RNDU);
    x.hi = mpfr_get_d(y, MPFR_RNDU);
    mpfr_clear(y);
    return x;
}

/* ---- which operations ---- */

/* The operations that are needed so far, and of which values, multiples counted as one, there is any. */
struct choice {
    const struct region *region;
    bool *needed, *value; /* owned: by operation */
    int *stack;           /* owned */
    size_t depth, room;
};

static int value_of(const struct region *r, int op)
{
    return r->twin[op] >= 0 ? r->twin[op] : op;
}

static struct interval ratio_of(const struct region *r, int op)
{
    return r->twin[op] >= 0 ? r->ratio[op] : interval_point(1);
}

static void push(struct choice *c, int op)
{
    if (op < 0 || c->needed[op])
        return;
    c->needed[op] = c->value[value_of(c->region, op)] = true;
    grow_array(&c->stack, c->depth, &c->room, sizeof *c->stack);
    c->stack[c->depth++] = op;
}

/* Takes in what `op` depends on; how many operations that was. */
static size_t need(struct choice *c, int op)
{
    size_t added = 0;
    push(c, op);
    for (; c->depth > 0; added++) {
        const struct op *o = &c->region->program->op[c->stack[--c->depth]];
        push(c, o->a);
        push(c, o->b);
    }
    return added;
}

/* A require, down to some depth, tells something of its operands; it serves if any of that is needed. */
static bool tells(const struct choice *c, int op, int depth)
{
    const struct op *o = &c->region->program->op[op];
    return (o->kind > OP_INPUT && c->value[value_of(c->region, op)]) ||
           (depth > 0 && ((o->a >= 0 && tells(c, o->a, depth - 1)) || (o->b >= 0 && tells(c, o->b, depth - 1))));
}

/* Requires that build on others stand behind them. */
static void choose_operations(struct forms *w, int target)
{
    const struct region *r = w->region;
    const struct program *p = r->program;
    struct choice c = {.region = r};
    c.needed = new_array(p->ops, sizeof *c.needed);
    c.value = new_array(p->ops, sizeof *c.value);
    if (target >= 0)
        w->needs += need(&c, target);
    for (size_t i = p->outputs; i-- > 0;)
        if (target < 0 || r->length[p->output[i]] <= SHORT || tells(&c, p->output[i], DEPTH)) {
            w->required[p->output[i]] = true;
            w->needs += need(&c, p->output[i]);
        }
    w->needed = new_array(w->needs, sizeof *w->needed);
    for (size_t i = 0, n = 0; i < p->ops; i++)
        if (c.needed[i])
            w->needed[n++] = (int)i;
    free(c.needed);
    free(c.value);
    free(c.stack);
}

/* Twins of the region, as far as they are needed. */
static void choose_twins(struct forms *w)
{
    const struct region *r = w->region;
    int *first = new_array(r->program->ops, sizeof *first);
    for (size_t n = 0; n < w->needs; n++) {
        const int i = w->needed[n], value = value_of(r, i);
        w->twin[i] = first[value] - 1;
        if (w->twin[i] < 0)
            first[value] = i + 1;
        else
            w->ratio[i] = interval_divide(ratio_of(r, i), ratio_of(r, w->twin[i]));
    }
    free(first);
}

struct forms *forms_new(const struct region *r, int target)
{
    struct forms *w = new_array(1, sizeof *w);
    const size_t rows = r->program->ops + 2; /* and two at hand */
    *w = (struct forms){.region = r};
    w->required = new_array(rows, sizeof *w->required);
    w->twin = new_array(rows, sizeof *w->twin);
    w->ratio = new_array(rows, sizeof *w->ratio);
    choose_operations(w, target);
    choose_twins(w);
    w->affine = r->variables > 0 && rows <= MOST_SLOPES / r->variables;
    w->range = new_array(rows, sizeof *w->range);
    w->centre = new_array(rows, sizeof *w->centre);
    w->radius = new_array(rows, sizeof *w->radius);
    w->mass = new_array(rows, sizeof *w->mass);
    w->slope = new_array(w->affine ? rows * r->variables : 0, sizeof *w->slope);
    return w;
}

void forms_free(struct forms *w)
{
    if (!w)
        return;
    free(w->needed);
    free(w->twin);
    free(w->ratio);
    free(w->required);
    free(w->range);
    free(w->centre);
    free(w->radius);
    free(w->mass);
    free(w->slope);
    free(w);
}

/* ---- evaluation ---- */

static struct interval range_of(const struct forms *w, const struct op *op, const struct interval *box)
{
    const struct interval none = {0, 0}, *a = op->a >= 0 ? &w->range[op->a] : &none;
    const struct interval *b = op->b >= 0 ? &w->range[op->b] : &none;
    switch (op->kind) {
    case OP_CONSTANT:
        break;
    case OP_INPUT: {
        const size_t k = w->region->variable[op->input];
        return k < w->region->variables ? box[k] : interval_whole();
    }
    case OP_NEG:
        return interval_negative(*a);
    case OP_ADD:
        return interval_add(*a, *b);
    case OP_SUB:
        return interval_subtract(*a, *b);
    case OP_MUL:
        return op->squared ? interval_square(*a) : interval_multiply(*a, *b);
    case OP_DIV:
    case OP_PDIV:
        return interval_divide(*a, *b);
    case OP_SQRT:
        return interval_root(*a);
    case OP_ABS:
        return interval_absolute(*a);
    case OP_MIN:
        return interval_minimum(*a, *b);
    case OP_MAX:
        return interval_maximum(*a, *b);
    }
    return interval_whole();
}

/* It is known that operation i lies in x: so does, scaled, its twin. */
static void tighten(struct forms *w, int i, struct interval x)
{
    const int twin = w->twin[i];
    w->range[i] = interval_meet(w->range[i], x);
    if (twin >= 0)
        w->range[twin] = interval_meet(w->range[twin], interval_divide(w->range[i], w->ratio[i]));
}

/* What is known of operation i, down to some depth, tells of its operands. */
static void tell(struct forms *w, int i, struct interval x, int depth)
{
    const struct op *op = &w->region->program->op[i];
    tighten(w, i, x);
    if (depth == 0 || op->a < 0)
        return;
    const struct interval y = w->range[i], a = w->range[op->a], b = op->b >= 0 ? w->range[op->b] : a;
    switch (op->kind) {
    case OP_NEG:
        tell(w, op->a, interval_negative(y), depth - 1);
        break;
    case OP_ADD:
        tell(w, op->a, interval_subtract(y, b), depth - 1);
        tell(w, op->b, interval_subtract(y, a), depth - 1);
        break;
    case OP_SUB:
        tell(w, op->a, interval_add(y, b), depth - 1);
        tell(w, op->b, interval_subtract(a, y), depth - 1);
        break;
    case OP_MUL:
        tell(w, op->a, interval_divide(y, b), depth - 1);
        tell(w, op->b, interval_divide(y, a), depth - 1);
        break;
    case OP_DIV:
        tell(w, op->a, interval_multiply(y, b), depth - 1);
        break;
    case OP_ABS:
        tell(w, op->a, (struct interval){-y.hi, y.hi}, depth - 1);
        break;
    default:
        break;
    }
}

static bool is_empty(struct interval x)
{
    return !(x.lo <= x.hi);
}

bool forms_evaluate(struct forms *w, const struct interval *box)
{
    const struct region *r = w->region;
    w->inside = true;
    for (size_t n = 0; n < w->needs; n++) {
        const size_t i = (size_t)w->needed[n];
        w->range[i] = interval_meet(range_of(w, &r->program->op[i], box), r->known[i]);
        if (is_empty(w->range[i]))
            return false;
        if (w->affine)
            affine_set(w, i);
        if (w->twin[i] >= 0)
            w->range[i] = interval_meet(w->range[i], interval_multiply(w->range[w->twin[i]], w->ratio[i]));
        if (w->required[i]) {
            w->inside = w->inside && w->range[i].lo > 0;
            tell(w, (int)i, (struct interval){0, INFINITY}, DEPTH);
        }
        if (is_empty(w->range[i]))
            return false;
    }
    return true;
}

bool box_is_empty(const struct interval *box, size_t variables)
{
    for (size_t k = 0; k < variables; k++)
        if (is_empty(box[k]))
            return true;
    return false;
}

/* Narrowing by one require lets others narrow further. */
bool forms_evaluate_narrowed(struct forms *w, struct interval *box)
{
    const struct program *p = w->region->program;
    for (int round = 0; round < ROUNDS; round++) {
        bool cut = false;
        if (!forms_evaluate(w, box))
            return false;
        for (size_t i = 0; i < p->outputs && !w->inside; i++)
            cut = affine_narrow(w, p->output[i], 1, 0, box) || cut;
        if (box_is_empty(box, w->region->variables))
            return false;
        if (!cut)
            return true;
    }
    return forms_evaluate(w, box);
}

bool forms_finite(const struct forms *w)
{
    for (size_t n = 0; n < w->needs; n++)
        if (!interval_finite(w->range[w->needed[n]]))
            return false;
    return true;
}
