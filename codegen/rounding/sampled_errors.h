/* The worst rounding errors found at random points of a region, and on climbs from the worst of them. */
#ifndef FOOTPOINT_SAMPLED_ERRORS_H
#define FOOTPOINT_SAMPLED_ERRORS_H

#include "../region/region.h"

struct sampled_errors {
    long points;   /* random points, without those of climbs */
    double *worst; /* owned: by output; the worst |computed - exact| at a point proved to be in the region */
    double *most;  /* owned: by operation of the program, for divisors; the largest |computed| at random points */
};

/** A program made from a genome of the file. */
struct sampled {
    const struct program *program; /* not owned */
    struct arithmetic arithmetic;
};

/** Returns the errors of n programs at the same points, an array to be freed after sampled_errors_free of each element.
 *  Doubles are computed with and without contraction to FMA; floats without, relative to the segment if they are
 *  scaled. Takes at most `points` random points, fewer for long programs; no points if the region is hard to hit or an
 *  input has no range. */
struct sampled_errors *sampled_errors_new(const struct genome_file *f, const struct sampled *of, size_t n, long points,
                                          unsigned long seed);
void sampled_errors_free(struct sampled_errors *s);

#endif
