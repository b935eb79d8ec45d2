/* Enclosures of the values of a region's program over a box of its inputs.  Each value is known twice: as an interval
 * and as an affine form
 *     value = centre + sum_k slope[k] e_k + radius e,   e_k, e in [-1,1],
 * where e_k runs through the box along variable k, so that what depends on the same inputs cancels (affine arithmetic:
 * Comba and Stolfi 1993).  Either serves to narrow the other. */
#ifndef FOOTPOINT_ENCLOSURE_H
#define FOOTPOINT_ENCLOSURE_H

#include "region.h"

struct forms {
    const struct region *region; /* not owned */
    int *needed;                 /* owned: operations that the target and requires of use to it depend on, ascending */
    size_t needs;
    int *twin;               /* owned: by operation, an earlier one of these that it is a multiple of, or -1 */
    struct interval *ratio;  /* owned: by operation, to its twin */
    bool *required;          /* owned: by operation, it is > 0 on the region */
    struct interval *range;  /* owned: by operation, its values on the box's part of the region */
    double *centre, *radius; /* owned: by operation; the radius is infinite where there is no form */
    double *mass;            /* owned: by operation, >= sum |slope| */
    double *slope;           /* owned: by operation and variable */
    bool affine;             /* false: there would be too many slopes; intervals alone */
    bool inside;             /* after an evaluation: all of the box belongs to the region */
};

/** Enclosures of operation `target` of region->program; or -1, of the requires, all of them. */
struct forms *forms_new(const struct region *r, int target);
void forms_free(struct forms *w);

/** Evaluate over a box (by variable).  False: it has no point of the region. */
bool forms_evaluate(struct forms *w, const struct interval *box);

/** The same after cutting off what the requires exclude. */
bool forms_evaluate_narrowed(struct forms *w, struct interval *box);

/** True if all values are finite over the box, hence continuous there. */
bool forms_finite(const struct forms *w);

bool box_is_empty(const struct interval *box, size_t variables);

/** The interval around a rational. */
struct interval interval_around(const fmpq *q);

#endif
