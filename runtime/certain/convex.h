/* Proves that the distance to a bilinear segment is convex over all of it, so that a foot point on it is the closest point; only for
 * files of the library.  The test needs no answer of a search, so processors can run both at once.
 *
 * Let a, b, c and d be four times c1, c2, c3 and xS - c0 of r = c0 + xi c1 + eta c2 + xi eta c3, and R >= 1.  If |xi| and |eta| are
 * at most R, half the square of the distance, times 16, has second derivatives of at least a.a - 2 R |a.c| and b.b - 2 R |b.c|,
 * and the mixed derivative is at most |a.b - c.d| + 2 R (|a.c| + |b.c| + R c.c).
 *
 * Rounding: let u be the unit, Q = a.a + b.b + c.c, S the sum of the coordinates of a, b and c, at most 3 sqrt(Q), and F the sum of
 * the coordinates of xS - xA, at most 64 S.  Coordinates of a, b, c are off by 3 u S, so that c.(xS - xA) is off by 10 u S F and
 * c.d by 23000 u Q.  1e-11 Q covers all second derivatives for R <= 8, and 1e-10 Q^2 their products if the determinant is > 0. */
#ifndef FOOTPOINT_CONVEX_H
#define FOOTPOINT_CONVEX_H

#include "../geometry/vector.h"

#define CONVEX_FARTHEST 64.0
#define CONVEX_BEYOND 8.0
#define CONVEX_MARGIN 1e-10

struct convex {
    double a[3], b[3], c[3], f[3]; /* f = xS - xA */
    double size, away;             /* the sums of the absolute coordinates of a, b, c; of f */
};

static inline void convex_of(const double *const x[5], struct convex *v)
{
    v->size = v->away = 0.0;
    for (int i = 0; i < 3; i++) {
        const double ab = x[1][i] - x[0][i], dc = x[2][i] - x[3][i];
        v->a[i] = ab + dc;
        v->b[i] = (x[3][i] - x[0][i]) + (x[2][i] - x[1][i]);
        v->c[i] = dc - ab;
        v->f[i] = x[4][i] - x[0][i];
        v->size += fabs(v->a[i]) + fabs(v->b[i]) + fabs(v->c[i]);
        v->away += fabs(v->f[i]);
    }
}

/* Returns 1 if the distance to an ordinary segment is convex for |xi|, |eta| <= reach; 0 proves nothing. */
static inline int convex_holds(const struct convex *v, double reach)
{
    const double aa = vector_dot(v->a, v->a), bb = vector_dot(v->b, v->b), cc = vector_dot(v->c, v->c);
    const double ab = vector_dot(v->a, v->b), ac = vector_dot(v->a, v->c), bc = vector_dot(v->b, v->c);
    const double cd = 4.0 * vector_dot(v->c, v->f) - ac - bc + cc, sum = aa + bb + cc;
    const double first = aa - 2.0 * reach * fabs(ac), second = bb - 2.0 * reach * fabs(bc);
    const double mixed = fabs(ab - cd) + 2.0 * reach * (fabs(ac) + fabs(bc) + reach * cc);
    return first > 0.0 && first * second - mixed * mixed > CONVEX_MARGIN * sum * sum && reach <= CONVEX_BEYOND &&
           v->away <= CONVEX_FARTHEST * v->size;
}

#endif
