/* Samples rounding errors; see rounding_subject.h. */
#include "rounding_subject.h"

#include "../../codegen/program/evaluate.h"
#include "../../codegen/program/evaluate_float.h"
#include "../../codegen/rounding/rounding.h"
#include "genome_text.h"
#include "long_cases.h"

#include <float.h>
#include <math.h>

long sample_count(void)
{
    return long_cases(10000, 1000000);
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

/* Returns values, indexed by operation, with the constants filled in. */
static struct beside *beside_new(const struct program *p)
{
    struct beside *v = new_array(p->ops, sizeof *v);
    double *constant = new_array(p->ops, sizeof *constant);
    point_constants(p, constant);
    for (size_t i = 0; i < p->ops; i++)
        for (int l = 0; l < SIDE_BY_SIDE; l++)
            v[i].at[l] = constant[i];
    free(constant);
    return v;
}

struct subject subject_new(const char *text, struct program *p)
{
    struct subject s = {.file = parse(text), .program = p};
    s.region = region_new(s.file, p, true);
    const struct known *x = s.region->known;
    const size_t sides = x->variables > p->inputs ? x->variables : p->inputs;
    s.input = new_array(p->inputs, sizeof *s.input);
    s.at = new_array(sides, sizeof *s.at);
    s.value = new_array(p->ops, sizeof *s.value);
    s.near = new_array(p->ops, sizeof *s.near);
    for (int l = 0; l < SIDE_BY_SIDE; l++)
        s.point[l] = new_array(sides, sizeof *s.point[l]);
    s.own = new_array(x->inputs, sizeof *s.own);
    s.required = beside_new(x->program);
    s.box = new_array(sides, sizeof *s.box);
    s.exact = _arb_vec_init((slong)p->outputs);
    point_constants(p, s.value);
    for (size_t i = 0; i < p->ops; i++)
        if (p->op[i].kind == OP_CONSTANT)
            s.near[i] = nearest(p->constant + p->op[i].input);
    return s;
}

void subject_in_float(struct subject *s)
{
    s->region->known->arithmetic = arithmetic_single_scaled;
    s->single = new_array(s->program->ops, sizeof *s->single);
    s->coordinate = new_array(2 * s->program->inputs, sizeof *s->coordinate);
    single_constants(s->program, s->single);
}

void subject_free(struct subject *s)
{
    free(s->single);
    free(s->coordinate);
    _arb_vec_clear(s->exact, (slong)s->program->outputs);
    free(s->input);
    free(s->at);
    free(s->value);
    free(s->near);
    for (int l = 0; l < SIDE_BY_SIDE; l++)
        free(s->point[l]);
    free(s->own);
    free(s->required);
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

/* Draws some coordinates of a point again, each kept with a chance of `keep`; a quarter of the new numbers are ends of their
 * ranges. */
static void move(const struct subject *s, double keep, uint64_t *seed, double *at)
{
    for (size_t k = 0; k < s->region->known->variables; k++) {
        const size_t input = s->region->known->input[k];
        const struct interval range = s->region->doubles[input];
        const uint64_t choice = random_next(seed) % 8;
        if (fraction(seed) < keep)
            continue;
        const double x = range.lo + (fraction(seed) + fraction(seed) * 0x1p-51) * (range.hi - range.lo);
        at[k] = choice == 0 ? range.lo : choice == 1 ? range.hi : fmin(x, range.hi);
    }
}

/* Evaluates all operations of a program, at points side by side. */
static void values(const struct program *p, const struct beside *input, struct beside *v)
{
#define EACH(value)                                                                                                    \
    for (int l = 0; l < SIDE_BY_SIDE; l++)                                                                             \
        x[l] = value;                                                                                                  \
    break
    for (size_t i = 0; i < p->ops; i++) {
        const struct op *op = &p->op[i];
        const double *a = v[op->a >= 0 ? op->a : 0].at, *b = v[op->b >= 0 ? op->b : 0].at;
        double *restrict x = v[i].at;
        switch (op->kind) {
        case OP_CONSTANT:
            break; /* filled in by beside_new */
        case OP_INPUT:
            EACH(input[op->input].at[l]);
        case OP_NEG:
            EACH(-a[l]);
        case OP_ADD:
            EACH(a[l] + b[l]);
        case OP_SUB:
            EACH(a[l] - b[l]);
        case OP_MUL:
            EACH(a[l] * b[l]);
        default:
            EACH(point_operation(op->kind, a[l], b[l]));
        }
    }
#undef EACH
}

/* Returns the points at which all outputs are > 0, a bit each. */
static unsigned positive(const struct program *p, const struct beside *input, struct beside *v)
{
    unsigned all = (1U << SIDE_BY_SIDE) - 1;
    values(p, input, v);
    for (size_t i = 0; i < p->outputs; i++)
        for (unsigned l = 0; l < SIDE_BY_SIDE; l++)
            all &= v[p->output[i]].at[l] > 0 ? ~0U : ~(1U << l);
    return all;
}

/* Returns the candidates that lie in the region, as far as rounded values show. */
static unsigned in_region_about(struct subject *s)
{
    const struct known *x = s->region->known;
    for (size_t i = 0; i < x->inputs; i++)
        for (int l = 0; l < SIDE_BY_SIDE; l++)
            s->own[i].at[l] =
                x->variable[i] < x->variables ? s->point[l][x->variable[i]] : fmax(s->region->doubles[i].lo, -DBL_MAX);
    return positive(x->program, s->own, s->required);
}

static void place(struct subject *s, const double *at)
{
    memcpy(s->at, at, s->region->known->variables * sizeof *at);
    region_inputs(s->region, s->at, s->input);
}

static bool in_region(struct subject *s)
{
    for (size_t k = 0; k < s->region->known->variables; k++)
        s->box[k] = interval_point(s->at[k]);
    return region_holds(s->region, s->box);
}

/* Computes values in long double, whose errors are a two-thousandth: accurate enough to select points for exact evaluation. */
static void near_values(struct subject *s)
{
    long double *const v = s->near;
    for (size_t i = 0; i < s->program->ops; i++) {
        const struct op *op = &s->program->op[i];
        const long double a = op->a >= 0 ? v[op->a] : 0, b = op->b >= 0 ? v[op->b] : 0;
        switch (op->kind) {
        case OP_CONSTANT:
            break; /* filled in by subject_new */
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

/* Computes the outputs at the point; with a seed, products are contracted at random. */
static void compute(struct subject *s, uint64_t *seed)
{
    const size_t n = s->program->inputs;
    if (!s->single) {
        point_double(s->program, s->input, seed, s->value);
        return;
    }
    for (size_t i = 0; i < n; i++)
        s->coordinate[i] = (float)s->input[i];
    single_inputs(s->file->segment, s->coordinate, s->coordinate + n);
    single_values(s->program, s->coordinate + n, s->single);
    for (size_t i = 0; i < s->program->outputs; i++)
        s->value[s->program->output[i]] = s->single[s->program->output[i]];
}

/* Estimates the errors of the outputs at the point, with products contracted or not, whichever is worse; computes the worst so far exactly.
 * Returns false if the point is not in the region, or has no exact value, a quotient by 0. */
static bool look(struct subject *s, uint64_t *seed, double *about, double *worst)
{
    bool exact = false;
    for (size_t i = 0; s->single && i < s->program->inputs; i++)
        s->input[i] = (float)s->input[i];
    near_values(s);
    for (size_t i = 0; i < s->program->outputs; i++)
        about[i] = 0;
    for (int k = 0; k < 2; k++) {
        compute(s, k ? seed : NULL);
        for (size_t i = 0; i < s->program->outputs; i++) {
            const int op = s->program->output[i];
            const double error = (double)fabsl(s->value[op] - s->near[op]);
            about[i] = !(error <= about[i]) ? error : about[i];
            if (error <= 0.99 * worst[i])
                continue;
            exact = exact || (in_region(s) && point_exact(s->program, s->input, s->exact));
            if (!exact)
                return false;
            worst[i] = fmax(worst[i], error_of(s->value[op], s->exact + i));
        }
    }
    return true;
}

/* Moves to the next point of a walk through the region.  If few points of the box belong to it, each point leads to the
 * next: from one to all coordinates are drawn again, until the point stays in the region.  Returns false if no tries are left. */
static bool walk(struct subject *s, double *from, uint64_t *seed, long *tries)
{
    static const double keep[] = {0, 0.5, 0.8, 0.95};
    const size_t size = s->region->known->variables * sizeof *from;
    for (; !s->inside; s->inside = in_region_about(s), *tries -= SIDE_BY_SIDE) {
        if (*tries <= 0)
            return false;
        for (int l = 0; l < SIDE_BY_SIDE; l++)
            move(s, keep[l & 3], seed, memcpy(s->point[l], from, size));
    }
    place(s, memcpy(from, s->point[__builtin_ctz(s->inside)], size));
    s->inside &= s->inside - 1;
    return true;
}

/* Changes a coordinate, by anything from all of its range to its last digits. */
static void step(const struct subject *s, uint64_t *seed, double *at)
{
    const struct known *x = s->region->known;
    const size_t k = random_next(seed) % x->variables;
    const struct interval range = s->region->doubles[x->input[k]];
    const double far = ldexp(2 * fraction(seed) - 1, -(int)(random_next(seed) % 52)) * (range.hi - range.lo);
    at[k] = fmin(fmax(at[k] + far, range.lo), range.hi);
}

/* Climbs from a point of the region as long as the error of an output grows. */
static void climb(struct subject *s, size_t output, double *from, uint64_t *seed, double *about, double *worst)
{
    const size_t size = s->region->known->variables * sizeof *from;
    enum { STEPS = 200 };
    place(s, from);
    double highest = look(s, seed, about, worst) ? about[output] : -1;
    for (int n = 0; n < STEPS; n += SIDE_BY_SIDE) {
        for (int l = 0; l < SIDE_BY_SIDE; l++)
            step(s, seed, memcpy(s->point[l], from, size));
        for (unsigned inside = in_region_about(s); inside; inside &= inside - 1) {
            place(s, s->point[__builtin_ctz(inside)]);
            if (!look(s, seed, about, worst) || !(about[output] > highest))
                continue;
            highest = about[output];
            memcpy(from, s->at, size);
        }
    }
    s->inside = 0;
}

void worst_errors(struct subject *s, double *worst)
{
    enum { TRIES = 200 /* for a point */, FEW = 4 };
    const size_t variables = s->region->known->variables, outputs = s->program->outputs;
    const long starts = sample_count() / 1000;
    uint64_t seed = 11;
    long draws = 1000000, tries = TRIES * sample_count(), n = 0;
    double *from = new_array(variables, sizeof *from), *top = new_array(variables, sizeof *top);
    double *about = new_array(outputs, sizeof *about);
    for (size_t i = 0; i < outputs; i++)
        worst[i] = 0;
    if (!region_draw(s->region, &seed, 0, &draws, from))
        fail_msg("no point of the region was found");
    while (n < sample_count() && walk(s, from, &seed, &tries))
        n += look(s, &seed, about, worst);
    assert_int_equal(n, sample_count());
    for (n = 0; n < starts && variables > 0 && walk(s, from, &seed, &(long){TRIES * 1000}); n++)
        for (size_t i = 0; i < outputs; i++) {
            if (outputs > FEW && i != (size_t)n % outputs)
                continue;
            memcpy(top, from, variables * sizeof *top);
            climb(s, i, top, &seed, about, worst);
        }
    assert_int_equal(n, variables > 0 ? starts : 0);
    free(from);
    free(top);
    free(about);
}
