/* Changes of the squared distance over a part of a closed patch. */

/* Computes the part that contains the anchor z and the corners h, (s,t) from z: from low to high, 0 to 1 across the
 * patch. */
FOOTPOINT_PART void footpoint_detail_KIND_hull(const footpoint_detail_KIND_anchor *z,
                                               REAL h[CORNERS][2], REAL low[2], REAL high[2])
{
    int i, k;
    for (i = 0; i < 2; i++) {
        REAL least = 0.0, most = 0.0;
        for (k = 0; k < CORNERS; k++) {
            least = footpoint_detail_least(least, h[k][i]);
            most = footpoint_detail_greater(most, h[k][i]);
        }
        low[i] = footpoint_detail_greater(0.5 + 0.5 * (z->at[i] + least), 0.0);
        high[i] = footpoint_detail_least(0.5 + 0.5 * (z->at[i] + most), 1.0);
    }
}

/* Computes the ranges of products of second derivatives there with e. */
FOOTPOINT_PART void footpoint_detail_KIND_ranges(const footpoint_detail_KIND_terms *of,
                                                 footpoint_detail_bends c, const REAL e[3],
                                                 const REAL low[2], const REAL high[2],
                                                 footpoint_detail_range *r)
{
    footpoint_detail_bends_range(c, e, r);
    footpoint_detail_KIND_widen(of, e, low, high, r);
}

/* Computes the matrix M of an anchor z over a part with the corners h, (s,t) from z; grow: slopes from edges into the
 * patch, as far as M includes them.
 *
 * Let phi be half the square of the distance, and (s,t) lead from z to a point of the part; with means R of second
 * derivatives on that way, w = s u + t v + (s^2 R11 + 2 s t R12 + t^2 R22) / 2 is r(s,t) - r(z). For any e, |w|^2 >= 2
 * e.w - |e|^2, here for e = s a + t b, with the vectors a and b of w = s a + t b in the middle of the part. So
 *   2 phi(s,t) - 2 phi(z) = -2 d.w + |w|^2 >= -2 s f - 2 t g + m11 s^2 + 2 m12 s t + m22 t^2,
 * m11 = 2 a.u - a.a - d.R11 + s a.R11 + t a.R12, m12 = a.v + b.u - a.b - d.R12 + (s (a.R12 + b.R11) + t (b.R12 +
 * a.R22)) / 2, m22 = 2 b.v - b.b - d.R22 + s b.R12 + t b.R22. Products with R lie in the ranges of products with the
 * coefficients over the part extended to z: their middles make M, linear in s and t, so that it is a mean of its values
 * at corners; halves are taken from m11 and m22, those of m12 by 2 |s t| <= k s^2 + t^2 / k. At an edge s has one sign,
 * s f = -|s| grow, and |s| >= s^2 / most |s|.
 *
 * Rounding, F = far / 5: u and v are off by 35 u F and <= 2.5 F, second derivatives by 400 u F and <= 3.5 F, a and b by
 * 900 u F and <= 9.5 F; |s|, |t| <= 2. Entries are off by less than 8e4 u F^2; `off` is 1e5 u F^2. */
FOOTPOINT_APART void footpoint_detail_KIND_form_over(const footpoint_detail_KIND_anchor *z,
                                                     REAL h[CORNERS][2], const REAL grow[2],
                                                     footpoint_detail_KIND_form *m)
{
    const footpoint_detail_local *const r = &z->r;
    const REAL s = 0.5 * (h[0][0] + h[2][0]), t = 0.5 * (h[0][1] + h[2][1]);
    REAL low[2], high[2], mean[3][3], a[3], b[3], most_s = 0.0, most_t = 0.0;
    REAL aa, bb, m11, m12, m22, mixed, ratio;
    footpoint_detail_bends c;
    footpoint_detail_range d, e, f; /* of products with d, a and b */
    int i;
    footpoint_detail_KIND_hull(z, h, low, high);
    footpoint_detail_KIND_bends(z->of, c);
    footpoint_detail_bends_part(c, low, high);
    footpoint_detail_bends_mean(c, mean);
    for (i = 0; i < 3; i++) {
        a[i] = r->u[i] + 0.5 * (s * mean[0][i] + t * mean[1][i]);
        b[i] = r->v[i] + 0.5 * (s * mean[1][i] + t * mean[2][i]);
    }
    footpoint_detail_KIND_ranges(z->of, c, r->d, low, high, &d);
    footpoint_detail_KIND_ranges(z->of, c, a, low, high, &e);
    footpoint_detail_KIND_ranges(z->of, c, b, low, high, &f);
    for (i = 0; i < CORNERS; i++) {
        most_s = footpoint_detail_greater(most_s, fabs(h[i][0]));
        most_t = footpoint_detail_greater(most_t, fabs(h[i][1]));
    }
    aa = footpoint_detail_dot(a, a);
    bb = footpoint_detail_dot(b, b);
    mixed = d.half[1] + 0.5 * (most_s * (e.half[1] + f.half[0]) + most_t * (f.half[1] + e.half[2]));
    ratio = sqrt((aa + REAL_MIN) / (bb + REAL_MIN));
    m11 = 2.0 * footpoint_detail_dot(a, r->u) - aa - d.middle[0] +
          2.0 * grow[0] / (most_s + REAL_MIN) -
          (d.half[0] + most_s * e.half[0] + most_t * e.half[1] + mixed * ratio);
    m22 = 2.0 * footpoint_detail_dot(b, r->v) - bb - d.middle[2] +
          2.0 * grow[1] / (most_t + REAL_MIN) -
          (d.half[2] + most_s * f.half[1] + most_t * f.half[2] + mixed / ratio);
    m12 = footpoint_detail_dot(a, r->v) + footpoint_detail_dot(b, r->u) -
          footpoint_detail_dot(a, b) - d.middle[1];
    for (i = 0; i < CORNERS; i++) {
        const REAL p = h[i][0], q = h[i][1];
        REAL det;
        m->m11[i] = m11 + p * e.middle[0] + q * e.middle[1];
        m->m12[i] = m12 + 0.5 * (p * (e.middle[1] + f.middle[0]) + q * (f.middle[1] + e.middle[2]));
        m->m22[i] = m22 + p * f.middle[1] + q * f.middle[2];
        det = m->m11[i] * m->m22[i] - m->m12[i] * m->m12[i];
        m->det = i ? footpoint_detail_least(m->det, det) : det;
        m->low = i ? footpoint_detail_least(m->low, m->m11[i]) : m->m11[i];
        m->wide = i ? footpoint_detail_greater(m->wide, m->m11[i]) : m->m11[i];
        m->high = i ? footpoint_detail_greater(m->high, m->m22[i]) : m->m22[i];
    }
    m->low -= z->off;
    m->wide += z->off;
    m->high += z->off;
    m->det -= 4.0 * z->off * (m->wide + m->high) + REAL_MIN;
}
