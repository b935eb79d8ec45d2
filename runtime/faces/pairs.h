/* Searches many pairs of a slave node and a face or patch, from coordinates and connectivity. */
#ifndef FOOTPOINT_PAIRS_H
#define FOOTPOINT_PAIRS_H

#include "../footpoint.h"

enum { PAIRS_BLOCK = 32, PAIRS_MOST_VECTORS = 11 }; /* including the slave node and a direction */

/* A kind of face or patch: its number of nodes, for patches also of unit normals, and its searches. */
struct pairs_kind {
    int nodes, normals;
    int (*locate)(const double *const *x, const double *s, double *loc, double *gap);
    /* Searches PAIRS_BLOCK pairs; coordinate i of vector k, the slave node behind the others, is in column 3 k + i. */
    void (*block)(const double *const *columns, double *xi, double *eta, double *gap, int *status);
    int tracks;     /* loc, xi and eta hold last answers on entry */
    int directions; /* 1 if a direction follows the slave node, otherwise 0 */
};

struct pairs {
    size_t n;
    const double *xyz, *normals; /* by node index */
    size_t nodes;
    const int *seg, *slave;
    const double *along; /* n x 3 directions, or NULL */
};

/* Only for files of the library. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif
/* Does the work of footpoint_face_locate_pairs; kind may be NULL. */
size_t footpoint_pairs_locate(const struct pairs_kind *kind, const struct pairs *p, double *loc, double *gap,
                              int *status);

/* Finishes pair number `pair`, with vectors x, from the results of kind->locate; returns a status. */
typedef int pairs_finish(const void *of, size_t pair, const double *x, int status, const double loc[2], double gap);

/* Searches and finishes all pairs.
 *  @param[out] status  n, or NULL: as finish, or FOOTPOINT_ERR_ARGUMENT if an index is out of range
 *  @return the number of statuses that are neither FOOTPOINT_OK nor FOOTPOINT_OUTSIDE */
size_t footpoint_pairs_finish(const struct pairs_kind *kind, const struct pairs *p, pairs_finish *finish,
                              const void *of, int *status);
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
