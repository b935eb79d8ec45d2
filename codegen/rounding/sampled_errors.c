/* Random points and climbs; see sampled_errors.h.
 *
 * Errors are measured against pairs of doubles, at several points side by side. Only a point that looks worse than all
 * earlier points is evaluated exactly. If few points of the box belong to the region, each point is derived from the
 * last, of which it keeps from 0 to most coordinates. */
#include "sampled_errors.h"

#include "../program/evaluate.h"
#include "../program/evaluate_float.h"
#include "../program/evaluate_lanes.h"
#include "../program/genome_program.h"
#include "../region/enclosure.h"

#include <stdlib.h>
#include <string.h>

enum {
    TRIES = 50, /* attempts for a point */
    FIRST_TRIES = 200000,
    PARTS = 16,       /* of the walk; behind each, each output is climbed from the worst point of the part */
    CLIMBING = 16,    /* these climbs take one point in 16, as many as the climbs from the worst points of all parts */
    LAST_DIGITS = 52, /* a step of a climb changes between the whole range and its last digits */
    MOST_ODD = 1000   /* points without a computed number that are evaluated exactly */
};
#define MOST_VALUES 2e9 /* values computed: some seconds */

/* A sampled program. */
struct subject {
    struct arena arena;                /* of its arrays except lanes */
    const struct program *program;     /* not owned */
    const struct segment_kind *scaled; /* floats are relative to it; may be NULL */
    bool single;
    struct lanes_plan plan;           /* owned */
    struct lanes *value, *high, *low; /* owned: by place */
    struct lanes *computed[2];        /* owned: by output, without and with contraction */
    float *coordinate, *number;       /* owned: by input, twice, and operation */
    double *worst, **top;             /* owned: by output; the worst error of a part, and its point, by variable */
    double **peak;                    /* owned: by output; the point of the worst error of all parts */
    arb_ptr exact;                    /* owned: by output */
    long odd;
    struct sampled_errors *found; /* not owned */
};

struct sampler {
    struct arena arena;      /* of its arrays except lanes */
    struct region *region;   /* owned */
    struct subject *subject; /* owned */
    size_t subjects;
    struct lanes_plan shape;            /* owned: the exact part of the region's program */
    struct lanes *own, *required;       /* owned: by its inputs and places */
    struct lanes *input, *rounded;      /* owned: by input of the programs; in double and rounded to float */
    double *point[LANES], *pool[LANES]; /* owned: candidates, and points of the region; by variable */
    size_t pooled;
    struct interval *box; /* owned */
    double *at;           /* owned: by input of the programs */
    long tries;
    uint64_t random;
};

/* ---- points ---- */

/* Returns a bit for each candidate that is in the region, as far as rounded values show. Leaves their inputs in
 * `required`. */
static unsigned find_inside(struct sampler *s)
{
    const struct known *x = s->region->known;
    unsigned inside = (1U << LANES) - 1;
    for (size_t i = 0; i < x->inputs; i++)
        for (int l = 0; l < LANES; l++)
            s->own[i].at[l] = x->variable[i] < x->variables            ? s->point[l][x->variable[i]]
                              : interval_finite(s->region->doubles[i]) ? s->region->doubles[i].lo
                                                                       : 0;
    lanes_double(&s->shape, s->own, NULL, s->required);
    for (size_t i = 0; i < x->program->outputs; i++) {
        const double *require = s->required[s->shape.slot[x->program->output[i]]].at;
        for (unsigned l = 0; l < LANES; l++)
            inside &= require[l] > 0 ? ~0U : ~(1U << l);
    }
    return inside;
}

/* Moves candidates in the region to the pool, as long as there is room. */
static void pool_candidates(struct sampler *s)
{
    const struct known *x = s->region->known;
    unsigned inside = find_inside(s);
    s->tries -= LANES;
    for (size_t l = 0; l < LANES && s->pooled < LANES; l++) {
        if (!(inside >> l & 1))
            continue;
        for (size_t i = 0; i < x->places; i++)
            s->input[i].at[s->pooled] = s->required[s->shape.slot[x->placed[i]]].at[l];
        if (x->variables > 0)
            memcpy(s->pool[s->pooled], s->point[l], x->variables * sizeof(double));
        s->pooled++;
    }
}

/* Proposes candidates for the walk through the region; half of them have ends of ranges for a quarter of what changes. */
static void propose_anywhere(struct sampler *s, const double *from)
{
    static const double keep[] = {0, 0.5, 0.8, 0.95};
    for (int l = 0; l < LANES; l++)
        for (size_t k = 0; k < s->region->known->variables; k++) {
            const bool kept = random_fraction(random_next(&s->random)) < keep[l & 3];
            const struct interval range = s->region->doubles[s->region->known->input[k]];
            const uint64_t end = l & 4 && interval_finite(range) ? random_next(&s->random) % 8 : 2;
            s->point[l][k] = kept       ? from[k]
                             : end == 0 ? range.lo
                             : end == 1 ? range.hi
                                        : region_draw_coordinate(s->region, k, &s->random, 0);
        }
}

/* Proposes points with one coordinate changed, by up to its whole range or only in its last digits. */
static void propose_near(struct sampler *s, const double *from)
{
    const struct known *x = s->region->known;
    for (int l = 0; l < LANES; l++) {
        const size_t k = random_next(&s->random) % x->variables;
        const struct interval range = s->region->doubles[x->input[k]];
        const double part = (double)(random_next(&s->random) >> 11) * 0x1p-52 - 1;
        const double far = ldexp(part, -(int)(random_next(&s->random) % LAST_DIGITS)) * (range.hi - range.lo);
        memcpy(s->point[l], from, x->variables * sizeof *from);
        s->point[l][k] = fmin(fmax(from[k] + far, range.lo), range.hi);
    }
}

/* ---- errors ---- */

static void compute_floats(struct subject *s, const struct lanes *input, size_t n)
{
    const struct program *p = s->program;
    for (size_t l = 0; l < n; l++) {
        for (size_t i = 0; i < p->inputs; i++)
            s->coordinate[i] = (float)input[i].at[l];
        if (s->scaled)
            single_inputs(s->scaled, s->coordinate, s->coordinate + p->inputs);
        single_values(p, s->coordinate + (s->scaled ? p->inputs : 0), s->number);
        for (size_t i = 0; i < p->ops; i++)
            s->value[s->plan.slot[i]].at[l] = (double)s->number[i];
    }
}

/* Computes the outputs as the code does, and as pairs. */
static void compute(struct subject *s, const struct lanes *input, size_t n, uint64_t *random)
{
    const struct program *p = s->program;
    lanes_pairs(&s->plan, input, s->high, s->low);
    for (int contract = 1; contract >= 0; contract--) {
        if (s->single)
            compute_floats(s, input, n);
        else
            lanes_double(&s->plan, input, contract ? random : NULL, s->value);
        for (size_t i = 0; i < p->outputs; i++)
            s->computed[contract][i] = s->value[s->plan.slot[p->output[i]]];
    }
}

static double exact_error(double computed, const arb_t exact)
{
    arb_t d;
    arb_init(d);
    arb_set_d(d, computed);
    arb_sub(d, d, exact, 64);
    const double far = isfinite(computed) ? fabs(arf_get_d(arb_midref(d), ARF_RND_NEAR)) : INFINITY;
    arb_clear(d);
    return far;
}

/* Computes the exact outputs at a point of the pool; returns false if they are undefined or the point is not proved to
 * be in the region. */
static bool look_exactly(struct sampler *s, struct subject *of, const struct lanes *input, size_t l)
{
    const struct known *x = s->region->known;
    for (size_t k = 0; k < x->variables; k++)
        s->box[k] = interval_point(s->pool[l][k]);
    for (size_t i = 0; i < of->program->inputs; i++)
        s->at[i] = input[i].at[l];
    return (x->program->outputs == 0 || forms_hold_at(s->region->required, s->box)) &&
           point_exact(of->program, s->at, of->exact);
}

/* Returns true if the error of output i at a point looks worse than all earlier errors. */
static bool looks_worse(struct subject *s, size_t i, size_t l, double computed)
{
    const int at = s->plan.slot[s->program->output[i]];
    const double far = fabs((computed - s->high[at].at[l]) - s->low[at].at[l]);
    if (far <= s->worst[i])
        return false;
    return isfinite(far) || (s->worst[i] < INFINITY && s->odd++ < MOST_ODD);
}

static void take_errors(struct sampler *s, struct subject *of, const struct lanes *input, size_t l)
{
    bool exact = false;
    for (size_t i = 0; i < of->program->outputs; i++)
        for (int contract = 0; contract < 2; contract++) {
            const double computed = of->computed[contract][i].at[l];
            if (!looks_worse(of, i, l, computed))
                continue;
            if (!exact && !(exact = look_exactly(s, of, input, l)))
                return;
            const double far = exact_error(computed, of->exact + i);
            if (far > of->worst[i] && isfinite(far)) { /* results that are not finite have a status */
                of->worst[i] = far;
                memcpy(of->top[i], s->pool[l], s->region->known->variables * sizeof *of->top[i]);
            }
        }
}

/* Returns true if any error may be worse than all earlier errors; most points end here. */
static bool has_worse(const struct subject *s)
{
    int worse = 0;
    for (size_t i = 0; i < s->program->outputs; i++) {
        const int at = s->plan.slot[s->program->output[i]];
        const double *high = s->high[at].at, *low = s->low[at].at, worst = s->worst[i];
        for (int contract = 0; contract < 2; contract++) {
            const double *computed = s->computed[contract][i].at;
            for (size_t l = 0; l < LANES; l++)
                worse |= !(fabs((computed[l] - high[l]) - low[l]) <= worst);
        }
    }
    return worse;
}

/* Measures the errors of a program at the points of the pool. */
static void look(struct sampler *s, struct subject *of)
{
    const struct lanes *input = of->single ? s->rounded : s->input;
    for (size_t i = 0; of->single && i < of->program->inputs; i++)
        for (size_t l = 0; l < LANES; l++)
            s->rounded[i].at[l] = (float)s->input[i].at[l];
    compute(of, input, s->pooled, &s->random);
    if (!has_worse(of))
        return;
    for (size_t l = 0; l < s->pooled; l++)
        take_errors(s, of, input, l);
}

/* ---- the search ---- */

static void find_most(struct subject *s, size_t points)
{
    for (size_t i = 0; i < s->program->ops; i++) {
        const int divisor = s->program->op[i].kind == OP_DIV ? s->program->op[i].b : -1;
        for (size_t l = 0; divisor >= 0 && l < points; l++)
            s->found->most[divisor] = greater(s->found->most[divisor], fabs(s->value[s->plan.slot[divisor]].at[l]));
    }
}

/* Walks through the region; returns the number of points. */
static long walk(struct sampler *s, double *from, long most)
{
    long points = 0;
    for (s->tries = TRIES * most; points < most && s->tries > 0; s->pooled = 0) {
        while (s->pooled < LANES && s->tries > 0) {
            propose_anywhere(s, from);
            pool_candidates(s);
        }
        s->pooled = (long)s->pooled < most - points ? s->pooled : (size_t)(most - points);
        if (s->pooled > 0 && s->region->known->variables > 0)
            memcpy(from, s->pool[s->pooled - 1], s->region->known->variables * sizeof *from);
        for (size_t k = 0; k < s->subjects; k++) {
            look(s, &s->subject[k]);
            find_most(&s->subject[k], s->pooled);
        }
        points += (long)s->pooled;
    }
    s->pooled = 0;
    return points;
}

/* Climbs uphill from the point of an output's worst error. */
static void climb(struct sampler *s, struct subject *of, size_t output, long points)
{
    for (s->tries = points; s->tries > 0 && of->worst[output] > 0; s->pooled = 0) {
        while (s->pooled < LANES && s->tries > 0) {
            propose_near(s, of->top[output]);
            pool_candidates(s);
        }
        look(s, of);
    }
}

/* Climbs for each output from the worst point of a part of the walk, and begins the next part. */
static void end_part(struct subject *of, struct sampler *s, long points)
{
    for (size_t i = 0; i < of->program->outputs && s->region->known->variables > 0; i++) {
        climb(s, of, i, points);
        if (of->worst[i] > of->found->worst[i]) {
            of->found->worst[i] = of->worst[i];
            memcpy(of->peak[i], of->top[i], s->region->known->variables * sizeof *of->peak[i]);
        }
        of->worst[i] = 0;
    }
}

/* Climbs on for each output from the worst point of all parts. */
static void end_walk(struct subject *of, struct sampler *s, long points)
{
    for (size_t i = 0; i < of->program->outputs && s->region->known->variables > 0; i++) {
        of->worst[i] = of->found->worst[i];
        memcpy(of->top[i], of->peak[i], s->region->known->variables * sizeof *of->top[i]);
        climb(s, of, i, points);
        of->found->worst[i] = of->worst[i];
    }
}

static struct lanes_plan shape_plan(const struct known *x)
{
    bool *kept = new_array(x->first, sizeof *kept);
    for (size_t i = 0; i < x->program->outputs; i++)
        kept[x->program->output[i]] = true;
    for (size_t i = 0; i < x->places; i++)
        kept[x->placed[i]] = true;
    const struct lanes_plan plan = lanes_plan_new(x->program, x->first, kept);
    free(kept);
    return plan;
}

static struct lanes_plan program_plan(const struct program *p)
{
    bool *kept = new_array(p->ops, sizeof *kept);
    for (size_t i = 0; i < p->outputs; i++)
        kept[p->output[i]] = true;
    for (size_t i = 0; i < p->ops; i++)
        if (p->op[i].kind == OP_DIV)
            kept[p->op[i].b] = true;
    const struct lanes_plan plan = lanes_plan_new(p, p->ops, kept);
    free(kept);
    return plan;
}

static struct subject subject_new(const struct genome_file *f, const struct sampled *of, size_t variables,
                                  struct sampled_errors *found)
{
    const struct program *p = of->program;
    struct subject s = {.program = p, .plan = program_plan(p), .found = found};
    s.single = of->arithmetic.unit != arithmetic_double.unit;
    s.scaled = of->arithmetic.given > 0 ? f->segment : NULL;
    s.value = lanes_new(&s.plan, NULL);
    s.high = lanes_new(&s.plan, &s.low);
    s.coordinate = arena_array(&s.arena, 2 * p->inputs, sizeof *s.coordinate);
    s.number = arena_array(&s.arena, p->ops, sizeof *s.number);
    single_constants(p, s.number);
    for (int k = 0; k < 2; k++)
        s.computed[k] = arena_array(&s.arena, p->outputs, sizeof *s.computed[k]);
    s.worst = arena_array(&s.arena, p->outputs, sizeof *s.worst);
    s.top = arena_array(&s.arena, p->outputs, sizeof *s.top);
    s.peak = arena_array(&s.arena, p->outputs, sizeof *s.peak);
    for (size_t i = 0; i < p->outputs; i++) {
        s.top[i] = arena_array(&s.arena, variables, sizeof *s.top[i]);
        s.peak[i] = arena_array(&s.arena, variables, sizeof *s.peak[i]);
    }
    s.exact = _arb_vec_init((slong)p->outputs);
    found->worst = new_array(p->outputs, sizeof *found->worst);
    found->most = new_array(p->ops, sizeof *found->most);
    return s;
}

static void subject_free(struct subject *s)
{
    lanes_plan_free(&s->plan);
    free(s->value);
    free(s->high);
    free(s->low);
    arena_free(&s->arena);
    _arb_vec_clear(s->exact, (slong)s->program->outputs);
}

/* Returns the region of the inputs that any of the programs reads. */
static struct region *common_region(const struct genome_file *f, const struct sampled *of, size_t n)
{
    struct program *all = program_new(f, 0);
    for (size_t k = 0; k < n; k++)
        program_append(all, of[k].program, NULL);
    struct region *r = region_new(f, all, true);
    program_free(all);
    return r;
}

static struct sampler sampler_new(const struct genome_file *f, const struct sampled *of, size_t n,
                                  struct sampled_errors *found, unsigned long seed)
{
    struct sampler s = {.region = common_region(f, of, n), .subjects = n, .random = seed};
    const struct known *x = s.region->known;
    s.shape = shape_plan(x);
    s.own = arena_array(&s.arena, x->inputs, sizeof *s.own);
    s.required = lanes_new(&s.shape, NULL);
    s.input = arena_array(&s.arena, f->inputs, sizeof *s.input);
    s.rounded = arena_array(&s.arena, f->inputs, sizeof *s.rounded);
    for (int l = 0; l < LANES; l++) {
        s.point[l] = arena_array(&s.arena, x->variables, sizeof *s.point[l]);
        s.pool[l] = arena_array(&s.arena, x->variables, sizeof *s.pool[l]);
    }
    s.box = arena_array(&s.arena, x->variables, sizeof *s.box);
    s.at = arena_array(&s.arena, f->inputs, sizeof *s.at);
    s.subject = arena_array(&s.arena, n, sizeof *s.subject);
    for (size_t k = 0; k < n; k++)
        s.subject[k] = subject_new(f, &of[k], x->variables, &found[k]);
    return s;
}

static void sampler_free(struct sampler *s)
{
    for (size_t k = 0; k < s->subjects; k++)
        subject_free(&s->subject[k]);
    lanes_plan_free(&s->shape);
    free(s->required);
    arena_free(&s->arena);
    region_free(s->region);
}

/* Returns how many points there is time for. */
static long affordable(const struct sampler *s, long points)
{
    double ops = 0;
    for (size_t k = 0; k < s->subjects; k++)
        ops += (double)s->subject[k].program->ops;
    const double most = s->region->known->variables > 0 ? MOST_VALUES * (double)s->subjects / ops : LANES;
    return (double)points < most ? points : (long)most;
}

/* Samples each function separately. */
static void sample_each(const struct genome_file *f, const struct sampled *of, size_t n, long points,
                        unsigned long seed, struct sampled_errors *found)
{
    for (size_t k = 0; k < n; k++) {
        struct sampled_errors *one = sampled_errors_new(f, &of[k], 1, points, seed);
        sampled_errors_free(&found[k]);
        found[k] = *one;
        free(one);
    }
}

struct sampled_errors *sampled_errors_new(const struct genome_file *f, const struct sampled *of, size_t n, long points,
                                          unsigned long seed)
{
    struct sampled_errors *found = new_array(n, sizeof *found);
    struct sampler s = sampler_new(f, of, n, found, seed);
    const struct known *x = s.region->known;
    if (!x->complete && n > 1) { /* inputs of some functions have no range */
        sampler_free(&s);
        sample_each(f, of, n, points, seed, found);
        return found;
    }
    const long most = affordable(&s, points);
    double *from = new_array(x->variables, sizeof *from);
    long tries = FIRST_TRIES, taken = 0;
    if (most > 0 && x->complete && region_draw(s.region, &s.random, 0, &tries, from))
        for (long part = 0; part < PARTS; part++) {
            taken += walk(&s, from, most * (part + 1) / PARTS - most * part / PARTS);
            for (size_t k = 0; k < n; k++)
                end_part(&s.subject[k], &s, most / CLIMBING / PARTS / (long)of[k].program->outputs);
        }
    for (size_t k = 0; k < n; k++) {
        end_walk(&s.subject[k], &s, most / CLIMBING / (long)of[k].program->outputs);
        found[k].points = taken;
    }
    free(from);
    sampler_free(&s);
    return found;
}

void sampled_errors_free(struct sampled_errors *s)
{
    free(s->worst);
    free(s->most);
}
