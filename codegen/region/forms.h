/* Enclosures of the values of a program over a box of its inputs.  Each value is known twice: as an interval and as an
 * affine form
 *     value = centre + sum_k slope[k] e_k + radius e,   e_k, e in [-1,1],
 * where e_k runs through the box along variable k, so that what depends on the same inputs cancels (affine arithmetic:
 * Comba and Stolfi 1993).  Either serves to narrow the other. */
#ifndef FOOTPOINT_FORMS_H
#define FOOTPOINT_FORMS_H

#include "known.h"

/** How many operations deep a require tells of what it is made of. */
enum { FORMS_DEPTH = 3 };

/** Rows behind those of the operations: at hand, then, by operation, derivatives of a result by it. */
enum { FORMS_HANDS = 4 };

struct forms {
    struct arena arena;        /* of all that is owned */
    const struct known *known; /* not owned */
    int *needed; /* owned: operations that the targets and requires of use to these depend on, ascending */
    size_t needs;
    int *twin;               /* owned: by operation, an earlier one of these that it is a multiple of, or -1 */
    struct interval *ratio;  /* owned: by operation, to its twin */
    bool *required;          /* owned: by operation, it is > 0 on the region */
    struct interval *range;  /* owned: by operation, its values on the box's part of the region */
    double *centre, *radius; /* owned: by row; the radius is infinite where there is no form */
    double *mass;            /* owned: by row, >= sum |slope| */
    double *slope;           /* owned: by row and variable */
    double *middle, *half;   /* owned: by variable, its number is middle + half e_k */
    bool affine;             /* false: there would be too many slopes; intervals alone */
    bool inside;             /* after an evaluation: all of the box belongs to the region */
};

/** Room for enclosures of operations of the program, the targets; of none, of the requires, all of them. */
struct forms *forms_new(const struct known *x, const int *target, size_t targets);
void forms_free(struct forms *w);

#endif
