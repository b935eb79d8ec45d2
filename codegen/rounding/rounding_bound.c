/* Branch and bound over boxes; see rounding_bound.h. */
#include "rounding_bound.h"

#include "../region/box_queue.h"
#include "../region/enclosure.h"
#include "rounding.h"

#include <stdlib.h>
#include <string.h>

enum { MIDDLES = 8, TRIED = 5, FIRST_JUDGED = 32 };
#define CLOSE 1.02     /* a bound this close to the errors at points is good enough */
#define LEAST_PACE 0.1 /* factors of 2 that a doubling of the boxes must gain */

struct bound_search {
    struct region *region;
    struct rounding *rounding;
    double reached; /* the largest bound at a point of the region, below which no bound can fall */
    struct boxes boxes;
    struct interval *box, *part; /* owned */
    double *share;               /* owned: by variable */
};

static double error_of(struct rounding *e)
{
    double error;
    rounding_errors(e, &error);
    return error;
}

static void offer(struct bound_search *s, struct interval *box)
{
    if (!forms_evaluate_narrowed(s->rounding->forms, box))
        return;
    boxes_push(&s->boxes, error_of(s->rounding), box);
}

static void visit_middle(struct bound_search *s)
{
    for (size_t k = 0; k < s->region->known->variables; k++)
        s->part[k] = interval_point(interval_middle(s->box[k]));
    const double error = forms_evaluate(s->rounding->forms, s->part) ? error_of(s->rounding) : 0;
    if (error > s->reached && region_holds(s->region, s->part))
        s->reached = error;
}

/* Computes how much each variable varies the values of the program, all values weighted equally. */
static void find_shares(struct bound_search *s)
{
    const struct forms *w = s->rounding->forms;
    const size_t n = s->region->known->variables;
    for (size_t k = 0; k < n; k++)
        s->share[k] = region_width(s->region, k, s->box[k]) > 0 ? 0 : -1;
    for (size_t m = 0; w->affine && m < w->needs; m++) {
        const size_t i = (size_t)w->needed[m];
        const double size = fabs(w->centre[i]) + w->mass[i] + w->radius[i];
        for (size_t k = 0; k < n && size > 0 && size < INFINITY; k++)
            s->share[k] += s->share[k] < 0 ? 0 : fabs(w->slope[i * n + k]) / size;
    }
}

static size_t largest_share(const struct bound_search *s)
{
    size_t best = 0;
    for (size_t k = 1; k < s->region->known->variables; k++)
        best = s->share[k] > s->share[best] ? k : best;
    return best;
}

/* Chooses, among the variables with the largest shares, the variable that leaves the least error when fixed to a point.
 * Returns the number of variables if no side is left to halve. */
static size_t choose_variable(struct bound_search *s)
{
    const size_t n = s->region->known->variables;
    size_t best = n;
    double least = INFINITY;
    find_shares(s);
    memcpy(s->part, s->box, n * sizeof *s->part);
    for (int i = 0; i < TRIED; i++) {
        const size_t k = largest_share(s);
        if (n == 0 || s->share[k] < 0)
            break;
        s->share[k] = -1;
        s->part[k] = interval_point(interval_middle(s->box[k]));
        const double error = forms_evaluate(s->rounding->forms, s->part) ? error_of(s->rounding) : 0;
        s->part[k] = s->box[k];
        if (best == n || error < least) {
            best = k;
            least = error;
        }
    }
    return best;
}

static double joints(const struct rounding *e)
{
    double n = 0;
    for (size_t i = 0; i < e->needs; i++)
        n += e->forms->known->joint[e->needed[i]];
    return n;
}

/* Returns true if continuing is useless, judged whenever the boxes have doubled: at this pace the bound cannot become
 * useful in the remaining doublings, or it is useful and hardly falls any more. */
static bool is_hopeless(double before, double bound, double useful, double doublings)
{
    if (before == INFINITY)
        return false;
    const double pace = log2(before / bound);
    return bound > useful ? pace * doublings < log2(bound / useful) : pace < LEAST_PACE;
}

double bound_error(struct region *r, int op, struct bound_goal goal, long boxes, double *work)
{
    struct forms *w = forms_new(r->known, &op, 1);
    struct bound_search s = {.region = r, .rounding = rounding_new(w, &op, 1)};
    const size_t n = r->known->variables;
    /* evaluations for the variables tried, and a backward pass from each joint */
    const double box_work = (double)w->needs * 14 * ((double)n + 16) * (1 + joints(s.rounding) / 40.0);
    double bound = 0, before = INFINITY;
    long next = FIRST_JUDGED;
    s.boxes.variables = n;
    s.box = new_array(n, sizeof *s.box);
    s.part = new_array(n, sizeof *s.part);
    s.share = new_array(n, sizeof *s.share);
    region_box(r, s.part);
    offer(&s, s.part);
    for (long halved = 0; s.boxes.n > 0; halved++, *work -= box_work) {
        bound = boxes_pop(&s.boxes, s.box);
        if (halved % MIDDLES == 0)
            visit_middle(&s);
        const double useful = s.reached > goal.useful ? goal.threshold : goal.useful;
        if (halved >= boxes || *work <= 0 || bound <= fmax(goal.enough, CLOSE * s.reached) || s.reached > useful ||
            !forms_evaluate(w, s.box))
            break;
        if (halved == next) {
            const double most = fmin((double)boxes, (double)halved + *work / box_work);
            const double doublings = log2(most / (double)halved);
            if (is_hopeless(before, bound, useful, doublings) &&
                (bound <= goal.threshold || is_hopeless(before, bound, goal.threshold, doublings)))
                break;
            before = bound;
            next *= 2;
        }
        const size_t k = choose_variable(&s);
        if (k == n)
            break;
        for (int half = 0; half < 2; half++) {
            box_half(s.box, n, k, half, s.part);
            offer(&s, s.part);
        }
    }
    boxes_free(&s.boxes);
    rounding_free(s.rounding);
    forms_free(w);
    free(s.box);
    free(s.part);
    free(s.share);
    return bound;
}

/* Returns the outputs of the program as operations of the region's. The caller frees it. */
static int *outputs_of(const struct region *r, const struct program *p)
{
    int *op = new_array(p->outputs, sizeof *op);
    for (size_t i = 0; i < p->outputs; i++)
        op[i] = region_op(r, p->output[i]);
    return op;
}

struct point_bound {
    struct forms *forms;       /* owned */
    struct rounding *rounding; /* owned */
    struct interval *box;      /* owned */
};

struct point_bound *point_bound_new(const struct region *r, const struct program *p)
{
    struct point_bound *b = new_array(1, sizeof *b);
    int *op = outputs_of(r, p);
    b->forms = forms_new(r->known, op, p->outputs);
    b->forms->affine = false; /* nothing varies, so nothing could cancel */
    b->rounding = rounding_new(b->forms, op, p->outputs);
    b->box = new_array(r->known->variables, sizeof *b->box);
    free(op);
    return b;
}

void point_bound_at(struct point_bound *b, const double *at, double *error)
{
    for (size_t k = 0; k < b->forms->known->variables; k++)
        b->box[k] = interval_point(at[k]);
    if (forms_evaluate(b->forms, b->box))
        rounding_errors(b->rounding, error);
    else
        for (size_t i = 0; i < b->rounding->targets; i++)
            error[i] = INFINITY;
}

void point_bound_free(struct point_bound *b)
{
    rounding_free(b->rounding);
    forms_free(b->forms);
    free(b->box);
    free(b);
}
