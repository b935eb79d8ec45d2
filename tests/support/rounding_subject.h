/* A program and where its inputs may lie, and the errors that it has there: what bounds of rounding errors are held
 * against. */
#ifndef FOOTPOINT_ROUNDING_SUBJECT_H
#define FOOTPOINT_ROUNDING_SUBJECT_H

#include "../../codegen/bound/region.h"
#include "../../codegen/genome/random.h"

#include <arb.h>

struct subject {
    struct genome_file *file;
    struct program *program;
    struct region *region;
    double *input, *at, *value; /* owned */
    long double *near;          /* owned: by operation */
    double *own, *known;        /* owned: by input and operation of the region's program */
    struct interval *box;       /* owned */
    arb_ptr exact;              /* owned: by output */
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
void subject_free(struct subject *s);

/** |x - exact|; infinite unless x is finite. */
double error_of(double x, const arb_t exact);

/** The worst error of each output, exactly where it may be the worst: at sample_count() random points of the region, and on
 *  the way uphill from a thousandth as many. */
void worst_errors(struct subject *s, double *worst);

#endif
