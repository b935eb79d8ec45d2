/* Changes of the squared distance over a part of a closed curved face. */

/* The matrix M of an anchor z over a part with the corners h, (s,t) from z; grow: slopes from edges into the face, as far as M has
 * them.
 *
 * Let phi be half the square of the distance, and (s,t) lead from z to a point of the part; w = s A + t B + s^2 t^2 k / 4 is then
 * r(s,t) - r(z), A = u + (s uu + t uv + s t uuv) / 2, B = v + (s uv + t vv + s t uvv) / 2.  For any vector e, |w|^2 >= 2 e.w -
 * |e|^2, here for e = s a + t b, a and b being A and B in the middle of the part.  So
 *   2 phi(s,t) - 2 phi(z) = -2 d.w + |w|^2 >= -2 s f - 2 t g + m11 s^2 + 2 m12 s t + m22 t^2,
 * m11 = 2 a.A - a.a - d.uu - t d.uuv, m12 = a.B + b.A - a.b - d.uv - s t d.k / 4, m22 = 2 b.B - b.b - d.vv - s d.uvv, and what 2
 * e.k s^2 t^2 / 4 has.  There t^2 is replaced by a line that differs by half the square of half its range at most; likewise s^2.  M is
 * linear in s and in t, so that it is a mean of its values at corners.  At an edge s has one sign, s f = -|s| grow, and |s| >= s^2 /
 * most |s|.
 *
 * By rounding entries are off by z->off; see footpoint_detail_KIND_slopes. */
FOOTPOINT_PART void footpoint_detail_KIND_form_over(const footpoint_detail_KIND_anchor *z,
                                                    REAL h[CORNERS][2], const REAL grow[2],
                                                    footpoint_detail_KIND_form *m)
{
    const footpoint_detail_local *const r = &z->r;
    const REAL off = z->off;
    REAL a[3], b[3], x[6] = {0}, y[6] = {0}, s, t, st, aa, ab, bb, most_s = 0.0, most_t = 0.0;
    REAL duuv = 0.0, duvv = 0.0, dk = 0.0, ak = 0.0, bk = 0.0, half_s = 0.0, half_t = 0.0, mixed,
         across = 0.0;
    int i;
    s = CORNERS == 4 ? 0.5 * (h[0][0] + h[2][0]) : (h[0][0] + h[1][0] + h[CORNERS - 1][0]) / 3.0;
    t = CORNERS == 4 ? 0.5 * (h[0][1] + h[2][1]) : (h[0][1] + h[1][1] + h[CORNERS - 1][1]) / 3.0;
    st = 0.5 * s * t;
    FOOTPOINT_UNROLL
    for (i = 0; i < 3; i++) {
        a[i] = r->u[i] + 0.5 * (s * r->uu[i] + t * r->uv[i]);
        b[i] = r->v[i] + 0.5 * (s * r->uv[i] + t * r->vv[i]);
        if (CORNERS == 4) {
            a[i] += st * z->uuv[i];
            b[i] += st * z->uvv[i];
        }
    }
    aa = footpoint_detail_dot(a, a);
    ab = footpoint_detail_dot(a, b);
    bb = footpoint_detail_dot(b, b);
    x[0] = 2.0 * footpoint_detail_dot(a, r->u) - aa - z->a;
    x[1] = footpoint_detail_dot(a, r->uu);
    x[2] = footpoint_detail_dot(a, r->uv);
    y[0] = 2.0 * footpoint_detail_dot(b, r->v) - bb - z->c;
    y[1] = footpoint_detail_dot(b, r->uv);
    y[2] = footpoint_detail_dot(b, r->vv);
    mixed = footpoint_detail_dot(a, r->v) + footpoint_detail_dot(b, r->u) - ab - z->b;
    x[4] = 0.5 * (x[2] + footpoint_detail_dot(b, r->uu));
    y[4] = 0.5 * (y[1] + footpoint_detail_dot(a, r->vv));
    if (CORNERS == 4) {
        duuv = footpoint_detail_dot(r->d, z->uuv);
        duvv = footpoint_detail_dot(r->d, z->uvv);
        x[3] = footpoint_detail_dot(a, z->uuv);
        y[3] = footpoint_detail_dot(b, z->uvv);
        across = 0.5 * (footpoint_detail_dot(a, z->uvv) + footpoint_detail_dot(b, z->uuv));
    }
    if (NODES == 9) {
        dk = footpoint_detail_dot(r->d, z->k);
        ak = 0.5 * footpoint_detail_dot(a, z->k);
        bk = 0.5 * footpoint_detail_dot(b, z->k);
        half_s = 0.5 * (h[2 % CORNERS][0] - h[0][0]) * (h[2 % CORNERS][0] - h[0][0]) * 0.25;
        half_t = 0.5 * (h[2 % CORNERS][1] - h[0][1]) * (h[2 % CORNERS][1] - h[0][1]) * 0.25;
    }
    FOOTPOINT_UNROLL
    for (i = 0; i < CORNERS; i++) {
        most_s = footpoint_detail_greater(most_s, fabs(h[i][0]));
        most_t = footpoint_detail_greater(most_t, fabs(h[i][1]));
    }
    x[0] += 2.0 * grow[0] / (most_s + REAL_MIN);
    y[0] += 2.0 * grow[1] / (most_t + REAL_MIN);
    if (NODES == 9) {
        x[0] -= fabs(ak) * most_s * half_t;
        y[0] -= fabs(bk) * most_t * half_s;
    }
    FOOTPOINT_UNROLL
    for (i = 0; i < CORNERS; i++) {
        const REAL p = h[i][0], q = h[i][1], pq = p * q;
        REAL m11 = x[0] + p * x[1] + q * (x[2] - duuv) + pq * x[3];
        REAL m12 = mixed + p * x[4] + q * y[4] + pq * (across - 0.25 * dk);
        REAL m22 = y[0] + p * (y[1] - duvv) + q * y[2] + pq * y[3], det;
        if (NODES == 9) {
            m11 += ak * p * (2.0 * t * q - t * t + half_t);
            m22 += bk * q * (2.0 * s * p - s * s + half_s);
        }
        m->m11[i] = m11;
        m->m12[i] = m12;
        m->m22[i] = m22;
        det = m11 * m22 - m12 * m12;
        m->det = i ? footpoint_detail_least(m->det, det) : det;
        m->low = i ? footpoint_detail_least(m->low, m11) : m11;
        m->wide = i ? footpoint_detail_greater(m->wide, m11) : m11;
        m->high = i ? footpoint_detail_greater(m->high, m22) : m22;
    }
    m->low -= off;
    m->wide += off;
    m->high += off;
    m->det -= 4.0 * off * (m->wide + m->high) + REAL_MIN;
}
