/* Values at random points; see prove_points.h.
 *
 * With functions as variables, an operation is a quotient of polynomials over the integers. Two that differ, or whose
 * ratios of values at the two points differ, have a nonzero difference of degree at most 4 D and of norm (sum of
 * absolute coefficients) below 2^(4 H + 1), where D and H bound degree and norm of all numerators and denominators. The
 * difference vanishes at a random point modulo a random prime of b bits only if the prime divides all its coefficients,
 * or by the Schwartz-Zippel lemma; the total chance is below (4 D + 8 H + 4) / 2^(b-1). b is chosen so that the chances
 * of all pairs of operations ever compared add up to less than 2^-100.
 *
 * Prime, points and values of functions are answers of a hash to the program itself. So the chance assumes a hash that
 * answers like a random oracle, and programs that were not made with this hash in view. */
#define _GNU_SOURCE /* tdestroy */
#include "prove_points.h"

#include "../base/index_table.h"
#include "../base/random.h"
#include "../graph/unary.h"
#include "random_oracle.h"

#include <flint/fmpq_vec.h>
#include <flint/fmpz_vec.h>
#include <math.h>
#include <search.h>
#include <stdlib.h>
#include <string.h>

enum { TRIES = 4, CERTAIN = 100, MOST_BITS = 1024, MOST_EXACT = 8192 };
enum { SMALL = 160 }; /* bits of a rational that its residue determines */

/* An evaluation. */
struct field {
    const struct program *program;
    struct points *points;
    struct oracle oracle;
    fmpq *exact;             /* owned: by operation, if known; at most MOST_EXACT bits */
    bool *known;             /* owned: by operation; its form is constant */
    void *sizes;             /* owned: tree of rays: results of abs, keyed by argument */
    struct index_table like; /* functions, keyed by the values of their arguments */
    bool accident;           /* a divisor is 0 */
};

/* ---- how many bits ---- */

/* Degree and log2 of the norm of numerator and denominator. */
struct bound {
    double degree[2], norm[2];
};

static struct bound product_bound(const struct bound *a, const struct bound *b, bool divide)
{
    struct bound c;
    for (int k = 0; k < 2; k++) {
        c.degree[k] = a->degree[k] + b->degree[divide ? 1 - k : k];
        c.norm[k] = a->norm[k] + b->norm[divide ? 1 - k : k];
    }
    return c;
}

static struct bound sum_bound(const struct bound *a, const struct bound *b)
{
    struct bound c = product_bound(a, b, false);
    c.degree[0] = fmax(a->degree[0] + b->degree[1], b->degree[0] + a->degree[1]);
    c.norm[0] = fmax(a->norm[0] + b->norm[1], b->norm[0] + a->norm[1]) + 1;
    return c;
}

static struct bound larger_bound(const struct bound *a, const struct bound *b)
{
    struct bound c;
    for (int k = 0; k < 2; k++) {
        c.degree[k] = fmax(a->degree[k], b->degree[k]);
        c.norm[k] = fmax(a->norm[k], b->norm[k]);
    }
    return c;
}

static bool is_function(enum op_kind kind)
{
    return kind >= OP_FUNCTION;
}

/* Returns log2 of the chance of an error, times 2^(bits - 1); infinite if the bounds leave the range of double. */
static double log2_weight(const struct program *p, bool *has_functions)
{
    struct bound *bound = new_array(p->ops, sizeof *bound);
    double most = 0, functions = 0;
    for (size_t i = 0; i < p->ops; i++) {
        const struct op *o = &p->op[i];
        const struct bound *a = o->a >= 0 ? &bound[o->a] : NULL, *b = o->b >= 0 ? &bound[o->b] : NULL;
        if (o->kind == OP_CONSTANT) {
            bound[i].norm[0] = (double)fmpz_bits(fmpq_numref(&p->constant[o->input]));
            bound[i].norm[1] = (double)fmpz_bits(fmpq_denref(&p->constant[o->input]));
        } else if (o->kind == OP_ADD || o->kind == OP_SUB)
            bound[i] = sum_bound(a, b);
        else if (o->kind == OP_MUL || o->kind == OP_DIV || o->kind == OP_PDIV)
            bound[i] = product_bound(a, b, o->kind != OP_MUL);
        else if (a)
            bound[i] = b ? larger_bound(a, b) : *a;
        bound[i].degree[0] += is_function(o->kind) || o->kind == OP_INPUT;
        for (int k = 0; k < 2; k++) {
            if (is_function(o->kind)) /* an argument, a small multiple of a variable, or a constant */
                bound[i].norm[k] += SMALL;
            most = fmax(most, 4 * bound[i].degree[k] + 8 * bound[i].norm[k] + 4);
        }
        functions += is_function(o->kind);
    }
    free(bound);
    *has_functions = functions > 0;
    const double pairs = (double)p->outputs + (functions + 2) * (functions + 2);
    return log2(most) + log2(pairs) + (functions > 0 ? 2 * SMALL + 1 : 0);
}

/* ---- residues ---- */

/* Computes *x = a / b; returns false if b is 0. */
static bool quotient(const struct points *p, fmpz *x, const fmpz *a, const fmpz *b)
{
    fmpz_t inverse;
    const bool good = !fmpz_is_zero(b);
    fmpz_init(inverse);
    if (good)
        fmpz_invmod(inverse, b, p->prime);
    fmpz_mul(x, a, inverse);
    fmpz_mod(x, x, p->prime);
    fmpz_clear(inverse);
    return good;
}

/* Finds the rational of at most `bits` bits with residue x, if it exists. The prime has at least SMALL bits if the
 * program has functions; otherwise it may have fewer. */
static bool get_rational(const struct points *p, fmpq *q, const fmpz *x, unsigned long bits)
{
    fmpz_t most;
    fmpz_init(most);
    fmpz_setbit(most, bits);
    const int found = fmpq_reconstruct_fmpz_2(q, x, p->prime, most, most);
    fmpz_clear(most);
    return found;
}

static bool is_zero(const struct points *x, int op)
{
    return fmpz_is_zero(&x->value[0][op]) && fmpz_is_zero(&x->value[1][op]);
}

static bool is_constant(const struct points *x, int op)
{
    return fmpz_equal(&x->value[0][op], &x->value[1][op]);
}

bool points_equal(const struct points *x, int a, int b)
{
    return fmpz_equal(&x->value[0][a], &x->value[0][b]) && fmpz_equal(&x->value[1][a], &x->value[1][b]);
}

/* Finds a / b if it is such a rational. */
static bool get_factor(const struct points *x, int a, int b, fmpq *factor, unsigned long bits)
{
    fmpz_t c;
    fmpz_init(c);
    const bool good = quotient(x, c, &x->value[0][a], &x->value[0][b]) && get_rational(x, factor, c, bits);
    fmpz_clear(c);
    return good;
}

bool points_factor(const struct points *x, int a, int b, fmpq *factor)
{
    const double spare = -CERTAIN - 1 - x->log2_failure;
    return get_factor(x, a, b, factor, x->functions ? SMALL : spare > 0 ? (unsigned long)(spare / 2) : 0);
}

/* Constant multiples of a value share the ratio between its values at the two points. */
struct ray {
    fmpz_t ratio;
    int label;
};

static int compare_rays(const void *a, const void *b)
{
    return fmpz_cmp(((const struct ray *)a)->ratio, ((const struct ray *)b)->ratio);
}

static void free_ray(void *r)
{
    fmpz_clear(((struct ray *)r)->ratio);
    free(r);
}

/* Returns the label of the first value in the tree of which op's value is a multiple, or adds op's. The value must not
 * be 0 at the second point. */
static int find_ray(void **tree, const struct points *x, int op, int label)
{
    struct ray *r = new_array(1, sizeof *r), *const * slot;
    fmpz_init(r->ratio);
    quotient(x, r->ratio, &x->value[0][op], &x->value[1][op]);
    r->label = label;
    slot = tsearch(r, tree, compare_rays);
    const int first = slot ? (*slot)->label : label;
    if (!slot || *slot != r)
        free_ray(r);
    return first;
}

int *points_classes(const struct points *x)
{
    int *first = new_array(x->ops, sizeof *first);
    void *tree = NULL;
    for (size_t i = 0; i < x->ops; i++)
        first[i] = is_constant(x, (int)i) || fmpz_is_zero(&x->value[1][i]) ? -1 : find_ray(&tree, x, (int)i, (int)i);
    tdestroy(tree, free_ray);
    return first;
}

/* ---- evaluation ---- */

static void set_constant(struct field *e, int op, const fmpq *q)
{
    struct points *x = e->points;
    e->accident |= !fmpq_mod_fmpz(&x->value[0][op], q, x->prime);
    fmpz_set(&x->value[1][op], &x->value[0][op]);
    e->known[op] = fmpq_height_bits(q) <= MOST_EXACT;
    if (e->known[op])
        fmpq_set(&e->exact[op], q);
}

/* Finds the value of a constant; if its form hides it, from its residue. */
static bool get_constant(const struct field *e, fmpq *q, int op)
{
    if (e->known[op])
        fmpq_set(q, &e->exact[op]);
    return e->known[op] || (is_constant(e->points, op) && get_rational(e->points, q, &e->points->value[0][op], SMALL));
}

/* Returns false if an operand is not a known constant. */
static bool evaluate_constant(struct field *e, const struct op *o, int op)
{
    const fmpq *a = o->a >= 0 ? &e->exact[o->a] : NULL, *b = o->b >= 0 ? &e->exact[o->b] : NULL;
    fmpq_t q;
    if (o->kind == OP_INPUT || is_function(o->kind) || (a && !e->known[o->a]) || (b && !e->known[o->b]) ||
        (o->kind == OP_DIV && fmpq_is_zero(b)))
        return false;
    fmpq_init(q);
    if (o->kind == OP_CONSTANT)
        fmpq_set(q, &e->program->constant[o->input]);
    else if (o->kind == OP_NEG)
        fmpq_neg(q, a);
    else if (o->kind == OP_ADD)
        fmpq_add(q, a, b);
    else if (o->kind == OP_SUB)
        fmpq_sub(q, a, b);
    else if (o->kind == OP_MUL)
        fmpq_mul(q, a, b);
    else
        fmpq_div(q, a, b);
    set_constant(e, op, q);
    fmpq_clear(q);
    return true;
}

/* Sets the operation's values at both points to the oracle's answers. */
static void draw_both(const struct field *e, const mp_limb_t *question, size_t n, int op)
{
    fmpz *const *value = e->points->value;
    oracle_draw(&e->oracle, (fmpz *const[2]){&value[0][op], &value[1][op]}, e->points->prime, question, n);
}

/* Draws the new variable for a function of key[0..3], at both points. */
static void draw_function(const struct field *e, enum op_kind kind, const fmpz *key, int op)
{
    const size_t limbs = (e->points->bits + FLINT_BITS - 1) / FLINT_BITS, n = 2 + 4 * limbs;
    mp_limb_t *question = new_array(n, sizeof *question);
    question[0] = 'f';
    question[1] = (mp_limb_t)kind;
    for (size_t k = 0; k < 4; k++)
        fmpz_get_ui_array(question + 2 + k * limbs, (slong)limbs, &key[k]);
    draw_both(e, question, n, op);
    free(question);
}

/* Finds or draws the variable of a kind and the values of a and b. */
static void apply_opaque(struct field *e, enum op_kind kind, int a, int b, int op)
{
    fmpz *key = _fmpz_vec_init(4);
    for (int point = 0; point < 2; point++) {
        fmpz_set(&key[point], &e->points->value[point][a]);
        if (b >= 0)
            fmpz_set(&key[2 + point], &e->points->value[point][b]);
    }
    const int first = fmpz_cmp(&key[0], &key[2]), order = first ? first : fmpz_cmp(&key[1], &key[3]);
    if ((kind == OP_MIN || kind == OP_MAX) && order > 0) {
        fmpz_swap(&key[0], &key[2]);
        fmpz_swap(&key[1], &key[3]);
    }
    draw_function(e, kind, key, op);
    _fmpz_vec_clear(key, 4);
}

/* Evaluates abs: a multiple of an earlier result if the argument is a multiple. */
static void apply_abs(struct field *e, int a, int op)
{
    struct points *x = e->points;
    fmpq_t factor;
    if (fmpz_is_zero(&x->value[1][a])) {
        e->accident = true;
        return;
    }
    fmpq_init(factor);
    const int first = find_ray(&e->sizes, x, a, op);
    if (first != op && get_factor(x, a, e->program->op[first].a, factor, SMALL)) {
        fmpq_abs(factor, factor);
        set_constant(e, op, factor);
        e->known[op] = false;
        for (int point = 0; point < 2; point++) {
            fmpz_mul(&x->value[point][op], &x->value[point][op], &x->value[point][first]);
            fmpz_mod(&x->value[point][op], &x->value[point][op], x->prime);
        }
    } else
        apply_opaque(e, OP_ABS, a, -1, op);
    fmpq_clear(factor);
}

/* Evaluates a protected quotient, identified by its quotient and by its divisor up to a constant factor. */
static void apply_protected(struct field *e, int a, int b, int op)
{
    const struct points *x = e->points;
    fmpz *key = _fmpz_vec_init(4);
    for (int point = 0; point < 2; point++) {
        e->accident |= !quotient(x, &key[point], &x->value[point][a], &x->value[point][b]);
        fmpz_set(&x->value[point][op], &key[point]);
    }
    if (!is_constant(x, b)) {
        e->accident |= !quotient(x, &key[2], &x->value[0][b], &x->value[1][b]);
        draw_function(e, OP_PDIV, key, op);
    }
    _fmpz_vec_clear(key, 4);
}

static void copy(struct field *e, int to, int from)
{
    for (int point = 0; point < 2; point++)
        fmpz_set(&e->points->value[point][to], &e->points->value[point][from]);
    e->known[to] = e->known[from];
    if (e->known[to])
        fmpq_set(&e->exact[to], &e->exact[from]);
}

/* Folds functions of constants, and functions that their arguments decide; returns false for others. */
static bool fold(struct field *e, enum op_kind kind, int a, int b, int op)
{
    const struct points *x = e->points;
    const bool same = b >= 0 && points_equal(x, a, b);
    bool folds = false;
    fmpq_t p, q;
    fmpq_init(p);
    fmpq_init(q);
    if (kind == OP_MIN || kind == OP_MAX) {
        folds = same || (get_constant(e, p, a) && get_constant(e, q, b));
        if (folds)
            copy(e, op, same || (fmpq_cmp(p, q) < 0) == (kind == OP_MIN) ? a : b);
    } else {
        if (kind == OP_PDIV) {
            folds = same || is_zero(x, b);
            fmpq_one(p);
        } else
            folds = get_constant(e, p, a) && unary_exact(kind - OP_UNARY, p, p);
        if (folds)
            set_constant(e, op, p);
    }
    fmpq_clear(p);
    fmpq_clear(q);
    return folds;
}

/* Returns an earlier equal function of equal arguments, or adds `op` and returns -1. */
static int find_like(struct field *e, enum op_kind kind, int a, int b, int op)
{
    const struct points *x = e->points;
    const bool commutes = kind == OP_MIN || kind == OP_MAX;
    const uint64_t hash =
        random_mix(fmpz_get_ui(&x->value[0][a]) + (b >= 0 ? fmpz_get_ui(&x->value[0][b]) : 0) + (uint64_t)kind);
    size_t probe = 0;
    for (int i; (i = index_next(&e->like, hash, &probe)) >= 0;) {
        const struct op *o = &e->program->op[i];
        if (o->kind == kind && ((points_equal(x, a, o->a) && (b < 0 || points_equal(x, b, o->b))) ||
                                (commutes && points_equal(x, a, o->b) && points_equal(x, b, o->a))))
            return i;
    }
    index_add(&e->like, hash, op);
    return -1;
}

static void evaluate_function(struct field *e, enum op_kind kind, int a, int b, int op)
{
    if (fold(e, kind, a, b, op))
        return;
    const int like = find_like(e, kind, a, b, op);
    if (like >= 0)
        copy(e, op, like);
    else if (kind == OP_ABS)
        apply_abs(e, a, op);
    else if (kind == OP_PDIV)
        apply_protected(e, a, b, op);
    else
        apply_opaque(e, kind, a, b, op);
}

static void evaluate_arithmetic(struct field *e, const struct op *o, int op, size_t point)
{
    const struct points *p = e->points;
    fmpz *v = p->value[point], *x = &v[op];
    if (o->kind == OP_NEG)
        fmpz_neg(x, &v[o->a]);
    else if (o->kind == OP_ADD)
        fmpz_add(x, &v[o->a], &v[o->b]);
    else if (o->kind == OP_SUB)
        fmpz_sub(x, &v[o->a], &v[o->b]);
    else if (o->kind == OP_MUL)
        fmpz_mul(x, &v[o->a], &v[o->b]);
    else
        e->accident |= !quotient(p, x, &v[o->a], &v[o->b]);
    fmpz_mod(x, x, p->prime);
}

/* Evaluates the program; returns false if a divisor is 0, the value of operation *divisor. */
static bool evaluate(const struct program *p, struct points *x, int attempt, int *divisor)
{
    struct field e = {.program = p,
                      .points = x,
                      .oracle = oracle_new(p, attempt, x->bits),
                      .exact = _fmpq_vec_init((slong)p->ops),
                      .known = new_array(p->ops, sizeof *e.known)};
    oracle_prime(&e.oracle, x->prime);
    for (size_t i = 0; i < p->ops && !e.accident; i++) {
        const struct op *o = &p->op[i];
        if (is_function(o->kind))
            evaluate_function(&e, o->kind, o->a, o->b, (int)i);
        else if (o->kind == OP_INPUT)
            draw_both(&e, (const mp_limb_t[2]){'x', (mp_limb_t)o->input}, 2, (int)i);
        else if (!evaluate_constant(&e, o, (int)i))
            for (size_t point = 0; point < 2; point++)
                evaluate_arithmetic(&e, o, (int)i, point);
        *divisor = o->b;
    }
    tdestroy(e.sizes, free_ray);
    _fmpq_vec_clear(e.exact, (slong)p->ops);
    free(e.known);
    index_free(&e.like);
    return !e.accident;
}

struct points *points_new(const struct program *p, int *divisor)
{
    bool functions;
    const double weight = log2_weight(p, &functions), bits = 64 * ceil((CERTAIN + 1 + weight) / 64);
    *divisor = -1;
    if (!(bits <= MOST_BITS))
        return NULL;
    struct points *x = new_array(1, sizeof *x);
    x->ops = p->ops;
    x->bits = (unsigned long)bits;
    x->log2_failure = weight - (bits - 1);
    x->functions = functions;
    fmpz_init(x->prime);
    for (int point = 0; point < 2; point++)
        x->value[point] = _fmpz_vec_init((slong)p->ops);
    for (int attempt = 0; attempt < TRIES; attempt++)
        if (evaluate(p, x, attempt, divisor))
            return x;
    points_free(x);
    return NULL;
}

void points_free(struct points *x)
{
    if (!x)
        return;
    for (int point = 0; point < 2; point++)
        _fmpz_vec_clear(x->value[point], (slong)x->ops);
    fmpz_clear(x->prime);
    free(x);
}
