/* The region of a program's inputs; see region.h. */
#include "region.h"

#include "../program/evaluate.h"
#include "box_queue.h"
#include "enclosure.h"

#include <stdlib.h>
#include <string.h>

/* Returns memory for the values of a program's operations, with constants filled in; NULL without a program. */
static double *last_values(const struct program *p)
{
    double *value = p ? new_array(p->ops, sizeof *value) : NULL;
    if (p)
        point_constants(p, value);
    return value;
}

struct region *region_new(const struct genome_file *f, const struct program *p, bool shapes)
{
    struct region *r = new_array(1, sizeof *r);
    struct known *x = known_new(f, p, shapes);
    const struct genome_range *range = x->place ? f->region->range : f->range;
    *r = (struct region){.known = x, .doubles = new_array(x->inputs, sizeof *r->doubles)};
    for (size_t i = 0; i < x->inputs; i++) {
        r->doubles[i] = interval_whole();
        if (range[i].given)
            r->doubles[i] = (struct interval){double_nearest(&x->lo[i]), double_nearest(&x->hi[i])};
    }
    r->required = forms_new(x, NULL, 0);
    r->place = last_values(x->place);
    return r;
}

int region_op(const struct region *r, int op)
{
    return known_op(r->known, op);
}

void region_free(struct region *r)
{
    if (!r)
        return;
    forms_free(r->required);
    free(r->doubles);
    free(r->place);
    known_free(r->known);
    free(r);
}

void region_box(const struct region *r, struct interval *box)
{
    for (size_t k = 0; k < r->known->variables; k++)
        box[k] = r->known->range[r->known->input[k]];
}

bool region_holds(struct region *r, const struct interval *box)
{
    return r->known->program->outputs == 0 || (forms_evaluate(r->required, box) && r->required->inside);
}

double region_width(const struct region *r, size_t variable, struct interval side)
{
    const struct interval range = r->known->range[r->known->input[variable]];
    const double width = 0.5 * side.hi - 0.5 * side.lo, whole = 0.5 * range.hi - 0.5 * range.lo;
    const double part = interval_finite(range) ? width / whole : width;
    return part > 0x1p-40 ? part : 0;
}

static size_t widest_side(const struct region *r, const struct interval *box)
{
    size_t widest = 0;
    for (size_t k = 1; k < r->known->variables; k++)
        if (region_width(r, k, box[k]) > region_width(r, widest, box[widest]))
            widest = k;
    return widest;
}

bool region_is_empty(struct region *r, long boxes)
{
    struct boxes waiting = {.variables = r->known->variables};
    struct interval *box = new_array(r->known->variables, sizeof *box),
                    *part = new_array(r->known->variables, sizeof *part);
    region_box(r, part);
    bool empty = r->known->program->outputs > 0;
    if (empty && forms_evaluate_narrowed(r->required, part))
        boxes_push(&waiting, 0, part);
    for (long i = 0; empty && waiting.n > 0; i++) {
        boxes_pop(&waiting, box);
        for (size_t k = 0; k < r->known->variables; k++)
            part[k] = interval_point(interval_middle(box[k]));
        const size_t side = widest_side(r, box);
        empty = i < boxes && r->known->variables > 0 && region_width(r, side, box[side]) > 0 && !region_holds(r, part);
        for (int half = 0; half < 2 && empty; half++) {
            box_half(box, r->known->variables, side, half, part);
            if (forms_evaluate_narrowed(r->required, part))
                boxes_push(&waiting, 0, part);
        }
    }
    boxes_free(&waiting);
    free(box);
    free(part);
    return empty;
}

/* ---- points ---- */

/* Returns all inputs of the region block, or of the file. The caller frees it. */
static double *own_inputs(const struct region *r, const double *at)
{
    const struct known *x = r->known;
    double *own = new_array(x->inputs, sizeof *own);
    for (size_t i = 0; i < x->inputs; i++) {
        const struct interval range = r->doubles[i];
        const double fixed = interval_finite(range) ? range.lo : 0;
        own[i] = x->variable[i] < x->variables ? fmin(fmax(at[x->variable[i]], range.lo), range.hi) : fixed;
    }
    return own;
}

void region_inputs(const struct region *r, const double *at, double *input)
{
    const struct known *x = r->known;
    double *own = own_inputs(r, at);
    if (x->place) {
        point_double(x->place, own, NULL, r->place);
        for (size_t i = 0; i < x->places; i++)
            input[i] = r->place[x->place->output[i]];
    } else
        memcpy(input, own, x->inputs * sizeof *own);
    free(own);
}

/* Draws uniformly from the range, with random last bits even near 0. */
double region_draw_coordinate(const struct region *r, size_t variable, uint64_t *seed, int bits)
{
    struct interval range = r->doubles[r->known->input[variable]];
    if (!interval_finite(range))
        range = (struct interval){-1, 1};
    const double half = 0.5 * range.hi - 0.5 * range.lo;
    double x = range.lo + half * (2 * random_fraction(random_next(seed)));
    x += half * (random_fraction(random_next(seed)) * 0x1p-51);
    if (bits > 0 && half > 0) {
        const double step = ldexp(1, ilogb(half) - bits);
        x = step > 0 ? nearbyint(x / step) * step : x;
    }
    return fmin(fmax(x, range.lo), range.hi);
}

bool region_draw(struct region *r, uint64_t *seed, int bits, long *tries, double *at)
{
    struct interval *box = new_array(r->known->variables, sizeof *box);
    bool found = false;
    while (!found && (*tries)-- > 0) {
        for (size_t k = 0; k < r->known->variables; k++) {
            at[k] = region_draw_coordinate(r, k, seed, bits);
            box[k] = interval_point(at[k]);
        }
        found = r->known->program->outputs == 0 || forms_hold_at(r->required, box);
    }
    free(box);
    return found;
}
