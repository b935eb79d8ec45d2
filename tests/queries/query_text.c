/* Reads queries; see query_text.h.  Shape functions are products of those along lines, as in text books. */
#include "query_text.h"

#include <math.h>
#include <string.h>

static quad magnitude(quad x)
{
    return x < 0 ? -x : x;
}

/* Reads a decimal number of up to 40 digits: whole digits in two parts, then powers of ten. */
static int read_quad(FILE *file, quad *x)
{
    char text[80], *at = text;
    quad sum = 0;
    int point = 0, power = 0, exponent = 0, negative;
    if (fscanf(file, "%79s", text) != 1)
        return 0;
    negative = *at == '-';
    at += negative;
    for (; (*at >= '0' && *at <= '9') || *at == '.'; at++) {
        point |= *at == '.';
        if (*at == '.')
            continue;
        sum = 10 * sum + (*at - '0');
        power -= point;
    }
    if (*at != '\0' && sscanf(at, "e%d", &exponent) != 1)
        return 0;
    quad ten = 1, base = 10;
    power += exponent;
    for (int n = power < 0 ? -power : power; n > 0; n /= 2, base *= base)
        ten *= n % 2 ? base : 1;
    sum = power < 0 ? sum / ten : sum * ten;
    *x = negative ? -sum : sum;
    return 1;
}

int query_read(FILE *file, struct query_text *q)
{
    static const char *const kinds[QUERY_TEXT_KINDS] = {"tri3", "quad4", "tri6", "quad8", "quad9"};
    static const int nodes[QUERY_TEXT_KINDS] = {3, 4, 6, 8, 9};
    const int got = fscanf(file, "%7s %15s %d %d", q->kind, q->family, &q->minima, &q->region);
    if (got == EOF)
        return 0;
    for (q->index = 0; q->index < QUERY_TEXT_KINDS && strcmp(q->kind, kinds[q->index]) != 0; q->index++)
        ;
    if (got != 4 || q->index == QUERY_TEXT_KINDS || q->minima < 1 || q->minima > QUERY_TEXT_MINIMA)
        return -1;
    q->nodes = nodes[q->index];
    q->corners = kinds[q->index][0] == 't' ? 3 : 4;
    for (int i = 0; i < 3 * (q->nodes + 1); i++)
        if (fscanf(file, "%lf", &q->x[i]) != 1)
            return -1;
    if (!read_quad(file, &q->distance))
        return -1;
    for (int i = 0; i < 2 * q->minima; i++)
        if (!read_quad(file, &q->loc[i / 2][i % 2]))
            return -1;
    q->length = 0;
    for (int i = 0; i < 3 * q->nodes; i++)
        q->length = fmax(q->length, fabs(q->x[i] - q->x[3 * q->nodes + i % 3]));
    return 1;
}

/* ---- shape functions ---- */

/* Computes value, first and second derivative of the parabola that is 1 at one of -1, 0, 1 and 0 at the others. */
static void line_quadratic(int node, quad x, quad d[3])
{
    const quad all[3][3] = {
        {x * (x - 1) / 2, x - (quad)0.5, 1}, {1 - x * x, -2 * x, -2}, {x * (x + 1) / 2, x + (quad)0.5, 1}};
    memcpy(d, all[node + 1], sizeof all[0]);
}

static void line_linear(int node, quad x, quad d[3])
{
    d[0] = (1 + node * x) / 2;
    d[1] = (quad)node / 2;
    d[2] = 0;
}

/* Computes value, xi, eta, xixi, xieta, etaeta of a product. */
static void product(const quad a[3], const quad b[3], quad n[6])
{
    const quad all[6] = {a[0] * b[0], a[1] * b[0], a[0] * b[1], a[2] * b[0], a[1] * b[1], a[0] * b[2]};
    memcpy(n, all, sizeof all);
}

static const int at_node[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};

static void quadrilateral_shape(const struct query_text *q, int node, const quad z[2], quad n[6])
{
    quad a[3], b[3];
    if (q->nodes == 4) {
        line_linear(at_node[node][0], z[0], a);
        line_linear(at_node[node][1], z[1], b);
    } else {
        line_quadratic(at_node[node][0], z[0], a);
        line_quadratic(at_node[node][1], z[1], b);
    }
    product(a, b, n);
    if (q->nodes == 8) { /* the middle is the edges' halves less the corners' quarters */
        quad middle[6];
        line_quadratic(0, z[0], a);
        line_quadratic(0, z[1], b);
        product(a, b, middle);
        for (int d = 0; d < 6; d++)
            n[d] += middle[d] * (node < 4 ? (quad)-0.25 : (quad)0.5);
    }
}

/* Shape functions are products of two of the area coordinates w, u, v less a constant. */
static void triangle_shape(const struct query_text *q, int node, const quad z[2], quad n[6])
{
    static const int slope[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
    const quad area[3] = {1 - z[0] - z[1], z[0], z[1]};
    const int corner = node % 3, other = node < 3 ? corner : (node + 1) % 3;
    if (q->nodes == 3) {
        const quad linear[6] = {area[node], slope[node][0], slope[node][1], 0, 0, 0};
        memcpy(n, linear, sizeof linear);
        return;
    }
    /* a (2 a - 1) or 4 a b */
    const int factor = node < 3 ? 2 : 4;
    const quad a = area[corner], b = node < 3 ? area[other] - (quad)0.5 : area[other];
    const int *const c = slope[corner], *const d = slope[other];
    const quad all[6] = {a * b,           c[0] * b + a * d[0],       c[1] * b + a * d[1],
                         2 * c[0] * d[0], c[0] * d[1] + c[1] * d[0], 2 * c[1] * d[1]};
    for (int k = 0; k < 6; k++)
        n[k] = factor * all[k];
}

void query_jet(const struct query_text *q, const quad loc[2], quad r[6][3])
{
    for (int d = 0; d < 6; d++)
        for (int k = 0; k < 3; k++)
            r[d][k] = d == 0 ? -(quad)q->x[3 * q->nodes + k] : 0;
    for (int node = 0; node < q->nodes; node++) {
        quad n[6];
        (q->corners == 3 ? triangle_shape : quadrilateral_shape)(q, node, loc, n);
        for (int d = 0; d < 6; d++)
            for (int k = 0; k < 3; k++)
                r[d][k] += n[d] * q->x[3 * node + k];
    }
}

static quad dot(const quad a[3], const quad b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Returns a root by Newton's method from the double's root. */
static quad root_of(quad x)
{
    int exponent;
    if (!(x > 0))
        return 0;
    exponent = 0;
    quad y = x;
    for (; y > 4; exponent++)
        y /= 4;
    for (; y < 1; exponent--)
        y *= 4;
    quad root = sqrt((double)y);
    root = (root + y / root) / 2;
    root = (root + y / root) / 2;
    for (; exponent > 0; exponent--)
        root *= 2;
    for (; exponent < 0; exponent++)
        root /= 2;
    return root;
}

quad query_distance(const struct query_text *q, const double loc[2])
{
    const quad z[2] = {loc[0], loc[1]};
    quad r[6][3];
    query_jet(q, z, r);
    return root_of(dot(r[0], r[0]));
}

double query_newton_step(const struct query_text *q, const double loc[2])
{
    const quad z[2] = {loc[0], loc[1]};
    quad r[6][3];
    query_jet(q, z, r);
    const quad gu = dot(r[0], r[1]), gv = dot(r[0], r[2]);
    const quad huu = dot(r[1], r[1]) + dot(r[0], r[3]), huv = dot(r[1], r[2]) + dot(r[0], r[4]);
    const quad hvv = dot(r[2], r[2]) + dot(r[0], r[5]), det = huu * hvv - huv * huv;
    if (!(huu > 0 && det > 0))
        return INFINITY;
    const quad u = magnitude((hvv * gu - huv * gv) / det), v = magnitude((huu * gv - huv * gu) / det);
    return (double)(u > v ? u : v);
}
