/* Faces of four to nine nodes for tests of proofs, and a judge of answers that takes Newton's steps in quadruple precision, of
 * shape functions, and shares no code with what it judges. */
#ifndef FOOTPOINT_TESTS_JUDGED_FACES_H
#define FOOTPOINT_TESTS_JUDGED_FACES_H

#include <stdbool.h>
#include <stdint.h>

__extension__ typedef __float128 wide;

enum { JUDGED_CURVED = 3, JUDGED_KINDS, JUDGED_NODES = 9 };

/** Curved kinds first. */
extern const struct judged_kind {
    const char *name;
    int nodes, corners;
} judged_kinds[JUDGED_KINDS];

struct judged_face {
    const struct judged_kind *kind;
    double x[JUDGED_NODES + 1][3]; /* the slave node after the others */
};

/** Wild: far away, large, small, with nodes that coincide. */
enum judged_group { JUDGED_ORDINARY, JUDGED_STRONG, JUDGED_SLIVER, JUDGED_WILD, JUDGED_GROUPS };

/** Draws nodes and a slave node for the kind of *f. */
void judged_draw(uint64_t *stream, enum judged_group group, struct judged_face *f);

/** Returns the face in another unit of length, so that quadruple precision suffices. */
struct judged_face judged_unit(const struct judged_face *f);

/** Returns whether an answer that is OK is as near to a minimum as promised: to `known`, which is one if *is_known, or to another
 *  that is found now from it, or from about it. */
bool judged_holds(const struct judged_face *f, const double loc[2], double promise, wide known[2], bool *is_known);

#endif
