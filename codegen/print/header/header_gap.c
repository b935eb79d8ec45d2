/* The gap out of the search's own values; see header_gap.h.
 *
 * With r = c0 + xi c1 + eta c2 + xi eta c3 and d = xS - c0 the tangents are u = c1 + eta c3 and v = c2 + xi c3, and as
 * n = u x v is at right angles to both,
 *     (xS - r) . n = (d + xi eta c3) . n,
 * so that the gap takes c1, c2, c3, d and no more; of a flat triangle c3 = 0.  Every search has most of them, each times
 * a number of its own, and the squares of c1, c2, c3.  They are found by exact values at two points. */
#include "header_gap.h"

#include "../../base/random.h"
#include "../../base/text.h"
#include "../../program/dialects.h"
#include "../../program/evaluate.h"
#include "../c_text.h"
#include "../templates.h"
#include "header_lines.h"
#include "header_sizes.h"

#include <stdlib.h>
#include <string.h>

enum { VECTORS = 4, POINTS = 2, LARGEST = 3 }; /* c1, c2, c3, d; factors are powers of 2 from -LARGEST to LARGEST */

/* A vector of a kind: its coordinates are sums of those of A, B, ..., S times `coef` / `over`; `text` is `over` times it,
 * for where the search has it not. */
static const struct vector {
    int coef[5], over;
    const char *text;
} bilinear[VECTORS] =
    {
        {{-1, 1, 1, -1, 0}, 4, "(xB[#] - xA[#] + (xC[#] - xD[#]))"},
        {{-1, -1, 1, 1, 0}, 4, "(xD[#] - xA[#] + (xC[#] - xB[#]))"},
        {{1, -1, 1, -1, 0}, 4, "(xA[#] - xB[#] + (xC[#] - xD[#]))"},
        {{-1, -1, -1, -1, 4}, 4, "(xS[#] - xA[#] + (xS[#] - xB[#]) + (xS[#] - xC[#] + (xS[#] - xD[#])))"},
},
  flat[VECTORS] = {
      {{-1, 1, 0, 0}, 1, "(xB[#] - xA[#])"},
      {{-1, 0, 1, 0}, 1, "(xC[#] - xA[#])"},
      {{0, 0, 0, 0}, 1, ""},
      {{-1, 0, 0, 1}, 1, "(xS[#] - xA[#])"},
};

/* What a function has of them: operation `op`, or none (-1), is `factor` times the coordinate. */
struct coordinate {
    int op;
    double factor;
};

struct found {
    const struct vector *vector;
    struct coordinate at[VECTORS][3];
    int square[VECTORS]; /* operation: the square of `factor`[0] times the vector; -1 */
    double factor[2];    /* by which the function has c1, c2, c3, and d */
    bool *needed;        /* owned: by operation */
    fmpq *value[POINTS]; /* owned: exact values of the operations at points */
    bool *known[POINTS]; /* owned: those that have one */
};

bool gap_shares(const struct unit *u, const struct function *f)
{
    return u->file->order == CORNERS_ANY && lines_straight(u) && !f->scaled;
}

/* A coordinate of a vector at a point. */
static void coordinate_value(const struct found *w, size_t vector, size_t i, size_t point, size_t inputs, fmpq_t sum)
{
    const struct vector *v = &w->vector[vector];
    fmpq_t term;
    fmpq_init(term);
    fmpq_zero(sum);
    for (size_t k = 0; 3 * k < inputs; k++) {
        fmpq_set_si(term, v->coef[k], (ulong)v->over);
        fmpq_mul(term, term, w->value[point] + 3 * k + i);
        fmpq_add(sum, sum, term);
    }
    fmpq_clear(term);
}

/* The power of 2, with a sign, that an operation is times the targets, one a point; 0 if it is none. */
static double factor_of(const struct found *w, size_t op, const fmpq *target)
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

/* The first operation that is a multiple of the targets. */
static struct coordinate search_operation(const struct found *w, const struct program *p, const fmpq *target)
{
    struct coordinate c = {-1, 0.0};
    for (size_t op = p->inputs; op < p->ops && c.op < 0; op++)
        if ((c.factor = factor_of(w, op, target)) != 0.0)
            c.op = (int)op;
    return c;
}

static void search_squares(struct found *w, const struct program *p)
{
    fmpq_t x, scale;
    fmpq_init(x);
    fmpq_init(scale);
    double_rational(scale, w->factor[0]);
    for (size_t v = 0; v < VECTORS; v++) {
        fmpq *target = _fmpq_vec_init(POINTS);
        for (size_t point = 0; point < POINTS; point++)
            for (size_t i = 0; i < 3; i++) {
                coordinate_value(w, v, i, point, p->inputs, x);
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

static void search_vectors(struct found *w, const struct program *p)
{
    for (size_t v = 0; v < VECTORS; v++)
        for (size_t i = 0; i < 3; i++) {
            fmpq *target = _fmpq_vec_init(POINTS);
            for (size_t point = 0; point < POINTS; point++)
                coordinate_value(w, v, i, point, p->inputs, target + point);
            w->at[v][i] = *w->vector[v].text ? search_operation(w, p, target) : (struct coordinate){-1, 0.0};
            _fmpq_vec_clear(target, POINTS);
        }
    for (size_t v = 0; v < VECTORS; v += VECTORS - 1) { /* c1 and d say how all are taken */
        const struct coordinate *c = w->at[v];
        const double factor = c[0].op >= 0 ? c[0].factor : c[1].op >= 0 ? c[1].factor : c[2].factor;
        w->factor[v > 0] = factor != 0.0 ? factor : w->vector[v].over;
    }
}

static void find_values(struct found *w, const struct program *p)
{
    uint64_t stream = 1;
    for (size_t point = 0; point < POINTS; point++) {
        fmpq *input = _fmpq_vec_init((slong)p->inputs);
        w->value[point] = _fmpq_vec_init((slong)p->ops);
        w->known[point] = new_array(p->ops, sizeof *w->known[point]);
        for (size_t i = 0; i < p->inputs; i++)
            fmpq_set_si(input + i, (slong)(random_next(&stream) >> 40), 1);
        point_rational(p, p->ops, input, w->value[point], w->known[point]);
        _fmpq_vec_clear(input, (slong)p->inputs);
    }
}

static void mark_needed(struct found *w, const struct program *p)
{
    w->needed = new_array(p->ops, sizeof *w->needed);
    for (size_t v = 0; v < VECTORS; v++) {
        for (size_t i = 0; i < 3; i++)
            if (w->at[v][i].op >= 0)
                w->needed[w->at[v][i].op] = true;
        if (w->square[v] >= 0 && v < VECTORS - 1)
            w->needed[w->square[v]] = true;
    }
    for (size_t op = p->ops; op-- > 0;) {
        if (w->needed[op] && p->op[op].a >= 0)
            w->needed[p->op[op].a] = true;
        if (w->needed[op] && p->op[op].b >= 0)
            w->needed[p->op[op].b] = true;
    }
}

static void found_clear(struct found *w, const struct program *p)
{
    for (size_t point = 0; point < POINTS; point++) {
        _fmpq_vec_clear(w->value[point], (slong)p->ops);
        free(w->known[point]);
    }
    free(w->needed);
}

/* "const double a[3] = {-t3, 0.5 * t4, t5};": a vector times the factor that it is taken with. */
static void print_vector(const struct found *w, size_t v, struct printer *r, char name, FILE *out)
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
            for (const char *t = w->vector[v].text; *t; t++)
                fputc(*t == '#' ? "012"[i] : *t, out);
    }
    fputs("};\n", out);
}

/* The sum of the squares of c1, c2, c3 as they are taken. */
static char *size_text(const struct found *w, struct printer *r)
{
    struct memory *m = memory_open();
    for (size_t v = 0; v < VECTORS - 1 && *w->vector[v].text; v++) {
        char *text = w->square[v] < 0 ? new_format("footpoint_detail_dot(%c, %c)", "abc"[v], "abc"[v])
                                      : printer_text(r, w->square[v], LEVEL_SUM);
        fprintf(m->stream, "%s%s", v ? " + " : "", text);
        free(text);
    }
    return memory_close(m);
}

static void print_body(const struct unit *u, const struct function *f, const struct found *w, FILE *out)
{
    const char *kind = u->file->segment->name;
    const bool twisted = u->file->segment->bilinear;
    struct printer *r = c_print_needed(u, f, w->needed, out);
    struct memory *m = memory_open();
    for (size_t v = 0; v < VECTORS; v++)
        if (*w->vector[v].text)
            print_vector(w, v, r, "abcd"[v], m -> stream);
    char *size = size_text(w, r), *least = sizes_least_name(u),
         *ratio = new_format("ratio = %.17g, ", w->factor[1] / w->factor[0]);
    fprintf(m->stream, "    const REAL size = %s;\n    const REAL %sper = %.17g, unit = %.17g;\n", size,
            twisted ? ratio : "", 1.0 / w->factor[1], (twisted ? 4.0 : 1.0) / (w->factor[0] * w->factor[0]));
    fprintf(m->stream, "    return footpoint_detail_%s_over(a, b, %sd, size, %sper, unit, xi, eta, %s, gap);\n", kind,
            twisted ? "c, " : "", twisted ? "ratio, " : "", least);
    char *text = memory_close(m);
    c_print(text, u->options.precision, out);
    free(text);
    free(ratio);
    free(least);
    free(size);
    printer_free(r);
}

void gap_print(const struct unit *u, const struct function *f, FILE *out)
{
    struct found w = {.vector = u->file->segment->bilinear ? bilinear : flat};
    find_values(&w, f->program);
    search_vectors(&w, f->program);
    search_squares(&w, f->program);
    mark_needed(&w, f->program);
    char *head = new_format("%s_detail_gap", f->name);
    c_print("\nFOOTPOINT_PART REAL_BITS\n", u->options.precision, out);
    lines_print_head(u, head, "REAL xi,REAL eta,REAL *gap", out);
    fputs("{\n", out);
    print_body(u, f, &w, out);
    fputs("}\n", out);
    free(head);
    found_clear(&w, f->program);
}
