/* The region in which the inputs of a program may lie: the box of the file's ranges, restricted by its requires. */
#ifndef FOOTPOINT_REGION_H
#define FOOTPOINT_REGION_H

#include "known.h"

#include <stdint.h>

struct region {
    struct known *known;      /* owned: ranges, requires and program */
    struct interval *doubles; /* owned: by input, between the doubles nearest to its ends */
    struct forms *required;   /* owned: enclosures of the requires */
    double *place;            /* owned: by operation of known->place; its last value */
};

/** Returns the region of the inputs of program p, made from a genome of file f. Without `shapes`, a region block is
 *  ignored. */
struct region *region_new(const struct genome_file *f, const struct program *p, bool shapes);
void region_free(struct region *r);

/** Returns the operation of known->program for the program's operation `op`. */
int region_op(const struct region *r, int op);

/** Sets the box of the ranges. */
void region_box(const struct region *r, struct interval *box);

/** Returns true if it is proved, in at most `boxes` boxes, that the requires are nowhere all > 0 in the ranges. */
bool region_is_empty(struct region *r, long boxes);

/** Returns the width of a box's side as a fraction of its range (the width itself if the range is infinite), or 0 if it
 *  is too small to halve. */
double region_width(const struct region *r, size_t variable, struct interval side);

/** Returns true if the whole box belongs to the region. */
bool region_holds(struct region *r, const struct interval *box);

/** Computes all inputs of the file at a point, indexed by variable; inputs that rounding puts outside their range are
 *  moved into it. Values of a region block are rounded. */
void region_inputs(const struct region *r, const double *at, double *input);

/** Returns a random coordinate of a variable's range, or of [-1,1] without a range; `bits` as below. */
double region_draw_coordinate(const struct region *r, size_t variable, uint64_t *seed, int bits);

/** Draws a random point of the region, indexed by variable; variables without a range are drawn from [-1,1]. bits > 0:
 *  coordinates are short, integer multiples of a power of 2 that is `bits` bits below their range. Counts down *tries;
 *  returns false when they are used up, because the region is hard to hit. */
bool region_draw(struct region *r, uint64_t *seed, int bits, long *tries, double *at);

#endif
