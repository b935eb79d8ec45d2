/* The worst rounding errors that are met at random points of a region, and on climbs from the worst of them. */
#ifndef FOOTPOINT_SAMPLED_ERRORS_H
#define FOOTPOINT_SAMPLED_ERRORS_H

#include "../region/region.h"

struct sampled_errors {
    long points;   /* random points, beside those of climbs */
    double *worst; /* owned: by output, the worst |computed - exact| at a point proved to be in the region */
    double *most;  /* owned: by operation of the program, of divisors, the largest |computed| at random points */
};

/** A program made of a genome of the file. */
struct sampled {
    const struct program *program; /* not owned */
    struct arithmetic arithmetic;
};

/** Returns the errors of n programs at the same points, an array to be freed, each element by sampled_errors_free: of doubles
 *  with and without contraction to FMA; of floats, relative to the segment where they are scaled, as they are.  Takes at most
 *  `points` random points, fewer of long programs; none if the region is hard to hit, or an input has no range. */
struct sampled_errors *sampled_errors_new(const struct genome_file *f, const struct sampled *of, size_t n, long points,
                                          unsigned long seed);
void sampled_errors_free(struct sampled_errors *s);

#endif
