/* Slopes of the squared distance on a curved face, and rounding errors, in double. */

/* Slopes.  Rounding, u = 1.12e-16, as in footpoint_detail_KIND_step: tangents are off by 10 u growth size, d by 20 u spread size + 7 u
 * |d|.  (xi,eta) of a triangle, less the middle's, is off by u itself, which makes 3.6 u growth size of tangents, and turned ones are
 * off by twice as much; and u (|r_xi| + |r_eta|) of d.  Entries of M are off by 4000 u far^2, tangents being off by 14 u G, second
 * derivatives by 18 u G, and |s|, |t| <= 2; coordinates of d by 26 u far, dd by 60 u far^2.  Third derivatives of half the square of
 * the distance, by both coordinates twice, are less than 40 far^2, and second derivatives 8 far^2. */
FOOTPOINT_PART void footpoint_detail_KIND_slopes(const footpoint_detail_KIND_terms *of, REAL p,
                                                 REAL q, footpoint_detail_KIND_anchor *z)
{
    const REAL unit = 1.12e-16, x = fabs(p), y = fabs(q);
    const REAL d = footpoint_detail_sum(z->r.d),
               grown = footpoint_detail_KIND_growth(x, y) * of->size;
    const REAL u = sqrt(footpoint_detail_dot(z->r.u, z->r.u));
    const REAL v = sqrt(footpoint_detail_dot(z->r.v, z->r.v));
    const REAL place = 20.0 * footpoint_detail_KIND_spread(x, y) * of->size + 15.0 * d +
                       (CORNERS == 3 ? 2.0 * (u + v) : 0.0);
    const REAL turn = (CORNERS == 3 ? 28.0 : 10.0) * grown * d;
    REAL square;
    z->f = footpoint_detail_dot(z->r.u, z->r.d);
    z->g = footpoint_detail_dot(z->r.v, z->r.d);
    z->off_f = unit * (place * u + turn);
    z->off_g = unit * (place * v + turn);
    z->far = d + (CORNERS == 3 ? 2.0 * footpoint_detail_KIND_growth(0.5, 0.5)
                               : footpoint_detail_KIND_growth(1.0, 1.0)) *
                     of->size;
    square = z->far * z->far;
    z->off = 4000.0 * unit * square;
    z->off_d = 26.0 * unit * z->far;
    z->off_dd = 200.0 * unit * square;
    z->bent = 40.0 * square;
    z->stiff = 20.0 * square;
}
