/* Edges for tests, and their true answers: all roots of the cubic of shape functions in quadruple precision. */
#ifndef FOOTPOINT_EDGE_JUDGE_H
#define FOOTPOINT_EDGE_JUDGE_H

#include <stdbool.h>
#include <stdint.h>

__extension__ typedef __float128 wide;

struct judged {
    wide x[4][2]; /* A, B, C, S; C is the middle of an edge of two nodes */
    wide f[4];    /* coefficients of r' . (r - S) */
    wide least;   /* the square of the least distance */
    wide place[5], square[5];
    int places; /* minima on the edge, the nearest first */
    double unit, promise, tie,
        apart; /* of rounding; of xi; of distances that are equal; of places that are not, over lengths */
};

/** Sets x and f of an edge of `nodes` nodes and a slave node, and what functions in double promise. */
void judge_edge(struct judged *j, int nodes, double x[4][2]);
/** Sets the errors that functions in float promise. */
void judge_single(struct judged *j);
/** Sets f to the coefficients of r' . (r - S) for the current x. */
void judge_expand(struct judged *j);
/** Finds the minima on the edge. */
void judge_find(struct judged *j);
/** Computes the point at t. */
void judge_point(const struct judged *j, wide t, wide r[2]);
wide judge_value(const wide f[4], wide t);
wide judge_root(wide a);

/** Returns true if a minimum lies within the promise, that is, the cubic rises through 0. */
bool judge_holds(const struct judged *j, double xi);
/** Returns true if the gap is right to the promise and rounding. */
bool judge_gap_holds(const struct judged *j, double xi, double gap);
/** Returns true if a closest point with the status FOOTPOINT_OK or FOOTPOINT_NOT_UNIQUE is right; call after
 *  judge_find. */
bool judge_closest_holds(const struct judged *j, int status, double xi, double dist, int region);

enum family { ORDINARY, CURVED, QUARTER, LINE, WILD, COINCIDENT, FAR, OFFSET, SIZE, SCALES, END, TIE, FAMILIES };
extern const char *const edge_families[FAMILIES];

/** Draws an edge of two or three nodes, followed by the slave node. */
void draw_edge(enum family family, uint64_t *stream, int nodes, double x[4][2]);

#endif
