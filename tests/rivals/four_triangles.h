/* The closest point of a four-node face in contact codes without a bilinear search: of four triangles about the
 * centroid, each by the regions of its corners, edges and inside (Ericson, Real-Time Collision Detection, 5.1.5). On a
 * warped face these triangles do not lie on the bilinear surface. */
#ifndef FOOTPOINT_FOUR_TRIANGLES_H
#define FOOTPOINT_FOUR_TRIANGLES_H

static inline double rival_triangle_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Computes the weights of b and c in the point of the triangle a, b, c nearest to s. */
static inline void rival_closest_of_triangle(const double a[3], const double b[3], const double c[3], const double s[3],
                                             double *v, double *w)
{
    double ab[3], ac[3], as[3], bs[3], cs[3];
    for (int k = 0; k < 3; k++) {
        ab[k] = b[k] - a[k];
        ac[k] = c[k] - a[k];
        as[k] = s[k] - a[k];
        bs[k] = s[k] - b[k];
        cs[k] = s[k] - c[k];
    }
    const double d1 = rival_triangle_dot(ab, as), d2 = rival_triangle_dot(ac, as), d3 = rival_triangle_dot(ab, bs),
                 d4 = rival_triangle_dot(ac, bs), d5 = rival_triangle_dot(ab, cs), d6 = rival_triangle_dot(ac, cs);
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    *v = *w = 0;
    if (d1 <= 0 && d2 <= 0)
        return;
    if (d3 >= 0 && d4 <= d3)
        *v = 1;
    else if (vc <= 0 && d1 >= 0 && d3 <= 0)
        *v = d1 / (d1 - d3);
    else if (d6 >= 0 && d5 <= d6)
        *w = 1;
    else if (vb <= 0 && d2 >= 0 && d6 <= 0)
        *w = d2 / (d2 - d6);
    else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        *w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        *v = 1 - *w;
    } else {
        *v = vb / (va + vb + vc);
        *w = vc / (va + vb + vc);
    }
}

/** Computes the point r of the four triangles nearest to s and loc = {xi, eta}, linear on each triangle. Returns the
 *  square of its distance. */
static inline double rival_four_triangles(const double *const corner[4], const double s[3], double loc[2], double r[3])
{
    static const double at[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    double centre[3], least = 1e300;
    for (int k = 0; k < 3; k++)
        centre[k] = 0.25 * ((corner[0][k] + corner[1][k]) + (corner[2][k] + corner[3][k]));
    for (int i = 0; i < 4; i++) {
        const double *const a = corner[i], *const b = corner[(i + 1) % 4];
        double v, w, p[3], d = 0;
        rival_closest_of_triangle(centre, a, b, s, &v, &w);
        for (int k = 0; k < 3; k++) {
            p[k] = centre[k] + v * (a[k] - centre[k]) + w * (b[k] - centre[k]);
            d += (s[k] - p[k]) * (s[k] - p[k]);
        }
        if (d < least) {
            least = d;
            for (int k = 0; k < 3; k++)
                r[k] = p[k];
            for (int k = 0; k < 2; k++)
                loc[k] = v * at[i][k] + w * at[(i + 1) % 4][k];
        }
    }
    return least;
}

#endif
