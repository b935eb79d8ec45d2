/* Where the inputs of a program may lie: the box of the file's ranges, as far as its requires are > 0. */
#ifndef FOOTPOINT_REGION_H
#define FOOTPOINT_REGION_H

#include "known.h"

#include <stdint.h>

struct region {
    struct known *known;      /* owned: ranges, requires and program */
    struct interval *doubles; /* owned: by input, between the doubles nearest to its ends */
    struct forms *required;   /* owned: enclosures of the requires */
    double *place;            /* owned: by operation of known->place, its last value */
};

/** The region of the inputs of program p, made from a genome of file f; without `shapes` a region block is passed over. */
struct region *region_new(const struct genome_file *f, const struct program *p, bool shapes);
void region_free(struct region *r);

/** Number in known->program of the program's operation `op`. */
int region_op(const struct region *r, int op);

/** The box of the ranges. */
void region_box(const struct region *r, struct interval *box);

/** True if it is proved, in at most `boxes` boxes, that nowhere in the ranges are all requires > 0. */
bool region_is_empty(struct region *r, long boxes);

/** Width of a box's side as a fraction of its range (of infinite ranges, as it is); 0 if that is too small to be
 * halved. */
double region_width(const struct region *r, size_t variable, struct interval side);

/** True if all of the box belongs to the region. */
bool region_holds(struct region *r, const struct interval *box);

/** Values of all inputs of the file at a point given by variable, which is moved into the ranges where rounding puts it
 *  outside.  What a region block computes is rounded. */
void region_inputs(const struct region *r, const double *at, double *input);

/** Returns a random coordinate of a variable's range, [-1,1] without one; `bits` as below. */
double region_draw_coordinate(const struct region *r, size_t variable, uint64_t *seed, int bits);

/** A random point of the region, by variable; those without a range are drawn from [-1,1].  `bits` > 0: coordinates are
 *  short, whole multiples of a power of 2, so many bits below that of their range.  False when *tries, which are
 *  counted down, are used up: the region is hard to hit. */
bool region_draw(struct region *r, uint64_t *seed, int bits, long *tries, double *at);

#endif
