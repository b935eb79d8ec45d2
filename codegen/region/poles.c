/* Branch and bound for the zeros of a denominator D over a region; see poles.h.
 *
 * A box is done if D exceeds a target everywhere in it. Any other box is narrowed to where D may be within the target,
 * and halved. The target is a fraction of the least |D| seen at points of the region: tiny at first; more once D is
 * known to have no zero. D has a zero if
 *
 *   - it is 0 in exact rational arithmetic at a point of the region (corners, centres and simple points are tried), or
 *   - a box lies in the region, all operations in D are finite over it, so that D is continuous, and D has two signs,
 *     certain in interval arithmetic, at two of its points. */
#include "poles.h"

#include "../program/evaluate.h"
#include "affine.h"
#include "box_queue.h"
#include "enclosure.h"

#include <stdlib.h>
#include <string.h>

enum { KINDS = 5, RANDOM_POINTS = 64, RANDOM_TRIES = 20000, NARROWINGS = 3, BISECTIONS = 60 };

struct pole_search {
    struct region *region;
    struct forms *forms;
    int op;
    double nearest, share; /* least |D| seen; the target's fraction of it */
    double least;          /* lower bound of |D| in finished boxes and in parts cut off */
    long halved;           /* number of boxes halved */
    long draws;            /* number of random points */
    bool below, above;     /* D < 0, D > 0 somewhere in a finished box */
    struct pole pole;
    struct boxes boxes;
    struct interval *box, *part, *thin; /* owned */
    double *at, *other;                 /* owned: points */
};

static size_t sides(const struct pole_search *s)
{
    return s->region->known->variables;
}

static struct interval value(const struct pole_search *s)
{
    return s->forms->range[s->op];
}

static double target(const struct pole_search *s)
{
    return s->nearest < INFINITY ? fmax(s->share * s->nearest, DBL_MIN) : DBL_MIN;
}

/* Evaluates D at a point, which is left in `thin`; returns false if the point is certainly outside the region. */
static bool evaluate_at(struct pole_search *s, const double *at)
{
    for (size_t k = 0; k < sides(s); k++)
        s->thin[k] = interval_point(at[k]);
    return forms_evaluate(s->forms, s->thin);
}

/* ---- zeros ---- */

static void set_witness(struct pole_search *s, const double *at)
{
    s->pole = (struct pole){.verdict = POLE_EXISTS, .witness = new_array(sides(s), sizeof *s->pole.witness)};
    if (sides(s) > 0)
        memcpy(s->pole.witness, at, sides(s) * sizeof *at);
}

/* Converts a coordinate to a rational: at a rounded end of a range, the end itself. */
static void exact_coordinate(const struct known *known, size_t input, double x, fmpq *q)
{
    double_rational(q, x);
    if (fmpq_cmp(q, &known->lo[input]) < 0)
        fmpq_set(q, &known->lo[input]);
    if (fmpq_cmp(q, &known->hi[input]) > 0)
        fmpq_set(q, &known->hi[input]);
}

static bool is_exact_zero(struct pole_search *s, const double *at)
{
    const struct known *x = s->region->known;
    const size_t ops = (size_t)s->op + 1;
    fmpq *point = _fmpq_vec_init((slong)x->inputs), *exact = _fmpq_vec_init((slong)ops);
    bool *defined = new_array(ops, sizeof *defined);
    for (size_t i = 0; i < x->inputs; i++)
        fmpq_set(&point[i], &x->lo[i]);
    for (size_t k = 0; k < sides(s); k++) {
        exact_coordinate(x, x->input[k], at[k], &point[x->input[k]]);
        s->thin[k] = interval_around(&point[x->input[k]]);
    }
    bool zero = region_holds(s->region, s->thin);
    if (zero) {
        point_rational(x->program, ops, point, exact, defined);
        zero = defined[s->op] && fmpq_is_zero(&exact[s->op]);
    }
    _fmpq_vec_clear(point, (slong)x->inputs);
    _fmpq_vec_clear(exact, (slong)ops);
    free(defined);
    return zero;
}

/* Visits a point; returns true if it is in the region and D is 0 there. */
static bool visit(struct pole_search *s, const double *at)
{
    if (!evaluate_at(s, at))
        return false;
    const struct interval d = value(s);
    if (!interval_has(d, 0)) {
        if (interval_finite(d) && interval_least(d) < s->nearest && region_holds(s->region, s->thin))
            s->nearest = interval_least(d);
        return false;
    }
    if (!s->region->known->complete || !is_exact_zero(s, at))
        return false;
    set_witness(s, at);
    return true;
}

/* Bisects between two points with opposite signs. */
static void bisect(struct pole_search *s, double *low, double *high)
{
    double *middle = new_array(sides(s), sizeof *middle);
    for (int i = 0; i < BISECTIONS; i++) {
        for (size_t k = 0; k < sides(s); k++)
            middle[k] = 0.5 * low[k] + 0.5 * high[k];
        if (!evaluate_at(s, middle) || interval_has(value(s), 0))
            break;
        memcpy(value(s).hi < 0 ? low : high, middle, sides(s) * sizeof *middle);
    }
    set_witness(s, middle);
    free(middle);
}

/* Finds the corner of a box, just evaluated, where the linear part of D is least (sign -1) or most (1). */
static void extreme_corner(const struct pole_search *s, const struct interval *box, int sign, double *corner)
{
    const double *slope = s->forms->slope + (size_t)s->op * sides(s);
    for (size_t k = 0; k < sides(s); k++)
        corner[k] = s->forms->affine && sign * slope[k] > 0 ? box[k].hi : box[k].lo;
}

/* Searches for a zero inside a box, just evaluated. */
static bool zero_inside(struct pole_search *s, const struct interval *box)
{
    const bool continuous = forms_finite(s->forms) && region_holds(s->region, box);
    extreme_corner(s, box, -1, s->at);
    extreme_corner(s, box, 1, s->other);
    if (continuous && evaluate_at(s, s->at) && value(s).hi < 0 && evaluate_at(s, s->other) && value(s).lo > 0) {
        bisect(s, s->at, s->other);
        return true;
    }
    return visit(s, s->at) || visit(s, s->other);
}

/* Returns a simple number of a range: middle, ends, and the nearest to 0 and to `common`. */
static double simple_number(struct interval range, size_t which, double common)
{
    switch (which) {
    case 0:
        return interval_middle(range);
    case 1:
        return range.lo;
    case 2:
        return range.hi;
    case 3:
        return fmin(fmax(0, range.lo), range.hi);
    default:
        return fmin(fmax(common, range.lo), range.hi);
    }
}

/* Tries points of simple numbers: all of them, or each of one kind and some mixtures. */
static bool zero_at_simple_point(struct pole_search *s, size_t most)
{
    const struct known *x = s->region->known;
    struct interval all = interval_whole();
    size_t points = 1;
    uint64_t seed = 0;
    for (size_t k = 0; k < sides(s); k++) {
        all = interval_meet(all, x->range[x->input[k]]);
        points = points > most ? points : KINDS * points;
    }
    for (size_t i = 0; i < points && i < most; i++) {
        size_t code = i;
        for (size_t k = 0; k < sides(s); k++, code /= KINDS) {
            const size_t mixed = (size_t)(random_next(&seed) >> 32);
            const size_t which = points <= most ? code : i < KINDS ? i : mixed;
            s->at[k] = simple_number(x->range[x->input[k]], which % KINDS, interval_middle(all));
        }
        if (visit(s, s->at))
            return true;
    }
    return false;
}

/* Tries random points of the region, for a first target. */
static bool zero_at_random_point(struct pole_search *s)
{
    uint64_t seed = 1;
    long tries = RANDOM_TRIES;
    bool found = false;
    for (int i = 0; i < RANDOM_POINTS && !found && region_draw(s->region, &seed, 6, &tries, s->at); i++)
        found = visit(s, s->at);
    s->draws = RANDOM_TRIES - tries;
    return found;
}

/* ---- branch and bound ---- */

/* Returns true if D exceeds the target everywhere in the box, or the box has no point of the region. Otherwise narrows
 * the box. */
static bool is_done(struct pole_search *s, struct interval *box)
{
    for (int i = 0;; i++) {
        if (!forms_evaluate_narrowed(s->forms, box))
            return true;
        const struct interval d = value(s);
        s->above = s->above || d.lo > target(s);
        s->below = s->below || d.hi < -target(s);
        if (d.lo > target(s) || d.hi < -target(s)) {
            s->least = fmin(s->least, interval_least(d));
            return true;
        }
        if (i == NARROWINGS)
            return false;
        const bool above = affine_narrow(s->forms, s->op, -1, target(s), box);
        const bool below = affine_narrow(s->forms, s->op, 1, -target(s), box);
        s->above = s->above || above;
        s->below = s->below || below;
        if (above || below)
            s->least = fmin(s->least, target(s));
        if (box_is_empty(box, sides(s)))
            return true;
        if (!above && !below)
            return false;
    }
}

/* Returns the key of a box; boxes in which 0 is closest to the middle of D's values come first. */
static double key_of(struct interval d)
{
    return interval_finite(d) ? -fabs(interval_middle(d)) : 0;
}

/* Queues a part of the last box unless it is done; returns true if it shows a zero. */
static bool offer(struct pole_search *s, struct interval *box)
{
    if (is_done(s, box))
        return false;
    boxes_push(&s->boxes, key_of(value(s)), box);
    return s->region->known->complete && s->forms->inside && zero_inside(s, box);
}

/* Chooses the variable that, fixed to a point, moves D farthest from 0; of equals, the variable with the widest
 * side. */
static size_t choose_variable(struct pole_search *s)
{
    const size_t n = sides(s);
    size_t best = n;
    double most = 0, widest = 0;
    memcpy(s->part, s->box, n * sizeof *s->part);
    for (size_t k = 0; k < n; k++) {
        const double width = region_width(s->region, k, s->box[k]);
        if (width == 0)
            continue;
        s->part[k] = interval_point(interval_middle(s->box[k]));
        const double far = forms_evaluate(s->forms, s->part) ? fmax(value(s).lo, -value(s).hi) : INFINITY;
        s->part[k] = s->box[k];
        if (best == n || far > most || (far == most && width > widest)) {
            best = k;
            most = far;
            widest = width;
        }
    }
    return best;
}

/* Explores boxes; returns the verdict, POLE_UNDECIDED if the boxes are used up. */
static enum pole_verdict explore(struct pole_search *s, long boxes)
{
    s->below = s->above = false;
    s->least = DBL_MAX;
    region_box(s->region, s->part);
    if (offer(s, s->part))
        return POLE_EXISTS;
    for (s->halved = 0; s->halved < boxes && s->boxes.n > 0; s->halved++) {
        boxes_pop(&s->boxes, s->box);
        const size_t k = choose_variable(s);
        if (k == sides(s))
            return POLE_UNDECIDED;
        for (size_t j = 0; j < sides(s); j++)
            s->at[j] = interval_middle(s->box[j]);
        if (visit(s, s->at))
            return POLE_EXISTS;
        for (int half = 0; half < 2; half++) {
            box_half(s->box, sides(s), k, half, s->part);
            if (offer(s, s->part))
                return POLE_EXISTS;
        }
    }
    return s->boxes.n > 0 ? POLE_UNDECIDED : POLE_FREE;
}

/* Finds the verdict, then better bounds as far as they cost little more work. */
static void find(struct pole_search *s, long boxes)
{
    static const double share[] = {0x1p-20, 0.5, 0.95};
    if (zero_at_simple_point(s, (size_t)boxes / 4) || zero_at_random_point(s))
        return;
    for (size_t i = 0; i < sizeof share / sizeof *share; i++) {
        s->share = share[i];
        const enum pole_verdict verdict = explore(s, i == 0 ? boxes : 4 * s->halved + boxes / 10);
        boxes_free(&s->boxes);
        if (verdict != POLE_FREE)
            break;
        s->pole = (struct pole){.verdict = POLE_FREE, .least = fmax(s->least, s->pole.least)};
        s->pole.values = (struct interval){s->below ? -INFINITY : s->pole.least, s->above ? INFINITY : -s->pole.least};
    }
}

struct pole pole_find(struct region *r, int op, long boxes)
{
    struct pole_search s = {.region = r, .op = op, .nearest = INFINITY, .boxes.variables = r->known->variables};
    s.pole = (struct pole){.verdict = POLE_UNDECIDED, .values = interval_whole()};
    s.forms = forms_new(r->known, &op, 1);
    s.box = new_array(r->known->variables, sizeof *s.box);
    s.part = new_array(r->known->variables, sizeof *s.part);
    s.thin = new_array(r->known->variables, sizeof *s.thin);
    s.at = new_array(r->known->variables, sizeof *s.at);
    s.other = new_array(r->known->variables, sizeof *s.other);
    find(&s, boxes);
    forms_free(s.forms);
    free(s.box);
    free(s.part);
    free(s.thin);
    free(s.at);
    free(s.other);
    s.pole.draws = s.draws;
    return s.pole;
}
