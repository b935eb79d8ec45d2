/* Faces of kind quad4; see face_kind.h. */
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad4_derivatives.h"

#include "face_kind.h"

/* Finds the closest point that the header proves, with which footpoint_face_robust begins. */
static int start(const double *const *x, const double *s, double *loc, double *distance)
{
    int region;
    return footpoint_quad4_accurate_closest(X4, s, loc, distance, &region);
}

static inline void start_n(size_t n, const double *const *columns, double *xi, double *eta, double *distance,
                           int *status)
{
    int region[PAIRS_BLOCK];
    footpoint_quad4_accurate_closest_n(n, columns, xi, eta, distance, region, status);
}

BLOCKS_OF(start, start_n)
TRACK(quad4, accurate, 4)
KIND(quad4, full, 4, start)
