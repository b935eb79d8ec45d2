/* Enclosures of a program's values; see enclosure.h. */
#include "enclosure.h"

#include "../program/evaluate.h"
#include "affine.h"

#include <stdlib.h>

enum { ROUNDS = 2, TOLD = 3 };

/* Encloses the values between those at the ends, with the error of C's function. */
struct interval function_range(enum op_kind kind, struct interval x)
{
    const struct unary *f = op_unary(kind);
    if (!f->rising || (x.lo < 0 && !f->negative))
        return interval_whole();
    struct interval y = {point_operation(kind, x.lo, 0), point_operation(kind, x.hi, 0)};
    for (int i = 0; i < f->error; i += 2)
        y = (struct interval){below(y.lo), above(y.hi)};
    return (struct interval){f->root > 0 && x.lo >= 0 ? greater(0, y.lo) : y.lo, y.hi};
}

/* If two numbers are exact, encloses their sum or product exactly when it is a number of the arithmetic. */
static struct interval sum_of(struct interval a, struct interval b)
{
    const double x = a.lo + b.lo;
    return a.lo == a.hi && b.lo == b.hi && sum_is_exact(a.lo, b.lo, x) ? interval_point(x) : interval_add(a, b);
}

static struct interval product_of(struct interval a, struct interval b)
{
    const double x = a.lo * b.lo;
    return a.lo == a.hi && b.lo == b.hi && product_is_exact(a.lo, b.lo, x) ? interval_point(x)
                                                                           : interval_multiply(a, b);
}

static struct interval range_of(const struct forms *w, const struct op *op, const struct interval *box)
{
    const struct interval none = {0, 0}, *a = op->a >= 0 ? &w->range[op->a] : &none;
    const struct interval *b = op->b >= 0 ? &w->range[op->b] : &none;
    switch (op->kind) {
    case OP_CONSTANT:
        break;
    case OP_INPUT: {
        const size_t k = w->known->variable[op->input];
        return k < w->known->variables ? box[k] : interval_whole();
    }
    case OP_NEG:
        return interval_negative(*a);
    case OP_ADD:
        return sum_of(*a, *b);
    case OP_SUB:
        return sum_of(*a, interval_negative(*b));
    case OP_MUL:
        return op->squared && a->lo < a->hi ? interval_square(*a) : product_of(*a, *b);
    case OP_DIV:
    case OP_PDIV:
        return interval_divide(*a, *b);
    case OP_ABS:
        return interval_absolute(*a);
    case OP_MIN:
        return interval_minimum(*a, *b);
    case OP_MAX:
        return interval_maximum(*a, *b);
    default:
        return function_range(op->kind, *a);
    }
    return interval_whole();
}

/* Adds the rounding error. Rounding to nearest keeps the sign or gives 0. */
static struct interval rounded(const struct arithmetic *a, double share, struct interval x)
{
    const double lo = below(x.lo - above(share * fabs(x.lo) + a->least));
    const double hi = above(x.hi + above(share * fabs(x.hi) + a->least));
    return (struct interval){x.lo >= 0       ? greater(lo, 0)
                             : lo < -a->most ? -INFINITY
                                             : lo,
                             x.hi <= 0      ? lesser(hi, 0)
                             : hi > a->most ? INFINITY
                                            : hi};
}

struct interval *computed_ranges(const struct known *x, const struct interval *box, size_t ops)
{
    struct forms w = {.known = x, .range = new_array(ops, sizeof *w.range)};
    for (size_t i = 0; i < ops; i++) {
        const struct op *o = &x->program->op[i];
        const bool fixed = o->kind == OP_CONSTANT || (o->kind == OP_INPUT && x->variable[o->input] == x->variables);
        const struct interval exact = fixed ? x->value[i] : range_of(&w, o, box);
        w.range[i] =
            x->place ? interval_whole()
                     : rounded(&x->arithmetic, o->kind == OP_INPUT ? x->arithmetic.given : x->arithmetic.unit, exact);
    }
    return w.range;
}

/* Narrows operation i to x, and its twin accordingly. */
static void tighten(struct forms *w, int i, struct interval x)
{
    const int twin = w->twin[i];
    w->range[i] = interval_meet(w->range[i], x);
    if (twin >= 0)
        w->range[twin] = interval_meet(w->range[twin], interval_divide(w->range[i], w->ratio[i]));
}

/* Propagates a narrower range of operation i to its operands, down to some depth. */
static void tell(struct forms *w, int i, struct interval x, int depth)
{
    const struct op *op = &w->known->program->op[i];
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
        affine_shift(w, (size_t)op->a, (size_t)op->b, y);
        tell(w, op->a, interval_add(y, b), depth - 1);
        tell(w, op->b, interval_subtract(a, y), depth - 1);
        break;
    case OP_MUL:
        if (op->squared) {
            const double most = above(sqrt(greater(0, y.hi)));
            tell(w, op->a, (struct interval){-most, most}, depth - 1);
            break;
        }
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

static bool evaluate(struct forms *w, const struct interval *box, bool affine)
{
    const struct known *x = w->known;
    w->inside = true;
    for (size_t n = 0; n < w->needs; n++) {
        const size_t i = (size_t)w->needed[n];
        w->range[i] = interval_meet(range_of(w, &x->program->op[i], box), x->value[i]);
        if (is_empty(w->range[i]))
            return false;
        if (affine)
            affine_set(w, i);
        if (w->twin[i] >= 0) {
            w->range[i] = interval_meet(w->range[i], interval_multiply(w->range[w->twin[i]], w->ratio[i]));
            if (affine)
                affine_adopt(w, i, (size_t)w->twin[i], w->ratio[i]);
            if (i >= x->first)
                tell(w, (int)i, w->range[i], TOLD);
        }
        if (w->required[i]) {
            w->inside = w->inside && w->range[i].lo > 0;
            if (!(w->range[i].hi > 0))
                return false;
            tell(w, (int)i, (struct interval){0, INFINITY}, FORMS_DEPTH);
        }
        if (is_empty(w->range[i]))
            return false;
    }
    return true;
}

bool forms_evaluate(struct forms *w, const struct interval *box)
{
    return evaluate(w, box, w->affine);
}

/* The forms belong to another box. */
bool forms_hold_at(struct forms *w, const struct interval *point)
{
    const bool affine = w->affine;
    w->affine = false;
    const bool hold = evaluate(w, point, false) && w->inside;
    w->affine = affine;
    return hold;
}

bool box_is_empty(const struct interval *box, size_t variables)
{
    for (size_t k = 0; k < variables; k++)
        if (is_empty(box[k]))
            return true;
    return false;
}

/* Repeats, because narrowing by one require may let others narrow further. */
bool forms_evaluate_narrowed(struct forms *w, struct interval *box)
{
    const struct program *p = w->known->program;
    for (int round = 0; round < ROUNDS; round++) {
        bool cut = false;
        if (!forms_evaluate(w, box))
            return false;
        for (size_t i = 0; i < p->outputs && !w->inside; i++)
            cut = affine_narrow(w, p->output[i], 1, 0, box) || cut;
        if (box_is_empty(box, w->known->variables))
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
