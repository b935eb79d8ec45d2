/* footpoint: many foot points at once, from a mesh's own arrays, and several slave nodes over one segment.
 *
 * Conventions are those of footpoint.h.  Work goes in blocks through the vector instructions of the machine that runs
 * it (AVX-512, AVX2 or SSE2 on x86-64, from one binary; what the compiler makes of plain loops elsewhere).  An answer
 * depends on its own five nodes alone: not on the size of the batch, its order, the threads or the instructions, to the
 * bit, as long as the compiler contracts no a * b + c (-ffp-contract=off, as the Makefile has it); and it is the one
 * that the function of the same tier in generated/footpoint_quad4.h gives.
 *
 * With OpenMP (make OPENMP=1) the threads share the blocks of a batch. */
#ifndef FOOTPOINT_BATCH_INCLUDED
#define FOOTPOINT_BATCH_INCLUDED

#include "footpoint.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Which search of generated/footpoint_quad4.h; its banner says how accurate each one is.  Cheapest first. */
enum footpoint_tier {
    FOOTPOINT_FAST,
    FOOTPOINT_COARSE,
    FOOTPOINT_GAUSS2,
    FOOTPOINT_MEDIUM,
    FOOTPOINT_BALANCED,
    FOOTPOINT_FINE,
    FOOTPOINT_PRECISE,
    FOOTPOINT_ACCURATE,
    FOOTPOINT_FULL,
    FOOTPOINT_TIERS
};

/** Pairs of a slave node and a segment, as a mesh has them.  Set what applies, the rest to zero:
 *      struct footpoint_pairs p = {.n = n, .nodes = nodes, .x = xyz, .y = xyz + 1, .z = xyz + 2, .stride = 3,
 *                                  .seg = seg, .slave = slave};
 *  Nothing here is owned, and nothing is written to. */
struct footpoint_pairs {
    size_t n;                   /* pairs */
    size_t nodes;               /* nodes that there are coordinates of */
    const double *x, *y, *z;    /* coordinates of node i at [stride * i], mesh length; or NULL, and */
    const float *xf, *yf, *zf;  /* the same in float, which is searched in double */
    size_t stride;              /* 3 for nodes x 3, 1 for three columns; any other from 1 */
    const int32_t *seg, *slave; /* n x 4 node indices A, B, C, D, from 0; n node indices; or NULL, and */
    const int64_t *seg64, *slave64;
    int sure; /* 1: FOOTPOINT_ERR_DOMAIN unless it is sure that an answer is as right as those of footpoint_locate */
};

/** Search of n pairs.
 *  @param[out] loc     n x 2: xi, eta as in footpoint_locate; untouched where the status is < 0
 *  @param[out] gap     n, or NULL: as in footpoint_locate; likewise
 *  @param[out] status  n, or NULL: FOOTPOINT_OK, FOOTPOINT_UNPROVED (not if p->sure),
 *                      FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE, FOOTPOINT_ERR_DOMAIN (if p->sure), or FOOTPOINT_ERR_ARGUMENT where an index is out of range, and
 *                      everywhere if the tier is, or if coordinates, stride or indices are missing
 *  @return how many pairs have a status other than FOOTPOINT_OK */
size_t footpoint_locate_batch(const struct footpoint_pairs *p, enum footpoint_tier tier, double *loc, double *gap,
                              int *status);

/** The same answers, rounded to float. */
size_t footpoint_locate_batch_float(const struct footpoint_pairs *p, enum footpoint_tier tier, float *loc, float *gap,
                                    int *status);

/** A segment ready for several slave nodes. */
struct footpoint_segment {
    double x[4][3];             /* A, B, C, D; mesh length */
    double c1[3], c2[3], c3[3]; /* r = c0 + c1 xi + c2 eta + c3 xi eta */
};

/** Any corners: where there is no area, the search says so.  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE */
int footpoint_prepare(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                      struct footpoint_segment *segment);

/** Search of n slave nodes over one prepared segment: to the bit what footpoint_locate_batch finds for these pairs.
 *  @param[in]  xs   n x 3 coordinates, mesh length
 *  @param[out] loc, gap, status  as in footpoint_locate_batch; gap and status may be NULL
 *  @return how many have a status other than FOOTPOINT_OK */
size_t footpoint_locate_prepared(const struct footpoint_segment *segment, enum footpoint_tier tier, size_t n,
                                 const double *xs, double *loc, double *gap, int *status);

#ifdef __cplusplus
}
#endif

#endif
