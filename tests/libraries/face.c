/* Closest points by subdivision; see face.h. All faces are polynomials of degree 2 in xi and in eta. So on a square,
 * half the squared distance has degree 4 in each, and its Bernstein coefficients bound it. Boxes that cannot contain
 * the minimum are dropped, others are halved. A triangle is a square with one edge of length 0. Newton's method in
 * extended precision polishes the result. */
#include "face.h"

#include <math.h>
#include <stddef.h>

enum { STEPS = 60, STARTS = 3, BOXES = 40000 };

#define TIE 1e-10   /* in longest edges: distances that count as equal */
#define LEFT 1e-8   /* ... left undecided between boxes */
#define FLAT 1e-5   /* ... from the closest point, if an equal distance suffices */
#define SMALL 1e-24 /* a step at which Newton's method has converged */

const int face_nodes[LIBRARY_KINDS] = {4, 6, 8, 9};

static wide size_of(wide x)
{
    return x < 0 ? -x : x;
}

static wide dot(const wide a[3], const wide b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- the polynomial ---- */

/* Computes the coefficients of a quadrilateral from its values at -1, 0, 1. */
static void from_grid(wide g[3][3][3], struct face *f)
{
    static const int from[3][3] = {{0, 2, 0}, {-1, 0, 1}, {1, -2, 1}}; /* twice the coefficient */
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++) {
                wide sum = 0;
                for (int p = 0; p < 3; p++)
                    for (int q = 0; q < 3; q++)
                        sum += from[i][p] * from[j][q] * g[p][q][k];
                f->c[i][j][k] = sum / 4;
            }
}

static void quadrilateral(int kind, const double *x, struct face *f)
{
    static const int at[9][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
    wide g[3][3][3];
    for (int k = 0; k < 3; k++) {
        wide corners = 0, middles = 0;
        for (int i = 0; i < 4; i++) {
            const int *const c = at[i], *const m = at[4 + i];
            g[c[0]][c[1]][k] = x[3 * i + k];
            g[m[0]][m[1]][k] =
                kind == LIBRARY_QUAD4 ? ((wide)x[3 * i + k] + x[3 * ((i + 1) % 4) + k]) / 2 : (wide)x[12 + 3 * i + k];
            corners += g[c[0]][c[1]][k];
            middles += g[m[0]][m[1]][k];
        }
        g[1][1][k] = kind == LIBRARY_QUAD9 ? (wide)x[24 + k] : middles / 2 - corners / 4;
    }
    from_grid(g, f);
}

static void triangle(const double *x, struct face *f)
{
    for (int k = 0; k < 3; k++) {
        const wide a = x[k], b = x[3 + k], c = x[6 + k], d = x[9 + k], e = x[12 + k], g = x[15 + k];
        f->c[0][0][k] = a;
        f->c[1][0][k] = 4 * d - 3 * a - b;
        f->c[0][1][k] = 4 * g - 3 * a - c;
        f->c[2][0][k] = 2 * (a + b - 2 * d);
        f->c[0][2][k] = 2 * (a + c - 2 * g);
        f->c[1][1][k] = 4 * (a - d + e - g);
        f->c[2][1][k] = f->c[1][2][k] = f->c[2][2][k] = 0;
    }
}

void face_of(int kind, const double *x, struct face *f)
{
    const int corners = kind == LIBRARY_TRI6 ? 3 : 4;
    f->kind = kind;
    f->edge = 0;
    for (int i = 0; i < corners; i++) {
        double square = 0;
        for (int k = 0; k < 3; k++)
            square += pow(x[3 * ((i + 1) % corners) + k] - x[3 * i + k], 2);
        f->edge = fmax(f->edge, sqrt(square));
    }
    if (kind == LIBRARY_TRI6)
        triangle(x, f);
    else
        quadrilateral(kind, x, f);
}

/* Computes position, first and second derivatives: by xi twice, xi and eta, eta twice. */
static void jet(const struct face *f, const wide z[2], wide r[6][3])
{
    const wide p[3][3] = {{1, z[0], z[0] * z[0]}, {0, 1, 2 * z[0]}, {0, 0, 2}},
               q[3][3] = {{1, z[1], z[1] * z[1]}, {0, 1, 2 * z[1]}, {0, 0, 2}};
    static const int order[6][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    for (int n = 0; n < 6; n++)
        for (int k = 0; k < 3; k++) {
            r[n][k] = 0;
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    r[n][k] += f->c[i][j][k] * p[order[n][0]][i] * q[order[n][1]][j];
        }
}

void face_jet(const struct face *f, const wide z[2], wide r[3], wide u[3], wide v[3])
{
    wide all[6][3], *const out[3] = {r, u, v};
    jet(f, z, all);
    for (int n = 0; n < 3; n++)
        for (int k = 0; out[n] && k < 3; k++)
            out[n][k] = all[n][k];
}

int face_holds(const struct face *f, const wide z[2], double slack)
{
    if (f->kind == LIBRARY_TRI6)
        return z[0] >= -slack && z[1] >= -slack && z[0] + z[1] <= 1 + slack;
    return size_of(z[0]) <= 1 + slack && size_of(z[1]) <= 1 + slack;
}

static wide square_at(const struct face *f, const double xs[3], const wide z[2])
{
    wide r[6][3], sum = 0;
    jet(f, z, r);
    for (int k = 0; k < 3; k++)
        sum += (xs[k] - r[0][k]) * (xs[k] - r[0][k]);
    return sum;
}

double face_distance(const struct face *f, const double xs[3], const wide z[2])
{
    return sqrt((double)square_at(f, xs, z));
}

/* ---- Newton's method ---- */

/* Computes gradient and Hessian of half the squared distance. */
static void expand(const struct face *f, const double xs[3], const wide z[2], wide g[2], wide h[3])
{
    wide r[6][3], d[3];
    jet(f, z, r);
    for (int k = 0; k < 3; k++)
        d[k] = xs[k] - r[0][k];
    g[0] = -dot(r[1], d);
    g[1] = -dot(r[2], d);
    h[0] = dot(r[1], r[1]) - dot(r[3], d);
    h[1] = dot(r[1], r[2]) - dot(r[4], d);
    h[2] = dot(r[2], r[2]) - dot(r[5], d);
}

/* Runs Newton's method on the face; returns 1 if it converges. */
static int newton_free(const struct face *f, const double xs[3], wide z[2])
{
    for (int n = 0; n < STEPS; n++) {
        wide g[2], h[3];
        expand(f, xs, z, g, h);
        const wide determinant = h[0] * h[2] - h[1] * h[1];
        if (determinant == 0)
            return 0;
        const wide p = (h[1] * g[1] - h[2] * g[0]) / determinant, q = (h[1] * g[0] - h[0] * g[1]) / determinant;
        z[0] += p;
        z[1] += q;
        if (!(size_of(z[0]) < (wide)1e9 && size_of(z[1]) < (wide)1e9))
            return 0;
        if (size_of(p) < (wide)SMALL && size_of(q) < (wide)SMALL)
            return 1;
    }
    return 0;
}

/* Returns the ends of an edge in xi and eta. */
static int ends_of(const struct face *f, int edge, wide a[2], wide b[2])
{
    static const int square[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}},
                     half[4][2] = {{0, 0}, {1, 0}, {0, 1}, {0, 0}};
    const int(*const at)[2] = f->kind == LIBRARY_TRI6 ? half : square;
    for (int k = 0; k < 2; k++) {
        a[k] = at[edge][k];
        b[k] = at[edge + 1][k];
    }
    return f->kind == LIBRARY_TRI6 ? 3 : 4;
}

/* Runs Newton's method along an edge, from its point nearest to z; the result is clamped to the ends. */
static void newton_edge(const struct face *f, const double xs[3], int edge, wide z[2])
{
    wide a[2], b[2], t = 0, length = 0;
    (void)ends_of(f, edge, a, b);
    for (int k = 0; k < 2; k++) {
        t += (z[k] - a[k]) * (b[k] - a[k]);
        length += (b[k] - a[k]) * (b[k] - a[k]);
    }
    t /= length;
    for (int n = 0; n < STEPS; n++) {
        wide g[2], h[3];
        t = t < 0 ? 0 : t > 1 ? 1 : t;
        for (int k = 0; k < 2; k++)
            z[k] = a[k] + t * (b[k] - a[k]);
        expand(f, xs, z, g, h);
        const wide p = b[0] - a[0], q = b[1] - a[1], slope = p * g[0] + q * g[1],
                   bend = p * p * h[0] + 2 * p * q * h[1] + q * q * h[2];
        const wide step = bend > 0 ? -slope / bend : slope > 0 ? (wide)-0.25 : (wide)0.25;
        if (size_of(step) < (wide)SMALL || (t == 0 && step < 0) || (t == 1 && step > 0))
            return;
        t += step;
    }
}

/* Calls `use` with the stationary points of the face and of its edges that Newton's method finds from z, and with the
 * ends of the edges. */
typedef void visitor(void *data, const wide z[2], int inside);

static void visit(const struct face *f, const double xs[3], const wide from[2], visitor *use, void *data)
{
    wide z[2] = {from[0], from[1]}, a[2], b[2];
    if (newton_free(f, xs, z) && face_holds(f, z, 0))
        use(data, z, 1);
    const int edges = ends_of(f, 0, a, b);
    for (int e = 0; e < edges; e++) {
        z[0] = from[0];
        z[1] = from[1];
        newton_edge(f, xs, e, z);
        use(data, z, 0);
        (void)ends_of(f, e, a, b);
        use(data, a, 0);
    }
}

/* ---- the least distance ---- */

struct best {
    const struct face *f;
    const double *xs;
    wide z[2], square, inside; /* nearest of all, and of stationary points inside */
};

static void improve(void *data, const wide z[2], int inside)
{
    struct best *const b = data;
    const wide square = square_at(b->f, b->xs, z);
    if (inside && square < b->inside)
        b->inside = square;
    if (square < b->square) {
        b->square = square;
        b->z[0] = z[0];
        b->z[1] = z[1];
    }
}

/* Maps the square (s,t) in [0,1]^2 to xi and eta. */
static void on_square(const struct face *f, long double s, long double t, wide z[2])
{
    z[0] = f->kind == LIBRARY_TRI6 ? (wide)s : 2 * (wide)s - 1;
    z[1] = f->kind == LIBRARY_TRI6 ? (wide)t * (1 - (wide)s) : 2 * (wide)t - 1;
}

struct box {
    long double c[5][5], s, t, width, height;
};

/* Computes the control points of r - xS, then the coefficients of its squared length. */
static void first_box(const struct face *f, const double xs[3], struct box *box)
{
    static const int binomial[3] = {1, 2, 1}, of_four[5] = {1, 4, 6, 4, 1};
    wide g[3][3][3], p[3][3][3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            wide z[2];
            on_square(f, 0.5L * i, 0.5L * j, z);
            face_jet(f, z, g[i][j], NULL, NULL);
            for (int k = 0; k < 3; k++)
                g[i][j][k] -= xs[k];
        }
    for (int j = 0; j < 3; j++) /* p[1] = 2 g[1] - (g[0] + g[2]) / 2, in s and then in t */
        for (int k = 0; k < 3; k++)
            g[1][j][k] = 2 * g[1][j][k] - (g[0][j][k] + g[2][j][k]) / 2;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            p[i][0][k] = g[i][0][k];
            p[i][1][k] = 2 * g[i][1][k] - (g[i][0][k] + g[i][2][k]) / 2;
            p[i][2][k] = g[i][2][k];
        }
    wide sum[5][5] = {{0}};
    for (int a = 0; a < 9; a++)
        for (int b = 0; b < 9; b++) {
            const int i = a / 3, j = a % 3, k = b / 3, l = b % 3;
            sum[i + k][j + l] += binomial[i] * binomial[j] * binomial[k] * binomial[l] * dot(p[i][j], p[k][l]);
        }
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++)
            box->c[i][j] = (long double)(sum[i][j] / (of_four[i] * of_four[j]));
    box->s = box->t = 0;
    box->width = box->height = 1;
}

/* Halves a box, which becomes the upper half. */
static void split(struct box *box, struct box *lower)
{
    const int across = box->height > box->width;
    *lower = *box;
    for (int line = 0; line < 5; line++)
        for (int level = 1; level < 5; level++)
            for (int i = 0; i < 5 - level; i++) { /* de Casteljau: the upper half remains */
                long double *const here = across ? &box->c[line][i] : &box->c[i][line], *const next =
                                                                                            across
                                                                                                ? &box->c[line][i + 1]
                                                                                                : &box->c[i + 1][line];
                *here = (*here + *next) / 2;
                if (i == 0)
                    *(across ? &lower->c[line][level] : &lower->c[level][line]) = *here;
            }
    if (across) {
        box->height = lower->height = box->height / 2;
        box->t += box->height;
    } else {
        box->width = lower->width = box->width / 2;
        box->s += box->width;
    }
}

static long double bound_of(const struct box *box)
{
    long double least = box->c[0][0];
    for (int i = 1; i < 25; i++)
        least = box->c[i / 5][i % 5] < least ? box->c[i / 5][i % 5] : least;
    return least;
}

/* A heap of box numbers with the least bound on top. */
struct heap {
    int count, number[BOXES];
    long double bound[BOXES]; /* indexed by box */
};

static void push(struct heap *h, int number, long double bound)
{
    int k = h->count++;
    h->bound[number] = bound;
    for (; k > 0 && h->bound[h->number[(k - 1) / 2]] > bound; k = (k - 1) / 2)
        h->number[k] = h->number[(k - 1) / 2];
    h->number[k] = number;
}

static int pop(struct heap *h)
{
    const int top = h->number[0], last = h->number[--h->count];
    int k = 0;
    for (int child = 1; child < h->count; child = 2 * k + 1) {
        child += child + 1 < h->count && h->bound[h->number[child + 1]] < h->bound[h->number[child]];
        if (h->bound[last] <= h->bound[h->number[child]])
            break;
        h->number[k] = h->number[child];
        k = child;
    }
    h->number[k] = last;
    return top;
}

/* Returns 1 if no box is left that could contain a point nearer than the best by more than the distance `enough`. */
static int subdivide(const struct face *f, const double xs[3], struct best *b, long double enough)
{
    static struct box boxes[BOXES];
    static struct heap heap;
    int used = 1;
    first_box(f, xs, &boxes[0]);
    heap.count = 0;
    push(&heap, 0, bound_of(&boxes[0]));
    while (heap.count > 0) {
        const long double least = sqrtl((long double)b->square);
        const int top = pop(&heap);
        if (heap.bound[top] >= (long double)b->square - enough * (2 * least + enough))
            return 1;
        if (used == BOXES)
            return 0;
        struct box *const box = &boxes[top];
        wide middle[2];
        on_square(f, box->s + box->width / 2, box->t + box->height / 2, middle);
        if (square_at(f, xs, middle) < b->square) {
            improve(b, middle, 0);
            visit(f, xs, middle, improve, b);
        }
        split(box, &boxes[used]);
        push(&heap, top, bound_of(box));
        push(&heap, used, bound_of(&boxes[used]));
        used++;
    }
    return 1;
}

void face_find(const struct face *f, const double xs[3], struct face_nearest *n)
{
    struct best b = {f, xs, {0, 0}, (wide)1e300L, (wide)1e300L};
    for (int i = 0; i < STARTS * STARTS; i++) {
        wide z[2];
        on_square(f, (0.5L + i % STARTS) / STARTS, (0.5L + (long double)(i / STARTS)) / STARTS, z);
        visit(f, xs, z, improve, &b);
    }
    n->certain = subdivide(f, xs, &b, LEFT * f->edge);
    n->z[0] = b.z[0];
    n->z[1] = b.z[1];
    n->distance = sqrt((double)b.square);
    n->on_edge = !(sqrt((double)b.inside) <= n->distance + TIE * f->edge);
}

/* ---- errors ---- */

struct near {
    const struct face *f;
    const double *xs;
    wide r[3];
    double most, off;
};

static double between(const struct face *f, const wide z[2], const wide r[3])
{
    wide at[3], sum = 0;
    face_jet(f, z, at, NULL, NULL);
    for (int k = 0; k < 3; k++)
        sum += (at[k] - r[k]) * (at[k] - r[k]);
    return sqrt((double)sum);
}

static void approach(void *data, const wide z[2], int inside)
{
    struct near *const n = data;
    (void)inside;
    if (face_distance(n->f, n->xs, z) <= n->most)
        n->off = fmin(n->off, between(n->f, z, n->r));
}

double face_off_closest(const struct face *f, const double xs[3], const struct face_nearest *nearest,
                        const double loc[2])
{
    struct near n = {f, xs, {0, 0, 0}, nearest->distance + TIE * f->edge, INFINITY};
    const wide z[2] = {loc[0], loc[1]};
    if (!isfinite(loc[0]) || !isfinite(loc[1]))
        return INFINITY;
    face_jet(f, z, n.r, NULL, NULL);
    approach(&n, nearest->z, 0);
    visit(f, xs, z, approach, &n);
    if (!(n.off <= FLAT * f->edge) && face_holds(f, z, 0)) /* if the distance hardly changes */
        approach(&n, z, 0);
    return n.off;
}

double face_off_foot(const struct face *f, const double xs[3], const double loc[2])
{
    wide z[2] = {loc[0], loc[1]}, r[3];
    if (!isfinite(loc[0]) || !isfinite(loc[1]))
        return INFINITY;
    face_jet(f, z, r, NULL, NULL);
    return newton_free(f, xs, z) ? between(f, z, r) : INFINITY;
}
