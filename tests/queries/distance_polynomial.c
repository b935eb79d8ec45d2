/* Computes the distance polynomial; see distance_polynomial.h.  Every face is a polynomial of degree 2 in each parameter, given by its
 * values at 0, 1/2 and 1, so the squared distance has degree 4. */
#include "distance_polynomial.h"

const char *const query_kind_name[QUERY_KINDS] = {"tri3", "quad4", "tri6", "quad8", "quad9"};
const int query_kind_nodes[QUERY_KINDS] = {3, 4, 6, 8, 9};
const int query_kind_corners[QUERY_KINDS] = {3, 4, 3, 4, 4};

void polynomial_init(struct polynomial *f)
{
    for (int i = 0; i < POWERS * POWERS; i++) {
        arb_init(f->m[i]);
        arb_init(f->b[i]);
    }
}

void polynomial_clear(struct polynomial *f)
{
    for (int i = 0; i < POWERS * POWERS; i++) {
        arb_clear(f->m[i]);
        arb_clear(f->b[i]);
    }
}

/* Adds weight / 4 times component k of a node. */
static void add_node(arb_t sum, const double *x, int node, int k, int weight)
{
    arb_t term;
    arb_init(term);
    arb_set_d(term, x[3 * node + k]);
    arb_mul_si(term, term, weight, PRECISION);
    arb_mul_2exp_si(term, term, -2);
    arb_add(sum, sum, term, PRECISION);
    arb_clear(term);
}

void polynomial_weights(enum query_kind kind, int i, int j, int weight[QUERY_NODES])
{
    static const int grid[QUERY_NODES][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
    for (int n = 0; n < QUERY_NODES; n++)
        weight[n] = 0;
    if (query_kind_corners[kind] == 3) {
        const int u = i, v = j,
                  w = 2 - i - j; /* twice the coordinates; shape functions of six nodes are w (w - 1)/2, u w */
        const int six[6] = {w * (w - 1) * 2, u * (u - 1) * 2, v * (v - 1) * 2, 4 * u * w, 4 * u * v, 4 * v * w};
        for (int n = 0; n < 6 && kind == QUERY_TRI6; n++)
            weight[n] = six[n];
        for (int n = 0; n < 3 && kind == QUERY_TRI3; n++)
            weight[n] = 2 * (n == 0 ? w : n == 1 ? u : v);
    } else if (kind == QUERY_QUAD4) {
        for (int n = 0; n < 4; n++)
            weight[n] = (grid[n][0] ? i : 2 - i) * (grid[n][1] ? j : 2 - j);
    } else if (kind == QUERY_QUAD8 && i == 1 && j == 1) {
        for (int n = 0; n < 8; n++)
            weight[n] = n < 4 ? -1 : 2;
    } else {
        for (int n = 0; n < QUERY_NODES; n++)
            weight[n] = grid[n][0] == i && grid[n][1] == j ? 4 : 0;
    }
}

/* Converts values at 0, 1/2, 1, a stride apart, to coefficients of powers. */
static void interpolate(arb_t *g, int stride)
{
    arb_t half, sum;
    arb_init(half);
    arb_init(sum);
    arb_add(sum, g[0], g[2 * stride], PRECISION);
    arb_mul_2exp_si(sum, sum, 1);
    arb_mul_2exp_si(half, g[stride], 2);
    arb_sub(sum, sum, half, PRECISION); /* 2 g0 - 4 g1 + 2 g2 */
    arb_sub(g[stride], g[2 * stride], g[0], PRECISION);
    arb_sub(g[stride], g[stride], sum, PRECISION); /* g2 - g0 - that */
    arb_set(g[2 * stride], sum);
    arb_clear(half);
    arb_clear(sum);
}

static void add_square(struct polynomial *f, arb_t r[9])
{
    for (int a = 0; a < 9; a++)
        for (int b = 0; b < 9; b++)
            arb_addmul(f->m[POWERS * (a / 3 + b / 3) + a % 3 + b % 3], r[a], r[b], PRECISION);
}

/* Computes b_i = sum over j <= i of C(i, j) / C(4, j) m_j, a stride apart. */
static void to_bernstein(arb_t *c, int stride)
{
    static const int choose[POWERS][POWERS] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
    arb_t term;
    arb_init(term);
    for (int j = 0; j < POWERS; j++)
        arb_div_si(c[j * stride], c[j * stride], choose[DEGREE][j], PRECISION);
    for (int i = DEGREE; i > 0; i--)
        for (int j = 0; j < i; j++) {
            arb_mul_si(term, c[j * stride], choose[i][j], PRECISION);
            arb_add(c[i * stride], c[i * stride], term, PRECISION);
        }
    arb_clear(term);
}

static void finish(struct polynomial *f)
{
    for (int i = 0; i < POWERS * POWERS; i++)
        arb_set(f->b[i], f->m[i]);
    for (int j = 0; j < (f->parameters == 2 ? POWERS : 1); j++)
        to_bernstein(f->b + j, POWERS);
    for (int i = 0; i < POWERS && f->parameters == 2; i++)
        to_bernstein(f->b + POWERS * i, 1);
}

static void start(struct polynomial *f, int parameters)
{
    f->parameters = parameters;
    for (int i = 0; i < POWERS * POWERS; i++)
        arb_zero(f->m[i]);
}

void polynomial_of_face(struct polynomial *f, enum query_kind kind, const double *x)
{
    arb_t r[9];
    for (int i = 0; i < 9; i++)
        arb_init(r[i]);
    start(f, 2);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 9; i++) {
            int weight[QUERY_NODES];
            polynomial_weights(kind, i / 3, i % 3, weight);
            arb_zero(r[i]);
            for (int n = 0; n < query_kind_nodes[kind]; n++)
                add_node(r[i], x, n, k, weight[n]);
            add_node(r[i], x, query_kind_nodes[kind], k, -4);
        }
        for (int i = 0; i < 3; i++)
            interpolate(r + i, 3);
        for (int i = 0; i < 3; i++)
            interpolate(r + 3 * i, 1);
        add_square(f, r);
    }
    finish(f);
    for (int i = 0; i < 9; i++)
        arb_clear(r[i]);
}

void polynomial_of_edge(struct polynomial *f, enum query_kind kind, const double *x, int edge)
{
    const int corners = query_kind_corners[kind], next = (edge + 1) % corners;
    arb_t r[9];
    for (int i = 0; i < 9; i++)
        arb_init(r[i]);
    start(f, 1);
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 9; i++)
            arb_zero(r[i]);
        add_node(r[0], x, edge, k, 4);
        add_node(r[6], x, next, k, 4);
        if (query_kind_nodes[kind] > corners)
            add_node(r[3], x, corners + edge, k, 4);
        else
            add_node(r[3], x, edge, k, 2), add_node(r[3], x, next, k, 2);
        for (int i = 0; i < 9; i += 3)
            add_node(r[i], x, query_kind_nodes[kind], k, -4);
        interpolate(r, 3);
        add_square(f, r);
    }
    finish(f);
    for (int i = 0; i < 9; i++)
        arb_clear(r[i]);
}

/* Evaluates p and its first and second derivative by Horner's rule; p: coefficients. */
static void horner(arb_t *p, int n, const arb_t x, arb_t d[3])
{
    for (int k = 0; k < 3; k++)
        arb_zero(d[k]);
    for (int i = n - 1; i >= 0; i--) {
        for (int k = 2; k > 0; k--) {
            arb_mul(d[k], d[k], x, PRECISION);
            arb_add(d[k], d[k], d[k - 1], PRECISION);
        }
        arb_mul(d[0], d[0], x, PRECISION);
        arb_add(d[0], d[0], p[i], PRECISION);
    }
    arb_mul_2exp_si(d[2], d[2], 1);
}

void polynomial_jet(const struct polynomial *f, arb_t z[2], arb_t jet[JET])
{
    static const int at[3][3] = {{VALUE, D_T, D_TT}, {D_S, D_ST, -1}, {D_SS, -1, -1}}; /* derivatives by s, by t */
    arb_t p[POWERS], row[3][POWERS], d[3];
    for (int i = 0; i < POWERS; i++)
        arb_init(p[i]), arb_init(row[0][i]), arb_init(row[1][i]), arb_init(row[2][i]);
    for (int k = 0; k < 3; k++)
        arb_init(d[k]);
    for (int j = 0; j < POWERS; j++) {
        for (int i = 0; i < POWERS; i++)
            arb_set(p[i], f->m[POWERS * i + j]);
        horner(p, POWERS, z[0], d);
        for (int k = 0; k < 3; k++)
            arb_set(row[k][j], d[k]);
    }
    for (int k = 0; k < 3; k++) {
        horner(row[k], POWERS, z[1], d);
        for (int l = 0; l < 3; l++)
            if (at[k][l] >= 0)
                arb_set(jet[at[k][l]], d[l]);
    }
    for (int i = 0; i < POWERS; i++)
        arb_clear(p[i]), arb_clear(row[0][i]), arb_clear(row[1][i]), arb_clear(row[2][i]);
    for (int k = 0; k < 3; k++)
        arb_clear(d[k]);
}
