/* Foot points of curved faces, and whether they are the closest points. */
#ifndef FOOTPOINT_CURVED_H
#define FOOTPOINT_CURVED_H

/* What the generated header of a kind has; x points to its nodes, s to the slave node. */
struct curved {
    int nodes;
    int (*search)(const double *const *x, const double *s, double *loc, double *gap);
    int (*closest)(const double *const *x, const double *s, double *loc, double *distance, int *region);
    /* 1 if a place is inside and proved to be the closest point. */
    int (*is_closest)(const double *const *x, const double *s, const double *loc);
};

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif
/* As footpoint_face_locate. */
int footpoint_curved_locate(const struct curved *k, const double *const *x, const double *s, double loc[2],
                            double *gap);

/* Of PAIRS_BLOCK answers, see pairs.h: FOOTPOINT_OK becomes FOOTPOINT_UNPROVED unless the place is the closest point. */
void footpoint_curved_check(const struct curved *k, const double *const *columns, const double *xi, const double *eta,
                            int *status);
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
