/* Faces of four to nine nodes for tests: their kinds, curved kinds first, their surface in quadruple precision, and
 * families of faces. */
#ifndef FOOTPOINT_TESTS_CURVED_CASES_H
#define FOOTPOINT_TESTS_CURVED_CASES_H

#include <stdint.h>

__extension__ typedef __float128 wide;

enum { CURVED_NODES = 9, CURVED_KINDS = 3, CASE_KINDS };

extern const struct curved_kind {
    const char *name;
    int nodes, corners;
} curved_kinds[CASE_KINDS];

struct curved_case {
    const struct curved_kind *kind;
    double x[CURVED_NODES + 1][3]; /* the slave node follows the face's nodes */
};

enum curved_group { ORDINARY, STRONG, SLIVER, WILD, CURVED_GROUPS };
extern const char *const curved_groups[CURVED_GROUPS];

static inline double size_of(wide x)
{
    return x < 0 ? -(double)x : (double)x;
}

/** Writes the slopes r_xi . d and r_eta . d of half the squared distance at z, with d = xS - r, and its Hessian. */
void curved_slopes(const struct curved_case *f, const wide z[2], wide g[2], wide H[3]);

/** d as a polynomial; d[k][i][j] is the coefficient of xi^i eta^j in coordinate k. */
struct curved_powers {
    wide d[3][3][3];
};
void curved_powers(const struct curved_case *f, struct curved_powers *p);

/** Computes the same as curved_slopes, faster.
 *  @return half the squared distance */
wide curved_half(const struct curved_powers *p, const wide z[2], wide g[2], wide H[3]);

/** Draws a face of f->kind, with a slave node over it or a little beside it. */
void curved_draw(uint64_t *stream, enum curved_group group, struct curved_case *f);

/** Moves the slave node up to `away` longest edges from a random point of the face, in a random direction. */
void curved_draw_slave(uint64_t *stream, struct curved_case *f, double away);

#endif
