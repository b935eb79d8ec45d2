/* Whether an answer in float is as good as it should be; see header_float.h. */

#ifndef FOOTPOINT_ERR_DOMAIN
#define FOOTPOINT_ERR_DOMAIN (-3)
#endif

/* 1 if a foot point is within `most` of (xi,eta), in xi and in eta, than which no point of the segment is nearer;
 * 0 if that is not sure.  In s and t, from 0 to 1: a = r_s, b = r_t, c = r_st, d = xS - r.  Rounding errors count
 * as `unit` of the lengths in a product, 5 roundings, about twice what random and hard searches showed: no proof. */
FOOTPOINT_FN int footpoint_detail_vouch(const REAL xA[3], const REAL xB[3], const REAL xC[3],
                                        const REAL xD[3], const REAL xS[3], REAL xi, REAL eta,
                                        REAL most)
{
    const REAL *const corner[4] = {xA, xB, xC, xD};
    const REAL unit = 3e-7, scale = footpoint_detail_relative(corner, 4);
    const REAL s = 0.5 * (1.0 + xi), t = 0.5 * (1.0 + eta);
    REAL aa = 0.0, ab = 0.0, bb = 0.0, ad = 0.0, bd = 0.0, dd = 0.0, ac = 0.0, bc = 0.0, cc = 0.0;
    REAL cd = 0.0, reach, la, lb, lc, ld, far, mixed, h12, det, high, both, step_s, step_t, step, r,
         room, shift;
    REAL least, less, qs, qt;
    int i, near, nearest;
    for (i = 0; i < 3; i++) {
        const REAL e = (xB[i] - xA[i]) * scale, g = (xC[i] - xD[i]) * scale;
        const REAL f = (xD[i] - xA[i]) * scale, h = (xC[i] - xB[i]) * scale;
        const REAL a = e + t * (g - e), b = f + s * (h - f), c = g - e;
        const REAL d = (xS[i] - xA[i]) * scale - s * e - t * b;
        aa += a * a;
        ab += a * b;
        bb += b * b;
        ad += a * d;
        bd += b * d;
        dd += d * d;
        ac += a * c;
        bc += b * c;
        cc += c * c;
        cd += c * d;
    }
    reach = fabs(s) > fabs(t) ? fabs(s) : fabs(t);
    reach = reach > 1.0 ? reach : 1.0;
    lc = sqrt(cc);
    la = sqrt(aa) + reach * lc;
    lb = sqrt(bb) + reach * lc;
    ld = sqrt(dd);
    far = ld + reach * (la + lb);
    lc += unit * la;
    mixed = la * (lb + ld) + lc * far;
    h12 = ab - cd;
    det = aa * bb - h12 * h12 - 4.0 * unit * mixed * mixed;
    high = (aa > bb ? aa : bb) + fabs(h12);
    both = fabs(ac) + fabs(bc) + unit * la * (la + lb);
    step_s = fabs(bb * ad - h12 * bd) + unit * (lb * far * mixed + bb * fabs(ad) + fabs(h12 * bd));
    step_t = fabs(aa * bd - h12 * ad) + unit * (la * far * mixed + aa * fabs(bd) + fabs(h12 * ad));
    step = step_s > step_t ? step_s : step_t;
    r = 2.0 * step / det;
    r = r < 0.5 * most ? r : 0.5 * most;
    room = r * (det - 4.0 * r * (both + lc * lc * r) * high);
    near = (det > 0.0) & !(footpoint_detail_outside(det) >> REAL_TOP) & (step_s <= room) &
           (step_t <= room);
    shift = fabs(ac) * bb + fabs(bc) * aa + 2.0 * fabs(h12) * (both + cc) + 4.0 * both * both +
            cc * (aa + bb);
    least = det - 4.0 * (r * shift + unit * mixed * mixed) * reach;
    qt = 2.0 * (bb * ac - h12 * bc);
    qs = 2.0 * (aa * bc - h12 * ac);
    less = det - 4.0 * (r * shift + unit * la * la * mixed) * reach;
    nearest = ((least - qt * t > 0.0) & (least + qt * (1.0 - t) > 0.0)) |
              ((less - qs * s > 0.0) & (less + qs * (1.0 - s) > 0.0));
    return near & nearest;
}

/* What NAME found, unless that is not sure. */
FOOTPOINT_PART int footpoint_detail_sure(const REAL xA[3], const REAL xB[3], const REAL xC[3],
                                         const REAL xD[3], const REAL xS[3], int status,
                                         const REAL found[2], REAL found_gap, REAL most,
                                         REAL loc[2], REAL *gap)
{
    if (status != FOOTPOINT_OK)
        return status;
    if (!footpoint_detail_vouch(xA, xB, xC, xD, xS, found[0], found[1], most))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = found[0];
    loc[1] = found[1];
    *gap = found_gap;
    return FOOTPOINT_OK;
}
