/* See rounding_subject.h. */
#include "rounding_subject.h"

#include "../../codegen/bound/rounding.h"
#include "../../codegen/program/evaluate.h"
#include "genome_text.h"

#include <float.h>
#include <math.h>

long sample_count(void)
{
    return getenv("FOOTPOINT_LONG") ? 1000000 : 3000;
}

static long double nearest(const fmpq_t x)
{
    mpfr_t y;
    mpfr_init2(y, 64);
    fmpq_get_mpfr(y, x, MPFR_RNDN);
    const long double value = mpfr_get_ld(y, MPFR_RNDN);
    mpfr_clear(y);
    return value;
}

struct subject subject_new(const char *text, struct program *p)
{
    struct subject s = {.file = parse(text), .program = p};
    s.region = region_new(s.file, p, true);
    const size_t sides = s.region->known->variables > p->inputs ? s.region->known->variables : p->inputs;
    s.input = new_array(p->inputs, sizeof *s.input);
    s.at = new_array(sides, sizeof *s.at);
    s.value = new_array(p->ops, sizeof *s.value);
    s.near = new_array(p->ops, sizeof *s.near);
    s.own = new_array(s.region->known->inputs, sizeof *s.own);
    s.known = new_array(s.region->known->program->ops, sizeof *s.known);
    point_constants(s.region->known->program, s.known);
    s.box = new_array(sides, sizeof *s.box);
    s.exact = _arb_vec_init((slong)p->outputs);
    point_constants(p, s.value);
    for (size_t i = 0; i < p->ops; i++)
        if (p->op[i].kind == OP_CONSTANT)
            s.near[i] = nearest(p->constant + p->op[i].input);
    return s;
}

void subject_free(struct subject *s)
{
    _arb_vec_clear(s->exact, (slong)s->program->outputs);
    free(s->input);
    free(s->at);
    free(s->value);
    free(s->near);
    free(s->own);
    free(s->known);
    free(s->box);
    region_free(s->region);
    program_free(s->program);
    genome_file_free(s->file);
}

double error_of(double x, const arb_t exact)
{
    arb_t d;
    arb_init(d);
    arb_set_d(d, x);
    arb_sub(d, d, exact, 128);
    const double far = fabs(arf_get_d(arb_midref(d), ARF_RND_NEAR));
    arb_clear(d);
    return isfinite(x) ? far : INFINITY;
}

/* Some coordinates anew, each kept with a chance of `keep`; a quarter of the new ones are ends of their ranges. */
static void move(struct subject *s, double keep, uint64_t *seed)
{
    for (size_t k = 0; k < s->region->known->variables; k++) {
        const size_t input = s->region->known->input[k];
        const struct interval range = s->region->doubles[input];
        const uint64_t choice = random_next(seed) % 8;
        if (fraction(seed) < keep)
            continue;
        const double x = range.lo + (fraction(seed) + fraction(seed) * 0x1p-51) * (range.hi - range.lo);
        s->at[k] = choice == 0 ? range.lo : choice == 1 ? range.hi : fmin(x, range.hi);
    }
    region_inputs(s->region, s->at, s->input);
}

/* As far as rounded values of the requires tell. */
static bool seems_in_region(struct subject *s)
{
    const struct known *x = s->region->known;
    for (size_t i = 0; i < x->inputs; i++)
        s->own[i] = x->variable[i] < x->variables ? s->at[x->variable[i]] : fmax(s->region->doubles[i].lo, -DBL_MAX);
    point_double(x->program, s->own, NULL, s->known);
    bool inside = true;
    for (size_t i = 0; i < x->program->outputs && inside; i++)
        inside = s->known[x->program->output[i]] > 0;
    return inside;
}

static bool in_region(struct subject *s)
{
    for (size_t k = 0; k < s->region->known->variables; k++)
        s->box[k] = interval_point(s->at[k]);
    return region_holds(s->region, s->box);
}

/* Values in long double, whose errors are a two-thousandth: near enough to tell which points are worth an exact look. */
static void near_values(struct subject *s)
{
    long double *const v = s->near;
    for (size_t i = 0; i < s->program->ops; i++) {
        const struct op *op = &s->program->op[i];
        const long double a = op->a >= 0 ? v[op->a] : 0, b = op->b >= 0 ? v[op->b] : 0;
        switch (op->kind) {
        case OP_CONSTANT:
            break; /* by subject_new */
        case OP_INPUT:
            v[i] = s->input[op->input];
            break;
        case OP_NEG:
            v[i] = -a;
            break;
        case OP_ADD:
            v[i] = a + b;
            break;
        case OP_SUB:
            v[i] = a - b;
            break;
        case OP_MUL:
            v[i] = a * b;
            break;
        case OP_DIV:
            v[i] = a / b;
            break;
        case OP_PDIV:
            v[i] = b == 0 ? 1 : a / b;
            break;
        case OP_MIN:
            v[i] = a < b ? a : b;
            break;
        case OP_MAX:
            v[i] = a > b ? a : b;
            break;
        default:
            v[i] = op->kind == OP_UNARY + UNARY_SQRT ? sqrtl(a) : op->kind == OP_UNARY + UNARY_ABS ? fabsl(a) : NAN;
        }
    }
}

/* The worst error of each output at random points of the region, exactly where it may be the worst.  Where few points of the box belong to it one leads to
 * the next: from one to all coordinates are drawn anew, until that leaves the region no more. */
void worst_errors(struct subject *s, double *worst)
{
    static const double keep[] = {0, 0.5, 0.8, 0.95};
    enum { TRIES = 200 }; /* for a point */
    uint64_t seed = 11;
    long left = 1000000, n = 0;
    double *from = new_array(s->region->known->variables, sizeof *from);
    for (size_t i = 0; i < s->program->outputs; i++)
        worst[i] = 0;
    if (!region_draw(s->region, &seed, 0, &left, from))
        fail_msg("no point of the region was found");
    for (left = TRIES * sample_count(); n < sample_count() && left > 0; left--) {
        memcpy(s->at, from, s->region->known->variables * sizeof *from);
        move(s, keep[left % 4], &seed);
        if (!seems_in_region(s))
            continue;
        memcpy(from, s->at, s->region->known->variables * sizeof *from);
        n++;
        near_values(s);
        bool exact = false, none = false; /* it is not in the region, or has no exact value, a quotient by 0 */
        for (int k = 0; k < 2 && !none; k++) {
            point_double(s->program, s->input, k ? &seed : NULL, s->value);
            for (size_t i = 0; i < s->program->outputs && !none; i++) {
                const int op = s->program->output[i];
                if (fabsl(s->value[op] - s->near[op]) <= 0.99 * worst[i])
                    continue;
                exact = exact || (in_region(s) && point_exact(s->program, s->input, s->exact));
                none = !exact;
                if (exact)
                    worst[i] = fmax(worst[i], error_of(s->value[op], s->exact + i));
            }
        }
        n -= none;
    }
    free(from);
    assert_int_equal(n, sample_count());
}
