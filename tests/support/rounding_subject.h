/* A program and where its inputs may lie, and the errors that it has there: what bounds of rounding errors are held
 * against. */
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
    unsigned inside;               /* those in the region that were not looked at yet, a bit each */
    struct beside *own, *required; /* owned: by input and operation of the region's programs */
    struct interval *box;          /* owned */
    arb_ptr exact;                 /* owned: by output */
    float *single;                 /* owned: by operation, of a program in float; else NULL */
    float *coordinate;             /* owned: by input, twice: as given, as it is computed with */
};

/** Points looked at in a subject: few, or a million with FOOTPOINT_LONG. */
long sample_count(void);

/** From 0 to 1. */
static inline double fraction(uint64_t *seed)
{
    return (double)(random_next(seed) >> 11) * 0x1p-53;
}

/** Of the genome file `text`, which says where; p is the subject's from then on. */
struct subject subject_new(const char *text, struct program *p);
/** The program of a segment computes in float, with coordinates that are scaled (single_inputs). */
void subject_in_float(struct subject *s);
void subject_free(struct subject *s);

/** |x - exact|; infinite unless x is finite. */
double error_of(double x, const arb_t exact);

/** The worst error of each output, exactly where it may be the worst: at sample_count() random points of the region, and on
 *  the way uphill from a thousandth as many, for each output, or, of many, for one after the other. */
void worst_errors(struct subject *s, double *worst);

#endif
