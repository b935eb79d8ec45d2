/* Finds the closest point of a bilinear segment in extended precision, for tests: by subdivision and polishing, sharing nothing
 * with runtime/; see truth.c. */
#ifndef FOOTPOINT_TRUTH_H
#define FOOTPOINT_TRUTH_H

#include "hard.h"
#include "subdivision.h"

/* 113 bits of mantissa if the compiler has them. */
#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 wide;
#else
typedef long double wide;
#endif

/** A segment and its slave node, times a power of two such that the longest component of its edges is about 1. */
struct truth_surface {
    wide c1[3], c2[3], c3[3], d0[3]; /* xS - r = d0 - c1 xi - c2 eta - c3 xi eta */
    double scale;                    /* mesh length / this unit */
    double distance;                 /* from the middle to xS, in this unit */
    double edge;                     /* the longest edge, in this unit */
};

struct truth_point {
    wide z[2];    /* xi, eta */
    wide square;  /* of the distance */
    double least; /* least eigenvalue of the free part of the Hessian of half the square, over squares of tangents */
    int on_edge;
};

enum { TRUTH_MOST = 64 };

/** Closest points of the segment, the nearest first: local minima in -1 <= xi, eta <= 1 whose distances are within
 * 1e-10 of the least, and some others. */
struct truth {
    struct truth_surface surface;
    int count;
    int decided;      /* 0 if the least distance may be below point[0]'s by more than 2e-12 */
    int all;          /* 0 if there may be other local minima as near */
    int contradicted; /* the check found a nearer point: truth_find is wrong */
    struct truth_point point[TRUTH_MOST];
    struct boxes_segment segment; /* the surface, rounded */
    struct boxes_list list;       /* of stationary points */
};

/** Scales a case to a surface.  Returns 0 if all corners coincide. */
int truth_surface_of(const struct hard_case *h, struct truth_surface *f);

/** Returns 0 if the corners lie in a line, to rounding, so that there is no normal. */
int truth_has_area(const struct hard_case *h);

/* The truth with all points; also with the least distance proved by bounds only on distances; or only the nearest point, whose
 * distance is right to 1e-12. */
enum truth_kind { TRUTH_ALL, TRUTH_CHECKED, TRUTH_NEAREST };

void truth_find(const struct hard_case *h, enum truth_kind kind, struct truth *t);

/** Adds the local minimum below (xi,eta), unless it is known. */
void truth_add(struct truth *t, const double loc[2]);

/** Descends from (xi,eta), clamped to the segment, to a local minimum. */
void truth_descend(const struct truth_surface *f, const double loc[2], struct truth_point *p);

/** Iterates Newton's method for (7), (8) from (xi,eta), unclamped; returns 0 if it does not converge. */
int truth_stationary(const struct truth_surface *f, const double loc[2], wide z[2]);

/** Computes the gradient of half the squared distance. */
void truth_gradient(const struct truth_surface *f, const wide z[2], wide g[2]);

/** Computes xS - r. */
void truth_offset(const struct truth_surface *f, const wide z[2], wide d[3]);

/** Returns the largest component of r(p) - r(q), in the unit of the surface. */
double truth_between(const struct truth_surface *f, const wide p[2], const wide q[2]);

wide truth_square(const struct truth_surface *f, const wide z[2]);

#endif
