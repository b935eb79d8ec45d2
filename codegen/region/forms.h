/* Enclosures of the values of a program over a box of its inputs. Each value has two: an interval, and an affine form
 *
 *     value = centre + sum_k slope[k] e_k + radius e,   e_k, e in [-1,1],
 *
 * where e_k runs through the box along variable k, so that dependences on the same inputs cancel (affine arithmetic:
 * Comba and Stolfi 1993). Each narrows the other. */
#ifndef FOOTPOINT_FORMS_H
#define FOOTPOINT_FORMS_H

#include "known.h"

/** Depth to which a require narrows its operands. */
enum { FORMS_DEPTH = 3 };

/** Rows after those of the operations: rows at hand, then derivatives of a result, by operation. */
enum { FORMS_HANDS = 4 };

struct forms {
    struct arena arena;        /* of all owned arrays */
    const struct known *known; /* not owned */
    int *needed;               /* owned: operations on which the targets depend, and useful requires, ascending */
    size_t needs;
    int *twin;               /* owned: by operation; an earlier needed operation of which it is a multiple, or -1 */
    struct interval *ratio;  /* owned: by operation; over its twin */
    bool *required;          /* owned: by operation; it is > 0 on the region */
    struct interval *range;  /* owned: by operation; its values on the box's part of the region */
    double *centre, *radius; /* owned: by row; an infinite radius means no form */
    double *mass;            /* owned: by row; >= sum |slope| */
    double *slope;           /* owned: by row and variable */
    double *middle, *half;   /* owned: by variable; its value is middle + half e_k */
    bool affine;             /* false: there would be too many slopes, so only intervals are used */
    bool inside;             /* after an evaluation: the whole box belongs to the region */
};

/** Returns memory for enclosures of the target operations; without targets, of all requires. */
struct forms *forms_new(const struct known *x, const int *target, size_t targets);
void forms_free(struct forms *w);

#endif
