/* All stationary points of the distance to a bilinear segment.  Given eta, (7) is linear in xi: with a = c1 + c3 eta
 * and e = d0 - c2 eta it reads xi = p/Q, p = a . e, Q = a . a.  Then (8), times Q^2, is a quintic in eta,
 *     P = (Q c2 + p c3) . (Q e - p a) = 0.
 * It is formed in Bernstein's basis on the segment, where coefficients of one sign mean that there is no root, and
 * halving is exact but for rounding.  Each coefficient comes with a bound on its error, halved alike, so that no root
 * is lost: an interval is dropped only if all coefficients are of one sign beyond their errors, and kept whole where
 * all are within them.  Where a has next to no length, as at a collapsed edge, those bounds say little: so the same is
 * done with xi and eta exchanged, and what either finds counts.  Newton's method polishes each. */
#include "bilinear.h"

enum { DEGREE = 5, HALVINGS = 27, CLUSTERS = 12 };

#define ERROR_UNITS 512.0 /* of coefficients and their halvings, in units of the sum of the sizes of all terms */
#define APART 1e-9        /* points nearer than that in xi and eta are one */
#define OUTSIDE 1.02      /* a candidate beyond does not become a point of the segment by polishing */
#define BLURRED 1e-3      /* points that near are one if rounding hides their places */
#define ROUNDING 1e-11    /* by which a point on the edge may seem to be outside */
#define POLISH 8          /* steps */
#define NEAR 1e-6         /* a root moves by less when polished, unless it is badly conditioned */
#define FARTHEST 0.05

struct quintic {
    double c[DEGREE + 1], error[DEGREE + 1];
};

/* Roots that the isolation cannot tell apart lie in [low, high]; in 0..1. */
struct cluster {
    double low, high;
};

/* The lines of one family, by a parameter from 0 to 1: direction and xS minus the middle, both linear in it. */
struct lines {
    const double *across, *twist; /* c2 or c1, and c3 */
    double along[2][3], e[2][3];
    double size, across_size, twist_size; /* of terms that e, across and twist were formed from */
};

static struct lines lines_of(const struct bilinear *f, int exchanged)
{
    struct lines l;
    const double *const from = exchanged ? f->ad : f->ab, *const to = exchanged ? f->bc : f->dc;
    l.across = exchanged ? f->c1 : f->c2;
    l.twist = f->c3;
    for (int i = 0; i < 3; i++) {
        l.along[0][i] = 0.5 * from[i];
        l.along[1][i] = 0.5 * to[i];
        l.e[0][i] = f->d0[i] + l.across[i];
        l.e[1][i] = f->d0[i] - l.across[i];
    }
    l.size = f->s + 4.0 * f->m;
    l.across_size = exchanged ? f->m1 : f->m2;
    l.twist_size = f->m1 < f->m2 ? f->m1 : f->m2;
    return l;
}

static double length(const double a[3])
{
    return sqrt(vector_dot(a, a));
}

/* Product of a quadratic and a cubic. */
static void add_product(const double u[3], const double v[4], double product[DEGREE + 1])
{
    static const double two[3] = {1, 2, 1}, three[4] = {1, 3, 3, 1}, five[6] = {1, 5, 10, 10, 5, 1};
    for (int i = 0; i <= 2; i++)
        for (int j = 0; j <= 3; j++)
            product[i + j] += two[i] * three[j] / five[i + j] * u[i] * v[j];
}

/* The cubic q l of a quadratic and a linear function. */
static void cubic_of(const double q[3], double l0, double l1, double cubic[4])
{
    cubic[0] = q[0] * l0;
    cubic[1] = (2.0 * q[1] * l0 + q[0] * l1) / 3.0;
    cubic[2] = (q[2] * l0 + 2.0 * q[1] * l1) / 3.0;
    cubic[3] = q[2] * l1;
}

static void quintic_of(const struct lines *l, struct quintic *q)
{
    const double(*const a)[3] = l->along, (*const e)[3] = l->e;
    const double qq[3] = {vector_dot(a[0], a[0]), vector_dot(a[0], a[1]), vector_dot(a[1], a[1])};
    const double p[3] = {vector_dot(a[0], e[0]), 0.5 * (vector_dot(a[0], e[1]) + vector_dot(a[1], e[0])),
                         vector_dot(a[1], e[1])};
    const double s0 = length(a[0]), s1 = length(a[1]), t = 2.0 * l->size;
    const double q_size[3] = {s0 * s0, s0 * s1, s1 * s1}, p_size[3] = {s0 * t, 0.5 * (s0 + s1) * t, s1 * t};
    double u[3], v[4], w[4], x[4];
    for (int k = 0; k <= DEGREE; k++)
        q->c[k] = q->error[k] = 0.0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            u[k] = qq[k] * l->across[i] + p[k] * l->twist[i];
        cubic_of(qq, e[0][i], e[1][i], v);
        cubic_of(p, a[0][i], a[1][i], w);
        for (int k = 0; k < 4; k++)
            x[k] = v[k] - w[k];
        add_product(u, x, q->c);
    }
    for (int k = 0; k < 3; k++)
        u[k] = q_size[k] * l->across_size + p_size[k] * l->twist_size;
    cubic_of(q_size, t, t, v);
    cubic_of(p_size, s0, s1, w);
    for (int k = 0; k < 4; k++)
        x[k] = v[k] + w[k];
    add_product(u, x, q->error);
    for (int k = 0; k <= DEGREE; k++)
        q->error[k] *= ERROR_UNITS * BILINEAR_UNIT;
}

enum verdict { NO_ROOT, ANY_ROOT, ALL_ROOTS };

static enum verdict judge(const struct quintic *q)
{
    int above = 0, below = 0;
    for (int k = 0; k <= DEGREE; k++) {
        above += q->c[k] > q->error[k];
        below += q->c[k] < -q->error[k];
    }
    return above > DEGREE || below > DEGREE ? NO_ROOT : above || below ? ANY_ROOT : ALL_ROOTS;
}

/* By de Casteljau's scheme: the right half stays in c, the left one is returned. */
static void halve(double c[DEGREE + 1], double left[DEGREE + 1])
{
    for (int n = 0; n <= DEGREE; n++) {
        left[n] = c[0];
        for (int k = 0; k < DEGREE - n; k++)
            c[k] = 0.5 * (c[k] + c[k + 1]);
    }
}

/* Neighbours make one cluster, from left to right; too many end in the last. */
static void append(struct cluster *cluster, int *count, double low, double high)
{
    if (*count > 0 && (cluster[*count - 1].high >= low || *count == CLUSTERS)) {
        cluster[*count - 1].high = high;
        return;
    }
    cluster[*count].low = low;
    cluster[(*count)++].high = high;
}

/* All real roots in 0..1.  A quintic has few intervals with a root at each depth, so the stack holds the right halves.
 */
static int isolate(const struct quintic *whole, struct cluster cluster[CLUSTERS])
{
    struct {
        struct quintic q;
        double low, high;
        int depth;
    } stack[HALVINGS + 2];
    int top = 0, count = 0;
    stack[0].q = *whole;
    stack[0].low = 0.0;
    stack[0].high = 1.0;
    stack[0].depth = 0;
    while (top >= 0) {
        const enum verdict verdict = judge(&stack[top].q);
        if (verdict == NO_ROOT) {
            top--;
        } else if (verdict == ALL_ROOTS || stack[top].depth == HALVINGS) {
            append(cluster, &count, stack[top].low, stack[top].high);
            top--;
        } else {
            const double middle = 0.5 * (stack[top].low + stack[top].high);
            stack[top + 1] = stack[top];
            halve(stack[top].q.c, stack[top + 1].q.c);
            halve(stack[top].q.error, stack[top + 1].q.error);
            stack[top].low = middle;
            stack[top + 1].high = middle;
            stack[top + 1].depth = ++stack[top].depth;
            top++;
        }
    }
    return count;
}

/* Newton's method, as long as it stays near; z becomes the point on its way where the equations hold best.  Returns 1
 * if they hold there to rounding. */
static int polish(const struct bilinear *f, double farthest, double z[2])
{
    double x = z[0], y = z[1], least = HUGE_VAL, error = 0.0;
    const double start[2] = {z[0], z[1]};
    for (int n = 0; n < POLISH && fabs(x - start[0]) <= farthest && fabs(y - start[1]) <= farthest; n++) {
        struct bilinear_point p;
        struct bilinear_proof proof;
        const int solved = footpoint_bilinear_prove(f, x, y, &p, &proof);
        const double rest = bilinear_larger(fabs(p.f1), fabs(p.f2));
        if (rest < least) {
            least = rest;
            error = p.error * f->m;
            z[0] = x;
            z[1] = y;
        }
        if (solved < 0 || (n > 1 && rest > 2.0 * least))
            break;
        x += proof.move[0];
        y += proof.move[1];
    }
    return least <= 64.0 * error;
}

/* Appends z to n points unless it is near one of them; returns their number. */
static int keep(double loc[][2], int n, const double z[2], double apart)
{
    for (int k = 0; k < n; k++)
        if (fabs(loc[k][0] - z[0]) <= apart && fabs(loc[k][1] - z[1]) <= apart)
            return n;
    loc[n][0] = z[0];
    loc[n][1] = z[1];
    return n + 1;
}

static void offer(const struct bilinear *f, double xi, double eta, double loc[][2], int *count)
{
    double z[2] = {xi, eta};
    if (!(fabs(xi) <= OUTSIDE && fabs(eta) <= OUTSIDE))
        return;
    if (!polish(f, NEAR, z) && !polish(f, FARTHEST, z))
        return;
    for (int k = 0; k < 2; k++) {
        if (!(fabs(z[k]) <= 1.0 + ROUNDING))
            return;
        z[k] = bilinear_clamp(z[k]);
    }
    if (*count < BILINEAR_STATIONARY)
        *count = keep(loc, *count, z, APART);
}

/* The point on line t of 0..1 that is nearest along it. */
static void offer_line(const struct bilinear *f, const struct lines *l, int exchanged, double t, double loc[][2],
                       int *count)
{
    double a[3], e[3];
    for (int i = 0; i < 3; i++) {
        a[i] = (1.0 - t) * l->along[0][i] + t * l->along[1][i];
        e[i] = (1.0 - t) * l->e[0][i] + t * l->e[1][i];
    }
    const double s = vector_dot(a, e) / vector_dot(a, a);
    offer(f, exchanged ? 2.0 * t - 1.0 : s, exchanged ? s : 2.0 * t - 1.0, loc, count);
}

int footpoint_bilinear_stationary(const struct bilinear *f, double loc[][2])
{
    int count = 0;
    for (int exchanged = 0; exchanged < 2; exchanged++) {
        const struct lines l = lines_of(f, exchanged);
        struct quintic q;
        struct cluster cluster[CLUSTERS];
        quintic_of(&l, &q);
        const int clusters = isolate(&q, cluster);
        for (int k = 0; k < clusters; k++) {
            const double low = cluster[k].low, high = cluster[k].high;
            const int steps = high - low > 0x1p-20 ? 4 : 0;
            for (int n = 0; n <= steps; n++)
                offer_line(f, &l, exchanged, steps ? low + n * (high - low) / steps : 0.5 * (low + high), loc, &count);
        }
    }
    return count;
}

int footpoint_stationary(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                         const double xS[3], double loc[FOOTPOINT_STATIONARY_MOST][2], int *count)
{
    const double *const x[5] = {xA, xB, xC, xD, xS};
    struct bilinear f;
    double found[BILINEAR_STATIONARY][2], sharp[BILINEAR_STATIONARY][2];
    const int status = footpoint_bilinear_of(xA, xB, xC, xD, xS, &f);
    if (status != FOOTPOINT_OK)
        return status;
    if (!footpoint_bilinear_has_area(&f))
        return FOOTPOINT_ERR_DEGENERATE;
    const int all = footpoint_bilinear_stationary(&f, found);
    int refined = 0, blurred = 0;
    for (int k = 0; k < all; k++) {
        double z[2] = {found[k][0], found[k][1]}, radius;
        if (footpoint_bilinear_refine(x, &f, z, &radius))
            refined = keep(sharp, refined, z, APART);
        else
            blurred = keep(found, blurred, z, BLURRED);
    }
    int kept = refined;
    for (int k = 0; k < blurred; k++)
        kept = keep(sharp, kept, found[k], BLURRED);
    *count = kept < FOOTPOINT_STATIONARY_MOST ? kept : FOOTPOINT_STATIONARY_MOST;
    for (int k = 0; k < *count; k++) {
        loc[k][0] = bilinear_clamp(sharp[k][0]);
        loc[k][1] = bilinear_clamp(sharp[k][1]);
    }
    return kept > refined || kept > FOOTPOINT_STATIONARY_MOST ? FOOTPOINT_NOT_UNIQUE : FOOTPOINT_OK;
}
