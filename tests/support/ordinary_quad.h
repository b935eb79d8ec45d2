/* Ordinary segments with a foot point that is known by construction, and transformations of them, for property tests. */
#ifndef FOOTPOINT_ORDINARY_QUAD_H
#define FOOTPOINT_ORDINARY_QUAD_H

#include <stdint.h>

/** A segment, a slave node at r(xi,eta) + gap n(xi,eta), and that answer. */
struct quad {
    double x[4][3], xs[3];
    double xi, eta, gap;
};

/** The limits of quad_draw. */
struct quad_limits {
    double corner; /* corners move by up to this fraction of the shorter edge, in the plane */
    double warp;   /* and by this fraction out of it */
    double gap;    /* |gap| over the shorter edge */
    double reach;  /* |xi|, |eta| up to this */
};

/** The limits of most meshes: corners moved 15 %, warp 3 %, gap 10 %. */
extern const struct quad_limits quad_ordinary;

/** Draws segment number `index`: aspect ratio 1 to 3, turned and moved at random, edges of length 0.1 to 30. */
struct quad quad_draw(const struct quad_limits *limits, uint64_t index);

/** Turns a segment by a random rotation (of number `index`), scales it, then shifts it by a multiple of its size. */
struct quad quad_move(const struct quad *q, uint64_t index, double scale, double shift);

/** Returns the same segment with B first: (xi,eta) becomes (eta,-xi). */
struct quad quad_turn_corners(const struct quad *q);

/** Returns the same segment seen from behind, B and D exchanged: (xi,eta) becomes (eta,xi), the gap changes sign. */
struct quad quad_mirror_corners(const struct quad *q);

#endif
