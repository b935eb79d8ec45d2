/* A program, the region of its inputs, and its errors there, against which bounds of rounding errors are compared. */
#ifndef FOOTPOINT_ROUNDING_SUBJECT_H
#define FOOTPOINT_ROUNDING_SUBJECT_H

#include "../../codegen/base/random.h"
#include "../../codegen/region/region.h"

#include <arb.h>

enum { SIDE_BY_SIDE = 8 };

/* A value at several points. */
struct beside {
    double at[SIDE_BY_SIDE];
};

struct subject {
    struct genome_file *file;
    struct program *program;
    struct region *region;
    double *input, *at, *value;    /* owned */
    long double *near;             /* owned: by operation */
    double *point[SIDE_BY_SIDE];   /* owned: candidates, by variable of the region */
    unsigned inside;               /* unexamined candidates in the region, a bit each */
    struct beside *own, *required; /* owned: by input and operation of the region's programs */
    struct interval *box;          /* owned */
    arb_ptr exact;                 /* owned: by output */
    float *single;                 /* owned: by operation, for a program in float; otherwise NULL */
    float *coordinate;             /* owned: by input, twice: as given, as used in the computation */
};

/** Returns the number of points examined in a subject: few, or a million with FOOTPOINT_LONG. */
long sample_count(void);

/** Returns a random number from 0 to 1. */
static inline double fraction(uint64_t *seed)
{
    return (double)(random_next(seed) >> 11) * 0x1p-53;
}

/** Makes a subject of the genome file `text`, which has the region; takes ownership of p. */
struct subject subject_new(const char *text, struct program *p);
/** Makes the program of a segment compute in float, with scaled coordinates (single_inputs). */
void subject_in_float(struct subject *s);
void subject_free(struct subject *s);

/** Returns |x - exact|; infinite unless x is finite. */
double error_of(double x, const arb_t exact);

/** Computes the worst error of each output, exactly if it may be the worst: at sample_count() random points of the region, and on
 *  the way uphill from a thousandth as many, for each output, or, if there are many, for one output after the other. */
void worst_errors(struct subject *s, double *worst);

#endif
