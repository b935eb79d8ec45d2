/* Finds vectors of a straight segment; see header_vectors.h. */
#include "header_vectors.h"

#include "../../base/random.h"
#include "../../base/text.h"
#include "../../program/dialects.h"
#include "../../program/evaluate.h"
#include "../c_text.h"
#include "header_lines.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 3, KNOTS = 5 }; /* factors are powers of 2 from -LARGEST to LARGEST; KNOTS: vectors of nodes, and S */

/* A vector of a kind: `over` times its coordinates are sums of differences of coordinates of pairs of A, B, ..., S: a pair, two pairs,
 * or two such sums. */
static const struct vector {
    int over, pairs, pair[4][2];
} bilinear[VECTORS] = {{4, 2, {{1, 0}, {2, 3}}},
                       {4, 2, {{3, 0}, {2, 1}}},
                       {4, 2, {{0, 1}, {2, 3}}},
                       {4, 4, {{4, 0}, {4, 1}, {4, 2}, {4, 3}}}},
  flat[VECTORS] = {{1, 1, {{1, 0}}}, {1, 1, {{2, 0}}}, {1, 0, {{0}}}, {1, 1, {{3, 0}}}};

bool vectors_shared(const struct unit *u, const struct function *f)
{
    return u->file->order == CORNERS_ANY && lines_straight(u) && !f->scaled;
}

/* Computes a coordinate of a vector at a point. */
static void coordinate_value(const struct vectors_found *w, size_t vector, size_t i, size_t point, fmpq_t sum)
{
    const struct vector *v = &w->vector[vector];
    fmpq_t term;
    fmpq_init(term);
    fmpq_zero(sum);
    for (int k = 0; k < v->pairs; k++) {
        fmpq_sub(term, w->value[point] + 3 * v->pair[k][0] + i, w->value[point] + 3 * v->pair[k][1] + i);
        fmpq_add(sum, sum, term);
    }
    fmpq_set_si(term, 1, (ulong)v->over);
    fmpq_mul(sum, sum, term);
    fmpq_clear(term);
}

/* Returns the power of 2, with a sign, by which an operation exceeds the targets, one a point; 0 if there is no such power. */
static double factor_of(const struct vectors_found *w, size_t op, const fmpq *target)
{
    double factor = 0.0;
    fmpq_t product;
    fmpq_init(product);
    for (int sign = -1; sign <= 1; sign += 2)
        for (int power = -LARGEST; power <= LARGEST && factor == 0.0; power++) {
            bool same = true;
            for (size_t point = 0; point < POINTS && same; point++) {
                if (power < 0)
                    fmpq_div_2exp(product, target + point, (ulong)-power);
                else
                    fmpq_mul_2exp(product, target + point, (ulong)power);
                if (sign < 0)
                    fmpq_neg(product, product);
                same = w->known[point][op] && fmpq_equal(product, w->value[point] + op);
            }
            factor = same ? sign * (power < 0 ? 1.0 / (1 << -power) : 1 << power) : 0.0;
        }
    fmpq_clear(product);
    return factor;
}

/* Returns the first operation that is a multiple of the targets. */
static struct coordinate search_operation(const struct vectors_found *w, const struct program *p, const fmpq *target)
{
    struct coordinate c = {-1, 0.0};
    for (size_t op = p->inputs; op < p->ops && c.op < 0; op++)
        if ((c.factor = factor_of(w, op, target)) != 0.0)
            c.op = (int)op;
    return c;
}

/* A coordinate that is a sum of differences of coordinates of A, B, ..., S: its coefficients, and the bounds on its error in units of
 * rounding of c1, c2, c3 and d. */
struct linear {
    bool is;
    double of[KNOTS], error[VECTORS];
};

/* Expresses x as a sum of multiples of c1, c2, c3 and d, by absolute values. */
static void linear_parts(const struct vectors_found *w, const struct linear *x, double part[VECTORS])
{
    static const int square[VECTORS][KNOTS] = {
        {-1, 1, 1, -1, 0}, {-1, -1, 1, 1, 0}, {1, -1, 1, -1, 0}, {0, 0, 0, 0, 1}};
    static const int triangle[VECTORS][KNOTS] = {{0, 1, 0, 0, 0}, {0, 0, 1, 0, 0}, {0}, {0, 0, 0, 1, 0}};
    for (size_t v = 0; v < VECTORS; v++) {
        part[v] = 0.0;
        for (size_t k = 0; k < KNOTS; k++)
            part[v] += (w->vector == bilinear ? square : triangle)[v][k] * x->of[k];
        part[v] = fabs(part[v]);
    }
}

/* Returns a + sign b, which is linear if it is a difference of coordinates, and rounded. */
static struct linear linear_sum(const struct vectors_found *w, const struct linear *a, const struct linear *b, int sign)
{
    struct linear x = {.is = a->is && b->is};
    double part[VECTORS], all = 0.0;
    for (size_t k = 0; k < KNOTS; k++)
        all += x.of[k] = a->of[k] + sign * b->of[k];
    x.is = x.is && all == 0.0;
    linear_parts(w, &x, part);
    for (size_t v = 0; v < VECTORS; v++)
        x.error[v] = a->error[v] + b->error[v] + part[v];
    return x;
}

/* Returns a times a power of 2. */
static struct linear linear_multiple(const struct linear *a, const fmpq *factor)
{
    struct linear x = *a;
    int exponent;
    const double times = fmpq_get_d(factor);
    x.is = x.is && fabs(frexp(times, &exponent)) == 0.5;
    for (size_t k = 0; k < KNOTS; k++)
        x.of[k] *= times;
    for (size_t v = 0; v < VECTORS; v++)
        x.error[v] *= fabs(times);
    return x;
}

/* Returns operation `op` as a sum of coordinates number i; `x`: the operations before it. */
static struct linear linear_operation(const struct vectors_found *w, const struct program *p, size_t op, size_t i,
                                      const struct linear *x)
{
    const struct op *o = &p->op[op];
    struct linear none = {.is = false};
    fmpq_t minus;
    switch (o->kind) {
    case OP_INPUT:
        none.is = (size_t)o->input % 3 == i;
        none.of[o->input / 3] = 1.0;
        return none;
    case OP_ADD:
    case OP_SUB:
        return linear_sum(w, &x[o->a], &x[o->b], o->kind == OP_ADD ? 1 : -1);
    case OP_NEG:
        fmpq_init(minus);
        fmpq_set_si(minus, -1, 1);
        none = linear_multiple(&x[o->a], minus);
        fmpq_clear(minus);
        return none;
    case OP_MUL:
        if (p->op[o->a].kind == OP_CONSTANT)
            return linear_multiple(&x[o->b], p->constant + p->op[o->a].input);
        if (p->op[o->b].kind == OP_CONSTANT)
            return linear_multiple(&x[o->a], p->constant + p->op[o->b].input);
        return none;
    default:
        return none;
    }
}

/* Returns all operations as sums of coordinates number i; the caller frees them. */
static struct linear *linear_all(const struct vectors_found *w, const struct program *p, size_t i)
{
    struct linear *x = new_array(p->ops, sizeof *x);
    for (size_t op = 0; op < p->ops; op++)
        x[op] = linear_operation(w, p, op, i, x);
    return x;
}

enum { ROUNDING_OF_TEXT = 3 }; /* of the texts of vectors above */

/* Forgets coordinates number i whose rounding errors do not follow from sums of differences. */
static void bound_rounding(struct vectors_found *w, const struct program *p, size_t i)
{
    struct linear *x = linear_all(w, p, i);
    for (size_t v = 0; v < VECTORS; v++) {
        struct coordinate *c = &w->at[v][i];
        if (c->op >= 0 && (!x[c->op].is || (v < VECTORS - 1 && x[c->op].error[VECTORS - 1] > 0.0)))
            *c = (struct coordinate){-1, 0.0};
        for (size_t k = 0; k < VECTORS && c->op >= 0; k++)
            w->rounding = fmax(w->rounding, x[c->op].error[k] / fabs(c->factor));
        for (size_t k = 0; k < 2 && v == VECTORS - 2; k++)
            w->twist |= (c->op < 0 ? k == 0 : x[c->op].error[k] > 0.0) ? 1 << k : 0;
    }
    free(x);
}

static const size_t products[PRODUCTS][2] = {{0, 0}, {0, 1}, {1, 1}, {0, 2}, {1, 2}, {2, 2}, {0, 3}, {1, 3}, {2, 3}};

/* A sum of products of two coordinates of the same number: bounds on it and on its error, in units of rounding, indexed by that number
 * and by the vectors of the coordinates. */
struct quadratic {
    bool is;
    double value[3][VECTORS][VECTORS], error[3][VECTORS][VECTORS];
};

static bool is_difference(const struct linear *x)
{
    double all = 0.0;
    for (size_t k = 0; k < KNOTS; k++)
        all += x->of[k];
    return x->is && all == 0.0;
}

static struct quadratic quadratic_product(const struct vectors_found *w, const struct linear *a, const struct linear *b,
                                          size_t i)
{
    struct quadratic q = {.is = true};
    double x[VECTORS], y[VECTORS];
    linear_parts(w, a, x);
    linear_parts(w, b, y);
    for (size_t m = 0; m < VECTORS; m++)
        for (size_t n = 0; n < VECTORS; n++) {
            q.value[i][m][n] = x[m] * y[n];
            q.error[i][m][n] = x[m] * b->error[n] + a->error[m] * y[n] + x[m] * y[n];
        }
    return q;
}

static struct quadratic quadratic_sum(const struct quadratic *a, const struct quadratic *b)
{
    struct quadratic q = {.is = a->is && b->is};
    for (size_t i = 0; i < 3; i++)
        for (size_t m = 0; m < VECTORS; m++)
            for (size_t n = 0; n < VECTORS; n++) {
                q.value[i][m][n] = a->value[i][m][n] + b->value[i][m][n];
                q.error[i][m][n] = a->error[i][m][n] + b->error[i][m][n] + q.value[i][m][n];
            }
    return q;
}

/* Returns operation `op` as such a sum; x: all operations as sums, indexed by coordinate. */
static struct quadratic quadratic_operation(const struct vectors_found *w, const struct program *p, size_t op,
                                            struct linear *const x[3], const struct quadratic *q)
{
    const struct op *o = &p->op[op];
    const struct quadratic none = {.is = false};
    if (o->kind == OP_NEG)
        return q[o->a];
    if (o->kind == OP_ADD || o->kind == OP_SUB)
        return quadratic_sum(&q[o->a], &q[o->b]);
    for (size_t i = 0; i < 3 && o->kind == OP_MUL; i++)
        if (is_difference(&x[i][o->a]) && is_difference(&x[i][o->b]))
            return quadratic_product(w, &x[i][o->a], &x[i][o->b], i);
    return none;
}

/* Returns the share of the coordinates of vector `of` in the bound on the errors of another.  c1 and c2 are sums mostly of
 * their own edges and have a small share of each other; otherwise one long edge would spoil the bounds across it. */
static double share(const struct vectors_found *w, size_t vector, size_t of)
{
    if (of == vector)
        return 1.0;
    if (vector == VECTORS - 1)
        return VECTORS_SHIFT;
    if (vector == VECTORS - 2)
        return of < 2 && (w->twist & 1 << of) ? 1.0 : 0.0;
    return of == VECTORS - 2 ? 1.0 : of == VECTORS - 1 ? 0.0 : VECTORS_FOREIGN;
}

/* Returns the units of rounding of product k that cover its errors; infinite if no number does. */
static double product_units(const struct vectors_found *w, const struct quadratic *q, size_t k)
{
    double units = q->is ? 0.0 : INFINITY;
    for (size_t i = 0; i < 3; i++)
        for (size_t m = 0; m < VECTORS; m++)
            for (size_t n = 0; n < VECTORS; n++) {
                const double error = q->error[i][m][n] + q->error[i][n][m];
                const double allowed = share(w, products[k][0], m) * share(w, products[k][1], n) +
                                       share(w, products[k][0], n) * share(w, products[k][1], m);
                if (error > 0.0)
                    units = fmax(units, error / allowed);
            }
    return units;
}

/* Computes a product, times the square of `factor`[0], at the points. */
static void product_values(const struct vectors_found *w, size_t k, fmpq *target)
{
    fmpq_t a, b, scale;
    fmpq_init(a);
    fmpq_init(b);
    fmpq_init(scale);
    double_rational(scale, w->factor[0] * w->factor[0]);
    for (size_t point = 0; point < POINTS; point++) {
        for (size_t i = 0; i < 3; i++) {
            coordinate_value(w, products[k][0], i, point, a);
            coordinate_value(w, products[k][1], i, point, b);
            fmpq_addmul(target + point, a, b);
        }
        fmpq_mul(target + point, target + point, scale);
    }
    fmpq_clear(scale);
    fmpq_clear(b);
    fmpq_clear(a);
}

/* Returns a difference of coordinates number i, as a sum of them. */
static struct linear linear_pair(const struct vectors_found *w, const int pair[2])
{
    struct linear plus = {.is = true}, minus = {.is = true};
    plus.of[pair[0]] = 1.0;
    minus.of[pair[1]] = 1.0;
    return linear_sum(w, &plus, &minus, -1);
}

/* Returns `over` times a coordinate of a vector, as print_text() prints it. */
static struct linear linear_text(const struct vectors_found *w, const struct vector *v)
{
    struct linear sum[2] = {{.is = true}, {.is = true}};
    for (int k = 0; k < v->pairs; k += 2) {
        sum[k / 2] = linear_pair(w, v->pair[k]);
        if (k + 1 < v->pairs) {
            const struct linear next = linear_pair(w, v->pair[k + 1]);
            sum[k / 2] = linear_sum(w, &sum[k / 2], &next, 1);
        }
    }
    return v->pairs > 2 ? linear_sum(w, &sum[0], &sum[1], 1) : sum[0];
}

/* Returns coordinate i of a printed vector, without its factor; x: all operations as sums of coordinates number i. */
static struct linear linear_printed(const struct vectors_found *w, size_t v, size_t i, const struct linear *x)
{
    const struct coordinate *c = &w->at[v][i];
    const struct linear a = c->op < 0 ? linear_text(w, &w->vector[v]) : x[c->op];
    struct linear printed;
    fmpq_t times;
    fmpq_init(times);
    double_rational(times, 1.0 / (c->op < 0 ? w->vector[v].over : c->factor));
    printed = linear_multiple(&a, times);
    fmpq_clear(times);
    return printed;
}

/* Returns product k of the printed vectors. */
static struct quadratic printed_product(const struct vectors_found *w, size_t k, struct linear *const x[3])
{
    struct quadratic sum = {.is = true};
    for (size_t i = 0; i < 3; i++) {
        const struct linear a = linear_printed(w, products[k][0], i, x[i]);
        const struct linear b = linear_printed(w, products[k][1], i, x[i]);
        const struct quadratic q = quadratic_product(w, &a, &b, i);
        sum = quadratic_sum(&sum, &q);
    }
    return sum;
}

/* Finds products that the function has as sums of products of coordinates with known rounding errors. */
static void search_products(struct vectors_found *w, const struct program *p)
{
    struct linear *x[3];
    struct quadratic *q = new_array(p->ops, sizeof *q);
    for (size_t i = 0; i < 3; i++)
        x[i] = linear_all(w, p, i);
    for (size_t op = 0; op < p->ops; op++)
        q[op] = quadratic_operation(w, p, op, x, q);
    w->product_rounding = 2.0 * w->rounding + 3.0; /* as in footpoint_detail_quad4_touch() */
    for (size_t k = 0; k < PRODUCTS; k++) {
        fmpq *target = _fmpq_vec_init(POINTS);
        product_values(w, k, target);
        struct coordinate *c = &w->product[k];
        *c = search_operation(w, p, target);
        double units =
            c->op < 0 ? INFINITY : product_units(w, &q[c->op], k) / fabs(c->factor) / (w->factor[0] * w->factor[0]);
        if (!isfinite(units)) {
            const struct quadratic printed = printed_product(w, k, x);
            c->op = -1;
            units = product_units(w, &printed, k);
        }
        w->product_rounding = fmax(w->product_rounding, units);
        _fmpq_vec_clear(target, POINTS);
    }
    for (size_t i = 0; i < 3; i++)
        free(x[i]);
    free(q);
}

static void search_squares(struct vectors_found *w, const struct program *p)
{
    fmpq_t x, scale;
    fmpq_init(x);
    fmpq_init(scale);
    double_rational(scale, w->factor[0]);
    for (size_t v = 0; v < VECTORS; v++) {
        fmpq *target = _fmpq_vec_init(POINTS);
        for (size_t point = 0; point < POINTS; point++)
            for (size_t i = 0; i < 3; i++) {
                coordinate_value(w, v, i, point, x);
                fmpq_mul(x, x, scale);
                fmpq_addmul(target + point, x, x);
            }
        const struct coordinate c = search_operation(w, p, target);
        w->square[v] = c.factor == 1.0 ? c.op : -1;
        _fmpq_vec_clear(target, POINTS);
    }
    fmpq_clear(scale);
    fmpq_clear(x);
}

static void search_vectors(struct vectors_found *w, const struct program *p)
{
    for (size_t v = 0; v < VECTORS; v++)
        for (size_t i = 0; i < 3; i++) {
            fmpq *target = _fmpq_vec_init(POINTS);
            for (size_t point = 0; point < POINTS; point++)
                coordinate_value(w, v, i, point, target + point);
            w->at[v][i] = w->vector[v].pairs > 0 ? search_operation(w, p, target) : (struct coordinate){-1, 0.0};
            _fmpq_vec_clear(target, POINTS);
        }
    w->rounding = ROUNDING_OF_TEXT;
    for (size_t i = 0; i < 3; i++)
        bound_rounding(w, p, i);
    for (size_t v = 0; v < VECTORS; v += VECTORS - 1) { /* c1 and d determine the factors of all */
        const struct coordinate *c = w->at[v];
        const double factor = c[0].op >= 0 ? c[0].factor : c[1].op >= 0 ? c[1].factor : c[2].factor;
        w->factor[v > 0] = factor != 0.0 ? factor : w->vector[v].over;
    }
}

static void find_values(struct vectors_found *w, const struct program *p)
{
    uint64_t stream = 1;
    for (size_t point = 0; point < POINTS; point++) {
        fmpq *input = _fmpq_vec_init((slong)p->inputs);
        w->values = (slong)p->ops;
        w->value[point] = _fmpq_vec_init(w->values);
        w->known[point] = new_array(p->ops, sizeof *w->known[point]);
        for (size_t i = 0; i < p->inputs; i++)
            fmpq_set_si(input + i, (slong)(random_next(&stream) >> 40), 1);
        point_rational(p, p->ops, input, w->value[point], w->known[point]);
        _fmpq_vec_clear(input, (slong)p->inputs);
    }
}

/* Forgets operations: functions with coordinates relative to the segment do not have these values, and proofs in float use all
 * vectors four times as long, as in their texts. */
static void forget_operations(struct vectors_found *w, const struct program *p)
{
    for (size_t point = 0; point < POINTS; point++)
        for (size_t op = p->inputs; op < p->ops; op++)
            w->known[point][op] = false;
}

/* Marks the operands of marked operations. */
static void mark_needed(struct vectors_found *w, const struct program *p)
{
    for (size_t op = p->ops; op-- > 0;) {
        if (w->needed[op] && p->op[op].a >= 0)
            w->needed[p->op[op].a] = true;
        if (w->needed[op] && p->op[op].b >= 0)
            w->needed[p->op[op].b] = true;
    }
}

void vectors_find(struct vectors_found *w, const struct unit *u, const struct function *f)
{
    *w = (struct vectors_found){.vector = u->file->segment->bilinear ? bilinear : flat};
    find_values(w, f->program);
    if (f->scaled || u->options.precision == PRECISION_FLOAT)
        forget_operations(w, f->program);
    search_vectors(w, f->program);
    search_squares(w, f->program);
    w->needed = new_array(f->program->ops, sizeof *w->needed);
    for (size_t v = 0; v < VECTORS; v++) {
        for (size_t i = 0; i < 3; i++)
            if (w->at[v][i].op >= 0)
                w->needed[w->at[v][i].op] = true;
        if (w->square[v] >= 0 && v < VECTORS - 1)
            w->needed[w->square[v]] = true;
    }
    mark_needed(w, f->program);
}

void vectors_find_products(struct vectors_found *w, const struct function *f)
{
    search_products(w, f->program);
    for (size_t k = 0; k < PRODUCTS; k++)
        if (w->product[k].op >= 0)
            w->needed[w->product[k].op] = true;
    mark_needed(w, f->program);
}

void vectors_clear(struct vectors_found *w)
{
    for (size_t point = 0; point < POINTS; point++) {
        _fmpq_vec_clear(w->value[point], w->values);
        free(w->known[point]);
    }
    free(w->needed);
}

/* Prints "(xB[0] - xA[0] + (xC[0] - xD[0]))": `over` times a coordinate of a vector. */
static void print_text(const struct vectors_found *w, size_t v, size_t i, FILE *out)
{
    const struct vector *vector = &w->vector[v];
    const char *const name = w->vector == bilinear ? "ABCDS" : "ABCS";
    for (int k = 0; k < vector->pairs; k++)
        fprintf(out, "%sx%c[%zu] - x%c[%zu]%s", k ? " + (" : "(", name[vector->pair[k][0]], i, name[vector->pair[k][1]],
                i, k % 2 ? ")" : "");
    fputs(vector->pairs > 2 ? "))" : ")", out);
}

/* Prints "const double a[3] = {-t3, 0.5 * t4, t5};": a vector times its factor. */
static void print_vector(const struct vectors_found *w, size_t v, struct printer *r, char name, FILE *out)
{
    fprintf(out, "    const REAL %c[3] = {", name);
    for (size_t i = 0; i < 3; i++) {
        const struct coordinate *c = &w->at[v][i];
        const double times = w->factor[v == VECTORS - 1] / (c->op < 0 ? w->vector[v].over : c->factor);
        fputs(i ? ", " : "", out);
        if (times == -1.0)
            fputc('-', out);
        else if (times != 1.0)
            fprintf(out, "%.17g * ", times);
        if (c->op >= 0) {
            char *text = printer_text(r, c->op, LEVEL_NAME);
            fputs(text, out);
            free(text);
        } else
            print_text(w, v, i, out);
    }
    fputs("};\n", out);
}

char *vectors_size(const struct vectors_found *w, struct printer *r)
{
    struct memory *m = memory_open();
    for (size_t v = 0; v < VECTORS - 1 && w->vector[v].pairs > 0; v++) {
        char *text = w->square[v] < 0 ? new_format("footpoint_detail_dot(%c, %c)", "abc"[v], "abc"[v])
                                      : printer_text(r, w->square[v], LEVEL_SUM);
        fprintf(m->stream, "%s%s", v ? " + " : "", text);
        free(text);
    }
    return memory_close(m);
}

void vectors_print(const struct vectors_found *w, struct printer *r, FILE *out)
{
    for (size_t v = 0; v < VECTORS; v++)
        if (w->vector[v].pairs > 0)
            print_vector(w, v, r, "abcd"[v], out);
}

char *vectors_product(const struct vectors_found *w, struct printer *r, size_t k)
{
    const struct coordinate *c = &w->product[k];
    const char a = "abcd"[products[k][0]], b = "abcd"[products[k][1]];
    const double times = b == 'd' ? w->factor[0] / w->factor[1] : 1.0;
    if (c->op < 0)
        return times == 1.0 ? new_format("footpoint_detail_dot(%c, %c)", a, b)
                            : new_format("%.17g * footpoint_detail_dot(%c, %c)", times, a, b);
    char *text = printer_text(r, c->op, LEVEL_NAME);
    char *whole = c->factor == 1.0 ? new_format("%s", text) : new_format("%.17g * %s", 1.0 / c->factor, text);
    free(text);
    return whole;
}
