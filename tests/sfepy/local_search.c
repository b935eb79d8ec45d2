/* runtime/replace/sfepy.c with the searches of four-node segments counted and repeated REPEAT times: by our header, or,
 * if TOLERANCE is defined, by our equivalent of sfepy's own search, Gauss-Newton from the middle of the segment until a
 * step is shorter than TOLERANCE. */
#include "../../generated/footpoint_quad4.h"
#include "../../runtime/geometry/footpoint-quad4-geometry.h"

extern long searches;
long searches;

#ifdef TOLERANCE
static double scalar(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static int search_quad4(const double a[3], const double b[3], const double c[3], const double d[3], const double at[3],
                        double loc[2], double *gap)
{
    double r = 0, s = 0, dr, ds, position[3], by_r[3], by_s[3], to[3];
    int left = 1000;
    do {
        footpoint_quad4_position(a, b, c, d, r, s, position);
        footpoint_quad4_derivatives(a, b, c, d, r, s, by_r, by_s);
        for (int k = 0; k < 3; k++)
            to[k] = at[k] - position[k];
        const double rr = scalar(by_r, by_r), rs = scalar(by_r, by_s), ss = scalar(by_s, by_s);
        const double f = scalar(by_r, to), g = scalar(by_s, to), determinant = rr * ss - rs * rs;
        dr = (ss * f - rs * g) / determinant;
        ds = (rr * g - rs * f) / determinant;
        r += dr;
        s += ds;
    } while (sqrt(dr * dr + ds * ds) > TOLERANCE && --left > 0);
    loc[0] = r;
    loc[1] = s;
    *gap = sqrt(scalar(to, to)); /* before the last step, as in sfepy */
    return left ? 0 : -1;
}
#else
#define search_quad4 footpoint_quad4_accurate
#endif

static int repeated(const double a[3], const double b[3], const double c[3], const double d[3], const double at[3],
                    double loc[2], double *gap)
{
    int status = 0;
    searches++;
    for (volatile int i = 0; i < REPEAT; i++)
        status = search_quad4(a, b, c, d, at, loc, gap);
    return status;
}

#define footpoint_quad4_accurate repeated
#include "../../runtime/replace/sfepy.c"
