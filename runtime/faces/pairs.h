/* Many pairs of a slave node and a face or patch, out of coordinates and connectivity. */
#ifndef FOOTPOINT_PAIRS_H
#define FOOTPOINT_PAIRS_H

#include "../footpoint.h"

enum { PAIRS_BLOCK = 32, PAIRS_MOST_VECTORS = 10 }; /* the slave node among them */

/* What is searched: nodes, and for patches as many unit normals there. */
struct pairs_kind {
    int nodes, normals;
    int (*locate)(const double *const *x, const double *s, double *loc, double *gap);
    /* PAIRS_BLOCK pairs; coordinate i of vector k, the slave node being the last, in column 3 k + i. */
    void (*block)(const double *const *columns, double *xi, double *eta, double *gap, int *status);
    int tracks; /* loc, xi and eta are last answers on entry */
};

struct pairs {
    size_t n;
    const double *xyz, *normals; /* by node index */
    size_t nodes;
    const int *seg, *slave;
};

/* Not for callers of the library. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif
/* As footpoint_face_locate_pairs; kind NULL: there is none. */
size_t footpoint_pairs_locate(const struct pairs_kind *kind, const struct pairs *p, double *loc, double *gap,
                              int *status);

/* What becomes of pair number `pair`, x its vectors, from what kind->locate returned and wrote; returns a status. */
typedef int pairs_finish(const void *of, size_t pair, const double *x, int status, const double loc[2], double gap);

/* Finishes all pairs.
 *  @param[out] status  n, or NULL: as finish, or FOOTPOINT_ERR_ARGUMENT where an index is out of range
 *  @return how many statuses are neither FOOTPOINT_OK nor FOOTPOINT_OUTSIDE */
size_t footpoint_pairs_finish(const struct pairs_kind *kind, const struct pairs *p, pairs_finish *finish,
                              const void *of, int *status);
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
