/* The inputs that segments vary; see variation.h. The most varied sample decides the kind, each sample by its own
 * tolerance: a segment of size 1 at 1000 from the origin has corners that are rounded by 1e-13. */
#include "variation.h"

#include "../common/vec3.h"
#include "../surface/foot_bilinear.h"

#include <float.h>
#include <gsl/gsl_math.h>
#include <math.h>

static const double nothing = 1e-12;            /* of the size: smaller variations count as 0 */
static const double rounding = 8 * DBL_EPSILON; /* of the largest coordinate */

const char *const variation_name[] = {[VARY_RECTANGLES] = "rectangles",
                                      [VARY_PARALLELOGRAMS] = "parallelograms",
                                      [VARY_PLANE] = "plane",
                                      [VARY_WARPED] = "warped"};

/* Returns the angle between the normals at the opposite corners (1,eta) and (-1,-eta). */
static double turn(double c[3][3], double eta)
{
    double n[2][3], both[3];
    for (int i = 0; i < 2; i++) {
        const double at = i ? -1 : 1;
        double t1[3], t2[3];
        for (int k = 0; k < 3; k++) {
            t1[k] = c[0][k] + at * eta * c[2][k];
            t2[k] = c[1][k] + at * c[2][k];
        }
        vector_cross(t1, t2, n[i]);
    }
    vector_cross(n[0], n[1], both);
    return atan2(vector_length(both), vector_dot(n[0], n[1]));
}

static struct variation measure(const struct sample *s)
{
    const double(*x)[3] = (const double(*)[3])s->x;
    double c[3][3], n[3], a[3], b[3];
    double largest = 0;
    for (int i = 0; i < 12; i++)
        largest = fmax(largest, fabs(x[i / 3][i % 3]));
    bilinear_vectors(x, c);
    vector_cross(c[0], c[1], n);
    vector_cross(c[2], c[1], a);
    vector_cross(c[0], c[2], b);
    const double nn = vector_dot(n, n), size = sqrt(fmin(vector_dot(c[0], c[0]), vector_dot(c[1], c[1])));
    if (!(nn > 0))
        return (struct variation){VARY_WARPED, INFINITY, M_PI, M_PI_2, nothing};
    struct variation v = {.taper = fmax(fabs(vector_dot(a, n)), fabs(vector_dot(b, n))) / nn,
                          .warp = fmax(turn(c, 1), turn(c, -1)),
                          .skew = atan2(fabs(vector_dot(c[0], c[1])), sqrt(nn)),
                          .tolerance = nothing + rounding * largest / size};
    v.kind = v.warp > v.tolerance    ? VARY_WARPED
             : v.taper > v.tolerance ? VARY_PLANE
             : v.skew > v.tolerance  ? VARY_PARALLELOGRAMS
                                     : VARY_RECTANGLES;
    return v;
}

/* Returns the parallelogram of corners A, B and the last corner. */
static struct sample spanned(const struct segment_kind *kind, const struct sample *s)
{
    struct sample p = {0};
    for (int k = 0; k < 3; k++) {
        p.x[0][k] = s->x[0][k];
        p.x[1][k] = s->x[1][k];
        p.x[3][k] = s->x[kind->corners - 1][k];
        p.x[2][k] = p.x[1][k] + (p.x[3][k] - p.x[0][k]);
    }
    return p;
}

struct variation variation_measure(const struct segment_kind *kind, const struct sample_set *set)
{
    struct variation most = {.kind = kind->bilinear ? VARY_RECTANGLES : VARY_WARPED, .tolerance = nothing};
    for (size_t i = 0; i < set->n; i++) {
        const struct sample p = kind->bilinear ? set->s[i] : spanned(kind, &set->s[i]);
        const struct variation v = measure(&p);
        most.kind = v.kind > most.kind ? v.kind : most.kind;
        most.taper = fmax(most.taper, v.taper);
        most.warp = fmax(most.warp, v.warp);
        most.skew = fmax(most.skew, v.skew);
        most.tolerance = fmax(most.tolerance, v.tolerance);
    }
    return most;
}

void variation_print(const struct variation *v, FILE *stream)
{
    const double degree = M_PI / 180;
    fprintf(stream, "segments are %s (taper up to %.3g, warp up to %.3g deg, skew up to %.3g deg)",
            variation_name[v->kind], v->taper, v->warp / degree, v->skew / degree);
}
