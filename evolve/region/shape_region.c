/* Segments by their shape; see shape_region.h. About a reference point, with u = xi - xi0 and v = eta - eta0,
 *
 *     r = r0 + u e1 + v e2 + sum of u^i v^j c_ij,   c_ij = a_ij e1 + b_ij e2 + h_ij ez,
 *     e1 = k ex,   e2 = stretch (skew ex + ey),   k stretch = 1:
 *
 * e1 is along x, both are in the x-y plane, and the parallelogram that they span has area 1. The slave node is S = r +
 * l n, n = dr/dxi x dr/deta. The inputs for h and l are these times stretch + k, about the length of the longer of e1
 * and e2, so that their ranges hardly depend on the aspect ratio.
 *
 * Scalar products of these vectors are polynomials of the shape numbers, as are p and q, the components of d = S - r0
 * along e1 and e2. The block contains all of them, because the values that frames compute from nodes are equal to them
 * or multiples of them. With n x ez = U in the plane, U = u1 e1 + u2 e2: n.e1 = u2, n.e2 = -u1. */
#include "shape_region.h"

#include "../../codegen/base/text.h"
#include "../common/vec3.h"

#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NODES = 9, LINEAR = 3 /* of the powers below: 1, u, v */ };

static const int power[NODES][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 0}, {0, 2}, {2, 1}, {1, 2}, {2, 2}};

/* Values, first and second derivatives: by u, by v; by u u, u v, v v. */
static const char *const power_text[NODES][6] = {
    [3] = {"* u v", "v", "u", "0", "1", "0"},
    [4] = {"* u u", "* 2 u", "0", "2", "0", "0"},
    [5] = {"* v v", "0", "* 2 v", "0", "0", "2"},
    [6] = {"* u m11", "* 2 m11", "m20", "* 2 v", "* 2 u", "0"},
    [7] = {"* v m11", "m02", "* 2 m11", "0", "* 2 v", "* 2 u"},
    [8] = {"* m11 m11", "* 2 m12", "* 2 m21", "* 2 m02", "* 4 m11", "* 2 m20"}};

/* The kinds: their powers and their frames' reference points. */
static const struct row {
    const char *kind, *reference;
    int powers[NODES]; /* indexed by node: an index of power[] */
} table[] = {{"tri3", "/ 1 3", {0, 1, 2}},
             {"quad4", "0", {0, 1, 2, 3}},
             {"tri6", "/ 1 3", {0, 1, 2, 3, 4, 5}},
             {"quad8", "0", {0, 1, 2, 3, 4, 5, 6, 7}},
             {"quad9", "0", {0, 1, 2, 3, 4, 5, 6, 7, 8}}};

/* Nodes in the order of the kind's letters. */
static const char *const square[NODES][2] = {{"-1", "-1"}, {"1", "-1"}, {"1", "1"},  {"-1", "1"}, {"0", "-1"},
                                             {"1", "0"},   {"0", "1"},  {"-1", "0"}, {"0", "0"}};
static const char *const triangle[NODES][2] = {{"0", "0"},   {"1", "0"},     {"0", "1"},
                                               {"0.5", "0"}, {"0.5", "0.5"}, {"0", "0.5"}};

struct shape {
    const struct segment_kind *kind;
    const struct row *row;
    size_t nodes;
    double reference;
    double inverse[NODES][NODES]; /* maps nodes to coefficients of the powers */
};

static const char *const *node_place(const struct shape *p, size_t node)
{
    return p->kind->triangle ? triangle[node] : square[node];
}

static const int *node_power(const struct shape *p, size_t k)
{
    return power[p->row->powers[k]];
}

static double raised(double u, int i, double v, int j)
{
    return gsl_pow_int(u, i) * gsl_pow_int(v, j);
}

static void invert(struct shape *p)
{
    const size_t n = p->nodes;
    int sign;
    gsl_matrix *m = gsl_matrix_alloc(n, n), *inverse = gsl_matrix_alloc(n, n);
    gsl_permutation *order = gsl_permutation_alloc(n);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++) {
            const char *const *at = node_place(p, i);
            gsl_matrix_set(m, i, k,
                           raised(strtod(at[0], NULL) - p->reference, node_power(p, k)[0],
                                  strtod(at[1], NULL) - p->reference, node_power(p, k)[1]));
        }
    gsl_linalg_LU_decomp(m, order, &sign);
    gsl_linalg_LU_invert(m, order, inverse);
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < n; k++)
            p->inverse[i][k] = gsl_matrix_get(inverse, i, k);
    gsl_matrix_free(m);
    gsl_matrix_free(inverse);
    gsl_permutation_free(order);
}

struct shape *shape_new(const struct segment_kind *kind)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(table[i].kind, kind->name) == 0) {
            struct shape *p = new_array(1, sizeof *p);
            *p = (struct shape){.kind = kind, .row = &table[i], .nodes = strlen(kind->nodes)};
            p->reference = kind->triangle ? 1.0 / 3 : 0;
            invert(p);
            return p;
        }
    return NULL;
}

size_t shape_numbers(const struct shape *p)
{
    return 2 + 3 * (p->nodes - LINEAR) + 3;
}

/* Returns true if the kind has curved edges. */
static bool is_curved(const struct shape *p)
{
    return p->nodes > LINEAR + 1;
}

/* ---- the block ---- */

/* Writes "+ ", once less than there are terms. */
static void add_signs(FILE *out, size_t terms)
{
    for (size_t i = 1; i < terms; i++)
        fputs("+ ", out);
}

/* Writes a node's u or v. */
static void add_local(const struct shape *p, FILE *out, size_t node, int which)
{
    const char *at = node_place(p, node)[which];
    if (p->reference == 0)
        fprintf(out, "%s ", at);
    else
        fprintf(out, "- %s %s ", at, p->row->reference);
}

/* Writes r - r0 at a node. */
static void add_node(const struct shape *p, FILE *out, size_t node)
{
    add_signs(out, p->nodes - 1);
    for (size_t k = 1; k < p->nodes; k++) {
        const int *ij = node_power(p, k);
        for (int c = 0; c < ij[0] + ij[1]; c++)
            fputs("* ", out);
        for (int c = 0; c < ij[0] + ij[1]; c++)
            add_local(p, out, node, c >= ij[0]);
        fprintf(out, "c%d%d ", ij[0], ij[1]);
    }
}

/* Writes the sum of coefficients LETTERij times powers FACTORij, which may be derivatives, after the text `first`. */
static void add_sum(const struct shape *p, FILE *out, const char *name, const char *first, const char *letter,
                    const char *factor)
{
    fprintf(out, "let %s = ", name);
    add_signs(out, p->nodes - LINEAR + (*first != '\0'));
    fputs(*first ? first : p->nodes == LINEAR ? "0" : "", out);
    for (size_t k = LINEAR; k < p->nodes; k++) {
        const int *ij = node_power(p, k);
        fprintf(out, " * %s%d%d %s%d%d", letter, ij[0], ij[1], factor, ij[0], ij[1]);
    }
    fputc('\n', out);
}

static void add_inputs(const struct shape *p, FILE *out)
{
    fprintf(out, "footpoint-genome 2\nsegment %s any\nregion\n", p->kind->name);
    fputs("input vector A vector ex vector ey vector ez\ninput stretch skew", out);
    for (size_t k = LINEAR; k < p->nodes; k++) {
        const int *ij = node_power(p, k);
        fprintf(out, " a%d%d b%d%d g%d%d", ij[0], ij[1], ij[0], ij[1], ij[0], ij[1]);
    }
    fputs(" xi eta lift\nrange A 0 0 0 0 0 0\nrange ex 1 1 0 0 0 0\nrange ey 0 0 1 1 0 0\nrange ez 0 0 0 0 1 1\n", out);
}

/* Writes u^i v^j and their derivatives. */
static void add_powers(const struct shape *p, FILE *out)
{
    fprintf(out, "let u = - xi %s, v = - eta %s\n", p->row->reference, p->row->reference);
    for (size_t k = LINEAR; k < p->nodes; k++) {
        const int which = p->row->powers[k], i = power[which][0], j = power[which][1];
        fprintf(out, "let m%d%d = %s, mu%d%d = %s, mv%d%d = %s\n", i, j, power_text[which][0], i, j,
                power_text[which][1], i, j, power_text[which][2]);
        if (is_curved(p))
            fprintf(out, "let muu%d%d = %s, muv%d%d = %s, mvv%d%d = %s\n", i, j, power_text[which][3], i, j,
                    power_text[which][4], i, j, power_text[which][5]);
    }
}

static void add_vectors(const struct shape *p, FILE *out)
{
    fputs("let k = / 1 stretch, length = + stretch k, c10 = * k ex, c01 = * stretch + * skew ex ey\n", out);
    for (size_t k = LINEAR; k < p->nodes; k++) {
        const int i = node_power(p, k)[0], j = node_power(p, k)[1];
        fprintf(out, "let h%d%d = / g%d%d length, c%d%d = + + * a%d%d c10 * b%d%d c01 * h%d%d ez\n", i, j, i, j, i, j,
                i, j, i, j, i, j);
    }
    fputs("let rA = ", out);
    add_node(p, out, 0);
    for (size_t node = 1; node < p->nodes; node++) {
        fprintf(out, "\nlet %c = - ", p->kind->nodes[node]);
        add_node(p, out, node);
        fputs("rA", out);
    }
    fputs("\nlet l = / lift length\n", out);
    add_sum(p, out, "r", "+ * u c10 * v c01", "c", "m");
    add_sum(p, out, "ru", "c10", "c", "mu");
    add_sum(p, out, "rv", "c01", "c", "mv");
    fputs("let S = + - r rA * l cross ru rv\n", out);
}

/* Writes the products of c_ij with another vector of coefficients, for these vectors only. */
static void add_products(const struct shape *p, FILE *out)
{
    fputs("let e11 = * k k, e22 = * * stretch stretch + 1 * skew skew\n", out);
    for (size_t k = LINEAR; k < p->nodes; k++) {
        const int i = node_power(p, k)[0], j = node_power(p, k)[1];
        fprintf(out, "let p%d%d = + * a%d%d e11 * b%d%d skew, q%d%d = + * a%d%d skew * b%d%d e22\n", i, j, i, j, i, j,
                i, j, i, j, i, j);
    }
    for (size_t k = LINEAR; k < p->nodes; k++)
        for (size_t other = LINEAR; other < p->nodes; other++) {
            const int *a = node_power(p, k), *b = node_power(p, other);
            fprintf(out, "let s%d%d%d%d = + + * a%d%d p%d%d * b%d%d q%d%d * h%d%d h%d%d\n", a[0], a[1], b[0], b[1],
                    a[0], a[1], b[0], b[1], a[0], a[1], b[0], b[1], a[0], a[1], b[0], b[1]);
        }
}

/* Writes u1, u2 and n.ez. If c11 is the only coefficient, terms that cancel are left out. */
static void add_normal(const struct shape *p, FILE *out)
{
    if (p->nodes == LINEAR + 1) {
        fputs("let u1 = * h11 u, u2 = neg * h11 v, nz = + 1 + * a11 v * b11 u\n", out);
        return;
    }
    add_sum(p, out, "alpha_u", "1", "a", "mu");
    add_sum(p, out, "alpha_v", "", "a", "mv");
    add_sum(p, out, "beta_u", "", "b", "mu");
    add_sum(p, out, "beta_v", "1", "b", "mv");
    add_sum(p, out, "gamma_u", "", "h", "mu");
    add_sum(p, out, "gamma_v", "", "h", "mv");
    fputs("let u1 = - * gamma_v alpha_u * gamma_u alpha_v, u2 = - * gamma_v beta_u * gamma_u beta_v\n"
          "let nz = - * alpha_u beta_v * alpha_v beta_u\n",
          out);
}

/* Writes d and its products with the vectors. */
static void add_distance(const struct shape *p, FILE *out)
{
    add_sum(p, out, "pm", "u", "a", "m");
    add_sum(p, out, "qm", "v", "b", "m");
    fputs("let p = + pm * l + * u1 skew * u2 e22, q = - qm * l + * u1 e11 * u2 skew\n", out);
    add_sum(p, out, "d1m", "+ * u e11 * v skew", "p", "m");
    add_sum(p, out, "d2m", "+ * u skew * v e22", "q", "m");
    fputs("let d1 = + d1m * l u2, d2 = - d2m * l u1\n", out);
    for (size_t k = LINEAR; k < p->nodes; k++) {
        const int i = node_power(p, k)[0], j = node_power(p, k)[1];
        char name[8], first[32], letter[8];
        snprintf(name, sizeof name, "dm%d%d", i, j);
        snprintf(first, sizeof first, "+ * u p%d%d * v q%d%d", i, j, i, j);
        snprintf(letter, sizeof letter, "s%d%d", i, j);
        add_sum(p, out, name, first, letter, "m");
        fprintf(out, "let d%d%d = + dm%d%d * l + - * a%d%d u2 * b%d%d u1 * h%d%d nz\n", i, j, i, j, i, j, i, j, i, j);
    }
}

/* Writes the first fundamental form at the foot point and its reduction by the gap: for straight edges as polynomials,
 * otherwise by products of vectors. Triangles use the local coordinates of their frames. */
static void add_forms(const struct shape *p, FILE *out)
{
    if (!is_curved(p)) {
        fputs("let foot_1 = + p11 * v s1111, foot_2 = + q11 * u s1111\n"
              "let foot_11 = + e11 * v + p11 foot_1, foot_22 = + e22 * u + q11 foot_2\n"
              "let foot_12 = + skew + * u p11 * v foot_2, lift_12 = * l h11, foot_12n = - foot_12 lift_12\n",
              out);
        return;
    }
    add_sum(p, out, "ruu", "", "c", "muu");
    add_sum(p, out, "ruv", "", "c", "muv");
    add_sum(p, out, "rvv", "", "c", "mvv");
    fputs("let normal = cross ru rv, foot_11 = dot ru ru, foot_12 = dot ru rv, foot_22 = dot rv rv\n"
          "let lift_11 = * l dot normal ruu, lift_12 = * l dot normal ruv, lift_22 = * l dot normal rvv\n"
          "let foot_11n = - foot_11 lift_11, foot_12n = - foot_12 lift_12, foot_22n = - foot_22 lift_22\n",
          out);
    if (p->kind->triangle)
        fputs("let foot_u = * 3 u, foot_v = * 3 v\n", out);
}

/* Writes values of Newton's steps at the foot point itself: that form, its determinant, and right-hand sides of the
 * steps for u and v. */
static void add_foot(const struct shape *p, FILE *out)
{
    if (p->nodes == LINEAR)
        return;
    add_forms(p, out);
    fputs("let foot_j = + * nz nz + * u1 + * u1 e11 * 2 * u2 skew * * u2 u2 e22\n", out);
    if (is_curved(p))
        fputs("let foot_jn = - * foot_11n foot_22n * foot_12n foot_12n\n", out);
    else
        fputs("let foot_jn = + foot_j * lift_12 + foot_12 foot_12n, foot_f1 = + * foot_11 u * foot_12 v\n"
              "let foot_f2 = + * foot_12 u * foot_22 v, foot_f1n = - foot_f1 * lift_12 v\n"
              "let foot_f2n = - foot_f2 * lift_12 u\n",
              out);
    fputs("let foot_i = / 1 foot_j, foot_in = / 1 foot_jn\n", out);
}

struct genome_file *shape_region(const struct shape *p)
{
    struct diag d;
    struct memory *m = memory_open();
    add_inputs(p, m->stream);
    add_powers(p, m->stream);
    add_vectors(p, m->stream);
    add_products(p, m->stream);
    add_normal(p, m->stream);
    add_distance(p, m->stream);
    add_foot(p, m->stream);
    fputs("end\n", m->stream);
    char *text = memory_close(m);
    struct genome_file *f = genome_parse("region", text, strlen(text), &d), *region = NULL;
    if (f) {
        region = f->region;
        f->region = NULL;
        genome_file_free(f);
        for (size_t i = 1; i < region->statements; i++)
            region->statement[i].joined = true; /* long lines are fine: nobody needs to read these */
    }
    free(text);
    return region;
}

/* ---- samples ---- */

/* Rotates and scales a vector into the axes. */
static void turn(double axis[3][3], const double v[3], double scale, double to[3])
{
    for (int k = 0; k < 3; k++)
        to[k] = scale * vector_dot(axis[k], v);
}

/* Computes coefficients, indexed by power, from differences to A, which keep their digits far from the origin. */
static void expand(const struct shape *p, const struct sample *s, double c[NODES][3])
{
    for (size_t i = 0; i < p->nodes; i++)
        for (int k = 0; k < 3; k++) {
            c[i][k] = 0;
            for (size_t node = 1; node < p->nodes; node++)
                c[i][k] += p->inverse[i][node] * (s->x[node][k] - s->x[0][k]);
        }
}

/* Finds axes and scale of the block. */
static double find_axes(double c[NODES][3], double axis[3][3])
{
    double n[3];
    vector_cross(c[1], c[2], n);
    const double area = sqrt(vector_dot(n, n)), length = sqrt(vector_dot(c[1], c[1]));
    for (int k = 0; k < 3; k++) {
        axis[0][k] = c[1][k] / length;
        axis[2][k] = n[k] / area;
    }
    vector_cross(axis[2], axis[0], axis[1]);
    return 1 / sqrt(area);
}

/* Returns l of the slave node; c must be in the axes. */
static double find_lift(const struct shape *p, double c[NODES][3], const struct sample *placed)
{
    const double u = placed->xi - p->reference, v = placed->eta - p->reference;
    double d[3], ru[3] = {0}, rv[3] = {0}, n[3];
    memcpy(d, placed->xs, sizeof d);
    for (size_t i = 0; i < p->nodes; i++) {
        const int *ij = node_power(p, i);
        for (int k = 0; k < 3; k++) {
            d[k] -= c[i][k] * raised(u, ij[0], v, ij[1]);
            ru[k] += ij[0] > 0 ? c[i][k] * ij[0] * raised(u, ij[0] - 1, v, ij[1]) : 0;
            rv[k] += ij[1] > 0 ? c[i][k] * ij[1] * raised(u, ij[0], v, ij[1] - 1) : 0;
        }
    }
    vector_cross(ru, rv, n);
    return vector_dot(d, n) / vector_dot(n, n);
}

void shape_measure(const struct shape *p, const struct sample *s, double number[SHAPE_NUMBERS], struct sample *placed)
{
    double c[NODES][3], axis[3][3], v[3];
    expand(p, s, c);
    const double scale = find_axes(c, axis);
    *placed = (struct sample){.xi = s->xi, .eta = s->eta};
    for (size_t i = 0; i <= p->nodes; i++) {
        const double *x = i < p->nodes ? s->x[i] : s->xs;
        for (int k = 0; k < 3; k++)
            v[k] = x[k] - s->x[0][k];
        turn(axis, v, scale, i < p->nodes ? placed->x[i] : placed->xs);
    }
    for (size_t i = 0; i < p->nodes; i++) {
        memcpy(v, c[i], sizeof v);
        turn(axis, v, scale, c[i]);
    }
    const double k = c[1][0], stretch = 1 / k, length = stretch + k;
    double *to = number;
    *to++ = stretch;
    *to++ = c[2][0] / c[2][1];
    for (size_t i = LINEAR; i < p->nodes; i++) {
        const double b = c[i][1] / c[2][1];
        *to++ = (c[i][0] - b * c[2][0]) / k;
        *to++ = b;
        *to++ = c[i][2] * length;
    }
    *to++ = s->xi;
    *to++ = s->eta;
    *to = find_lift(p, c, placed) * length;
}
