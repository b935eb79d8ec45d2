/* Judges answers on patches by Newton's steps in quadruple precision.  It shares no code with the functions that it judges. */
#ifndef FOOTPOINT_TESTS_PATCH_JUDGE_H
#define FOOTPOINT_TESTS_PATCH_JUDGE_H

#include <stdbool.h>

__extension__ typedef __float128 patch_wide;

enum { PATCH_VECTORS = 9 };

/** Holds a patch: corners A, B, C, D, normals there, slave node. kind: 0 Bezier, 1 Gregory. */
struct patch_case {
    int kind;
    double x[PATCH_VECTORS][3];
};

/** Holds control points; twin: the inner points that edges along eta make. */
struct patch_net {
    patch_wide p[4][4][3], twin[4][4][3];
};

/** Returns the patch in another unit of length, so that quadruple precision suffices. */
struct patch_case patch_unit(const struct patch_case *f);

void patch_net_make(const struct patch_case *f, struct patch_net *t);

/** Computes the point r[0] and the tangents r[1] and r[2] at z. */
void patch_net_at(const struct patch_case *f, const struct patch_net *t, const patch_wide z[2], patch_wide r[3][3]);

/** Returns true if loc is as near to a minimum as `promise` for its status: FOOTPOINT_OK, or FOOTPOINT_OUTSIDE for a
 *  minimum on an edge or in a corner. `known` is a minimum if *is_known; otherwise a minimum that is found is stored
 *  there. */
bool patch_answer_holds(const struct patch_case *f, const struct patch_net *t, int status, const double loc[2],
                        double promise, patch_wide known[2], bool *is_known);

#endif
