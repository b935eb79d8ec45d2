/* Faces of four, six, eight and nine nodes in extended precision, and their closest points by subdivision: the
 * reference for libraries. It shares nothing with runtime/ or generated/; see face.c. */
#ifndef FOOTPOINT_FACE_H
#define FOOTPOINT_FACE_H

#include "../hard/truth.h"
#include "library.h"

/** r = sum c[i][j] xi^i eta^j. */
struct face {
    int kind;
    wide c[3][3][3];
    double edge; /* largest distance between neighbouring corners; mesh length */
};

struct face_nearest {
    wide z[2];
    double distance; /* mesh length */
    int on_edge;     /* no inner point at which xS - r is normal to the face is equally near, to 1e-10 of an edge */
    int certain;     /* 0 if there were too many boxes */
};

extern const int face_nodes[LIBRARY_KINDS];

/** Makes a face; x: nodes x 3. */
void face_of(int kind, const double *x, struct face *f);
/** Computes position, and derivatives by xi and eta; each of the three may be NULL. */
void face_jet(const struct face *f, const wide z[2], wide r[3], wide u[3], wide v[3]);
/** Returns 1 if z lies on the closed face, to `slack`. */
int face_holds(const struct face *f, const wide z[2], double slack);
double face_distance(const struct face *f, const double xs[3], const wide z[2]);

/** Finds the closest point of the closed face. */
void face_find(const struct face *f, const double xs[3], struct face_nearest *n);

/** Returns the distance of r(loc) from the nearest closest point of the face; INFINITY if no closest point is near. */
double face_off_closest(const struct face *f, const double xs[3], const struct face_nearest *n, const double loc[2]);
/** Returns the distance of r(loc) from a point at which xS - r is normal to the face; INFINITY if Newton's method finds
 *  no such point. */
double face_off_foot(const struct face *f, const double xs[3], const double loc[2]);

#endif
