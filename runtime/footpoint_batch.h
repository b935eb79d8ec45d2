/* footpoint: many foot points at once, in a mesh's own arrays, and several slave nodes over a segment.
 *
 * Conventions follow footpoint.h.  Blocks of pairs use the vector instructions of the machine at run time: AVX-512, AVX2
 * or SSE2 on x86-64, elsewhere the compiler's code for plain loops.  An answer depends only on its own five nodes, to the
 * bit, not on batch size, order, threads or instructions, provided that the compiler contracts no a * b + c
 * (-ffp-contract=off, as in the Makefile).  It equals the answer of the same tier in generated/footpoint_quad4.h.
 *
 * With OpenMP (make OPENMP=1) threads share the blocks of a batch. */
#ifndef FOOTPOINT_BATCH_INCLUDED
#define FOOTPOINT_BATCH_INCLUDED

#include "footpoint.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The searches of generated/footpoint_quad4.h, whose banner states their accuracy.  Cheapest first. */
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

/** Pairs of a slave node and a segment in a mesh's arrays.  Set the members that apply, all others to zero:
 *      struct footpoint_pairs p = {.n = n, .nodes = nodes, .x = xyz, .y = xyz + 1, .z = xyz + 2, .stride = 3,
 *                                  .seg = seg, .slave = slave};
 *  Nothing here is owned or written to. */
struct footpoint_pairs {
    size_t n;                   /* pairs */
    size_t nodes;               /* number of nodes with coordinates */
    const double *x, *y, *z;    /* coordinates of node i at [stride * i], mesh length; or NULL and */
    const float *xf, *yf, *zf;  /* the same in float, searched in double */
    size_t stride;              /* 3 for nodes x 3, 1 for three columns; any from 1 */
    const int32_t *seg, *slave; /* n x 4 node indices A, B, C, D, from 0; n node indices; or NULL and */
    const int64_t *seg64, *slave64;
    int sure; /* 1: FOOTPOINT_ERR_DOMAIN unless an answer is proved to be as accurate as footpoint_locate's */
};

/** Searches n pairs.
 *  @param[out] loc     n x 2: xi, eta as in footpoint_locate; untouched if the status is < 0
 *  @param[out] gap     n, or NULL: as in footpoint_locate; untouched likewise
 *  @param[out] status  n, or NULL: FOOTPOINT_OK, FOOTPOINT_UNPROVED (unless p->sure), FOOTPOINT_ERR_NOT_FINITE,
 *                      FOOTPOINT_ERR_DEGENERATE, FOOTPOINT_ERR_DOMAIN (if p->sure), or FOOTPOINT_ERR_ARGUMENT if an index is
 *                      out of range, for all pairs if the tier is, or if coordinates, stride or indices are missing
 *  @return the number of pairs whose status is not FOOTPOINT_OK */
size_t footpoint_locate_batch(const struct footpoint_pairs *p, enum footpoint_tier tier, double *loc, double *gap,
                              int *status);

/** Searches n pairs and rounds the answers of footpoint_locate_batch to float. */
size_t footpoint_locate_batch_float(const struct footpoint_pairs *p, enum footpoint_tier tier, float *loc, float *gap,
                                    int *status);

/** A segment prepared for several slave nodes. */
struct footpoint_segment {
    double x[4][3];             /* A, B, C, D; mesh length */
    double c1[3], c2[3], c3[3]; /* r = c0 + c1 xi + c2 eta + c3 xi eta */
};

/** Prepares a segment of any corners; if it has no area, the search returns the status.
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE */
int footpoint_prepare(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                      struct footpoint_segment *segment);

/** Searches n slave nodes over a prepared segment, with the bits of footpoint_locate_batch for these pairs.
 *  @param[in]  xs   n x 3 coordinates, mesh length
 *  @param[out] loc, gap, status  as in footpoint_locate_batch; gap and status may be NULL
 *  @return the number of slave nodes whose status is not FOOTPOINT_OK */
size_t footpoint_locate_prepared(const struct footpoint_segment *segment, enum footpoint_tier tier, size_t n,
                                 const double *xs, double *loc, double *gap, int *status);

#ifdef __cplusplus
}
#endif

#endif
