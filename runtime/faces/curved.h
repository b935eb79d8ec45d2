/* Finds foot points of curved faces and proves that they are closest points. */
#ifndef FOOTPOINT_CURVED_H
#define FOOTPOINT_CURVED_H

/* Functions of the generated header of a kind; x points to its nodes, s to the slave node. */
struct curved {
    int nodes;
    int (*search)(const double *const *x, const double *s, double *loc, double *gap);
    int (*closest)(const double *const *x, const double *s, double *loc, double *distance, int *region);
    /* Returns 1 if a place is inside and proved to be the closest point. */
    int (*is_closest)(const double *const *x, const double *s, const double *loc);
};

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif
/* Does the work of footpoint_face_locate. */
int footpoint_curved_locate(const struct curved *k, const double *const *x, const double *s, double loc[2],
                            double *gap);

/* Turns FOOTPOINT_OK of PAIRS_BLOCK answers (pairs.h) into FOOTPOINT_UNPROVED unless the place is the closest point. */
void footpoint_curved_check(const struct curved *k, const double *const *columns, const double *xi, const double *eta,
                            int *status);
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
