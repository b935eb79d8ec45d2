/* Bicubic patches whose edges start at right angles to the normals at their ends, as polynomials about the middle: once for
 * single calls, whose coordinates lie side by side (patch_three.h), once for lanes. */

/* r = r0 + p e + q f + x(p) + b(q) (p m + X(p)) + y(q) + b(p) Y(q), p = xi, q = eta, b(p) = (3 p - p^3) / 4, where x is
 * (1 - p^2) (p x1 - x0), and X, y and Y likewise: x bends the mean of the edges AB and DC, X is the excess bend of DC
 * over AB. d = xS - r0.
 *
 * third: bounds of |r_ppp| + 2 |r_ppq| + |r_pqq|, and with p and q exchanged, within 1/8 of the patch. base: the sum of
 * the edges' absolute coordinates; tilt: the largest square of a normal. Rounding, in units of u = 1.11e-16, if tilt <=
 * 1.01: coordinates of d are off by place + 9 |D|, of tangents by turn, of second derivatives by 280 far, and r_p, r_q
 * <= 2.5 far, r_pp, r_pq, r_qq <= 3.5 far.
 *
 * Derivation: P = |AB| + |DC|, Q = |AD| + |BC|, base = P + Q. begin and end are at most 0.127 of an edge, off by 0.64 u
 * of it, so x1 and x0 are 0.127 P, off by 0.9 u P; X1, X0, Y0 twice that; Y1 0.51 Q, off by 2.3 u Q + 0.5 u P. |p| <=
 * 1: |a| <= 0.385, |a1| <= 2, |b| <= 0.5, |b1| <= 0.75, off by 1.4, 8, 1.5, 1.5 u. In total, including sums: tangents
 * 20.5 u Q + 8 u P, d without xS 11 u base, second derivatives 29 u P + 9 u Q; xS minus corners 3 u (|D| + 1.1 base),
 * four subtractions 4 u |D| + 2 u base. */
typedef struct {
    REAL e[ROOM], f[ROOM], m[ROOM], d[ROOM], x0[ROOM], x1[ROOM], X0[ROOM], X1[ROOM];
    REAL y0[ROOM], y1[ROOM], Y0[ROOM], Y1[ROOM];
    REAL third[2], base, tilt, place, turn, far;
} footpoint_detail_NET;

/* An edge, and an eighth of its parts along the normals m and n at its ends. */
typedef struct {
    REAL edge[ROOM], begin[ROOM], end[ROOM];
} footpoint_detail_NET_bent;

FOOTPOINT_PART void footpoint_detail_NET_bend(const REAL m[ROOM], const REAL n[ROOM],
                                              footpoint_detail_NET_bent *t)
{
    const REAL first = 0.125 * footpoint_detail_dot(t->edge, m);
    const REAL second = 0.125 * footpoint_detail_dot(t->edge, n);
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < THREE; i++) {
        INTO(t->begin)[i] = first * OF(m)[i];
        INTO(t->end)[i] = second * OF(n)[i];
    }
}

/* Returns the greater of two numbers up to rounding. It has no branch, which would be mispredicted half of the time. */
FOOTPOINT_PART REAL footpoint_detail_NET_most(REAL a, REAL b)
{
    return 0.5 * ((a + b) + fabs(a - b));
}

/* Bends the edges AB, DC, AD and BC by the normals n, and computes `tilt`. */
FOOTPOINT_PART void footpoint_detail_NET_bend_all(const REAL *const *n,
                                                  footpoint_detail_NET_bent bent[4],
                                                  footpoint_detail_NET *t)
{
    footpoint_detail_NET_bend(n[0], n[1], &bent[0]);
    footpoint_detail_NET_bend(n[3], n[2], &bent[1]);
    footpoint_detail_NET_bend(n[0], n[3], &bent[2]);
    footpoint_detail_NET_bend(n[1], n[2], &bent[3]);
    t->tilt =
        footpoint_detail_NET_most(footpoint_detail_NET_most(footpoint_detail_dot(n[0], n[0]),
                                                            footpoint_detail_dot(n[1], n[1])),
                                  footpoint_detail_NET_most(footpoint_detail_dot(n[2], n[2]),
                                                            footpoint_detail_dot(n[3], n[3])));
}

/* Computes the net from bent edges, all but `tilt`. */
FOOTPOINT_PART void footpoint_detail_NET_expand(const footpoint_detail_NET_bent bent[4],
                                                footpoint_detail_NET *t)
{
    const footpoint_detail_NET_bent *const ab = &bent[0], *const dc = &bent[1],
                                           *const ad = &bent[2], *const bc = &bent[3];
    const REAL *const bent_by[7] = {t->x1, t->y1, t->X1, t->Y1, t->X0, t->Y0, t->m};
    REAL edges[ROOM];
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < THREE; i++) {
        const TRIPLE s = OF(ab->begin)[i] + OF(ab->end)[i], l = OF(ab->begin)[i] - OF(ab->end)[i];
        const TRIPLE S = OF(dc->begin)[i] + OF(dc->end)[i], L = OF(dc->begin)[i] - OF(dc->end)[i];
        const TRIPLE o = OF(ad->begin)[i] + OF(ad->end)[i], k = OF(ad->begin)[i] - OF(ad->end)[i];
        const TRIPLE O = OF(bc->begin)[i] + OF(bc->end)[i], K = OF(bc->begin)[i] - OF(bc->end)[i];
        INTO(t->e)[i] = 0.25 * (OF(ab->edge)[i] + OF(dc->edge)[i]);
        INTO(t->f)[i] = 0.25 * (OF(ad->edge)[i] + OF(bc->edge)[i]);
        INTO(t->m)[i] = 0.5 * (OF(dc->edge)[i] - OF(ab->edge)[i]);
        INTO(t->x1)[i] = 0.5 * (s + S);
        INTO(t->x0)[i] = 0.5 * (l + L);
        INTO(t->X1)[i] = S - s;
        INTO(t->X0)[i] = L - l;
        INTO(t->y1)[i] = 0.5 * (o + O);
        INTO(t->y0)[i] = 0.5 * (k + K);
        INTO(t->Y1)[i] = (O - o) - 0.5 * OF(t->m)[i];
        INTO(t->Y0)[i] = K - k;
        INTO(edges)
        [i] = (ABSOLUTE(OF(ab->edge)[i]) + ABSOLUTE(OF(dc->edge)[i])) +
              (ABSOLUTE(OF(ad->edge)[i]) + ABSOLUTE(OF(bc->edge)[i]));
    }
    t->base = edges[0] + edges[1] + edges[2];
    footpoint_detail_NET_sizes(bent_by, t->third);
    t->place = 29.0 * t->base;
    t->turn = 35.0 * t->base;
    t->far = t->base;
}

/* Computes tangents and second derivatives at (p,q), and d = xS - r. */
FOOTPOINT_PART void footpoint_detail_NET_local(const footpoint_detail_NET *t, REAL p, REAL q,
                                               footpoint_detail_local *l)
{
    const REAL w = 1.0 - p * p, a = p * w, a1 = 1.0 - 3.0 * (p * p), p2 = p + p, p6 = 6.0 * p;
    const REAL z = 1.0 - q * q, c = q * z, c1 = 1.0 - 3.0 * (q * q), q2 = q + q, q6 = 6.0 * q;
    const REAL b = p * (0.5 + 0.25 * w), b1 = 0.75 * w, b2 = -1.5 * p;
    const REAL g = q * (0.5 + 0.25 * z), g1 = 0.75 * z, g2 = -1.5 * q;
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < THREE; i++) {
        const TRIPLE X = p * OF(t->m)[i] + a * OF(t->X1)[i] - w * OF(t->X0)[i];
        const TRIPLE X1 = OF(t->m)[i] + a1 * OF(t->X1)[i] + p2 * OF(t->X0)[i];
        const TRIPLE X2 = 2.0 * OF(t->X0)[i] - p6 * OF(t->X1)[i];
        const TRIPLE Y = c * OF(t->Y1)[i] - z * OF(t->Y0)[i],
                     Y1 = c1 * OF(t->Y1)[i] + q2 * OF(t->Y0)[i];
        const TRIPLE Y2 = 2.0 * OF(t->Y0)[i] - q6 * OF(t->Y1)[i];
        INTO(l->d)
        [i] = OF(t->d)[i] - p * OF(t->e)[i] - q * OF(t->f)[i] -
              (a * OF(t->x1)[i] - w * OF(t->x0)[i] + g * X) -
              (c * OF(t->y1)[i] - z * OF(t->y0)[i] + b * Y);
        INTO(l->u)[i] = OF(t->e)[i] + (a1 * OF(t->x1)[i] + p2 * OF(t->x0)[i]) + g * X1 + b1 * Y;
        INTO(l->v)[i] = OF(t->f)[i] + (c1 * OF(t->y1)[i] + q2 * OF(t->y0)[i]) + b * Y1 + g1 * X;
        INTO(l->uu)[i] = 2.0 * OF(t->x0)[i] - p6 * OF(t->x1)[i] + g * X2 + b2 * Y;
        INTO(l->uv)[i] = g1 * X1 + b1 * Y1;
        INTO(l->vv)[i] = 2.0 * OF(t->y0)[i] - q6 * OF(t->y1)[i] + b * Y2 + g2 * X;
    }
}

/* Updates d, u and v after a step (s,t), to its second order. */
FOOTPOINT_PART void footpoint_detail_NET_follow(REAL s, REAL t, footpoint_detail_local *r)
{
    int i;
    FOOTPOINT_UNROLL
    for (i = 0; i < THREE; i++) {
        const TRIPLE u = s * OF(r->uu)[i] + t * OF(r->uv)[i],
                     v = s * OF(r->uv)[i] + t * OF(r->vv)[i];
        INTO(r->d)[i] -= s * (OF(r->u)[i] + 0.5 * u) + t * (OF(r->v)[i] + 0.5 * v);
        INTO(r->u)[i] += u;
        INTO(r->v)[i] += v;
    }
}
