/* Branch and bound over boxes; see rounding_bound.h. */
#include "rounding_bound.h"

#include "box_queue.h"
#include "enclosure.h"
#include "rounding.h"

#include <stdlib.h>
#include <string.h>

#define CLOSE 1.02 /* a bound so near to the errors at points is good enough */

struct search {
    struct region *region;
    struct rounding *rounding;
    struct interval values; /* of the operation, in the boxes left at the end */
    double reached;         /* the largest bound at a point of the region: none for all of it can be less */
    struct boxes boxes;
    struct interval *box, *part; /* owned */
};

static void offer(struct search *s, struct interval *box)
{
    if (!forms_evaluate_narrowed(s->rounding->forms, box))
        return;
    boxes_push(&s->boxes, rounding_error(s->rounding), box);
}

/* Takes in the values over a box. */
static void collect(struct search *s, const struct interval *box)
{
    if (!forms_evaluate(s->rounding->forms, box))
        return;
    const struct interval x = s->rounding->forms->range[s->rounding->op];
    s->values = (struct interval){lesser(s->values.lo, x.lo), greater(s->values.hi, x.hi)};
}

static void visit_middle(struct search *s)
{
    for (size_t k = 0; k < s->region->known->variables; k++)
        s->part[k] = interval_point(interval_middle(s->box[k]));
    const double error = forms_evaluate(s->rounding->forms, s->part) ? rounding_error(s->rounding) : 0;
    if (error > s->reached && region_holds(s->region, s->part))
        s->reached = error;
}

/* The variable which, made a point, leaves the least error; of equals, that of the widest side. */
static size_t choose_variable(struct search *s)
{
    const size_t n = s->region->known->variables;
    size_t best = n;
    double least = 0, widest = 0;
    memcpy(s->part, s->box, n * sizeof *s->part);
    for (size_t k = 0; k < n; k++) {
        const double width = region_width(s->region, k, s->box[k]);
        if (width == 0)
            continue;
        s->part[k] = interval_point(interval_middle(s->box[k]));
        const double error = forms_evaluate(s->rounding->forms, s->part) ? rounding_error_again(s->rounding) : 0;
        s->part[k] = s->box[k];
        if (best == n || error < least || (error == least && width > widest)) {
            best = k;
            least = error;
            widest = width;
        }
    }
    return best;
}

double bound_error(struct region *r, int op, long boxes, double *work)
{
    struct forms *w = forms_new(r->known, op);
    struct search s = {.region = r, .rounding = rounding_new(w, op), .values = {INFINITY, -INFINITY}};
    const double variables =
        (double)r->known->variables; /* for each of these an evaluation, to and fro, and some more */
    const double box_work = (double)w->needs * (variables + 4) * (variables + 16);
    double bound = 0;
    s.boxes.variables = r->known->variables;
    s.box = new_array(r->known->variables, sizeof *s.box);
    s.part = new_array(r->known->variables, sizeof *s.part);
    region_box(r, s.part);
    offer(&s, s.part);
    for (; s.boxes.n > 0; boxes--, *work -= box_work) {
        bound = boxes_pop(&s.boxes, s.box);
        visit_middle(&s);
        const size_t k =
            boxes > 0 && *work > 0 && !(bound <= CLOSE * s.reached) ? choose_variable(&s) : r->known->variables;
        if (k == r->known->variables) {
            collect(&s, s.box);
            break;
        }
        for (int half = 0; half < 2; half++) {
            box_half(s.box, r->known->variables, k, half, s.part);
            offer(&s, s.part);
        }
    }
    while (s.boxes.n > 0) {
        boxes_pop(&s.boxes, s.box);
        collect(&s, s.box);
    }
    r->known->error[op] = lesser(bound, r->known->error[op]);
    if (s.values.lo <= s.values.hi)
        r->known->value[op] = interval_meet(r->known->value[op], s.values);
    boxes_free(&s.boxes);
    rounding_free(s.rounding);
    forms_free(w);
    free(s.box);
    free(s.part);
    return bound;
}

double bound_error_at(const struct region *r, int op, const double *input)
{
    struct forms *w = forms_new(r->known, op);
    struct rounding *e = rounding_new(w, op);
    struct interval *box = new_array(r->known->variables, sizeof *box);
    for (size_t k = 0; k < r->known->variables; k++)
        box[k] = interval_point(input[r->known->input[k]]);
    const double bound = forms_evaluate(w, box) ? rounding_error(e) : INFINITY;
    rounding_free(e);
    forms_free(w);
    free(box);
    return bound;
}
