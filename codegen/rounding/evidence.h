/* Evidence about a program beyond its operation counts: poles, rounding errors, test points. */
#ifndef FOOTPOINT_EVIDENCE_H
#define FOOTPOINT_EVIDENCE_H

#include "../region/poles.h"
#include "sampled_errors.h"

/** A denominator of a program (OP_DIV's b; protected quotients have no poles). */
struct denominator {
    int op;     /* its operation */
    char *name; /* owned: as in the text, "t7", "in_x", "xA[0]", or a short expression */
    enum pole_verdict verdict;
    double least;     /* POLE_FREE: |D| >= least > 0 over the region, proved; otherwise 0 */
    int sign;         /* POLE_FREE: D's sign on the region, 1 or -1; 0: it has both */
    double *witness;  /* owned: POLE_EXISTS: inputs where D is 0, or the centre of an enclosure at whose sides D has
                       * opposite signs; otherwise NULL */
    double error;     /* bounds |computed - exact| over the region; +infinity: unknown */
    bool apart;       /* intervals show that no computed value is 0 or has another sign */
    double most;      /* the largest |D| computed at random points */
    double threshold; /* |D| <= threshold is indistinguishable from 0; 0 if unknown, or too large compared with
                       * `most` */
};

/** Rounding error of an output. */
struct output_error {
    double bound; /* proved over the region, with or without contraction to FMA; +infinity: not found, or not searched,
                   * as for scaled floats whose region does not begin at the origin */
    double sampled; /* the worst error at points of the region (sampled_errors.h); -1: not sampled */
};

/** Returns true if a bound is close enough to the worst sample to be worth printing. */
bool output_error_is_bounded(const struct output_error *e);

struct evidence {
    bool region;                     /* the file has ranges for every input that the program reads */
    bool empty;                      /* the requires contradict each other or the ranges: all below is meaningless */
    struct denominator *denominator; /* owned */
    size_t denominators;
    char **protected_name; /* owned: divisors of protected quotients, named like denominators */
    size_t protecteds;
    struct output_error *error; /* owned: by output */
    size_t outputs;
    long samples; /* random points behind `sampled` */
};

struct evidence_options {
    const struct arithmetic *arithmetic;  /* in which the program computes; NULL: double */
    const struct sampled_errors *sampled; /* not owned: of the program; may be NULL */
    long boxes;                           /* work limit of branch and bound, in boxes (same limit, same bytes) */
    unsigned long seed;
    bool poles; /* denominators only: outputs' errors are not bounded */
};

/** Collects evidence; never fails, but records what it cannot show. */
struct evidence *evidence_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                              const struct evidence_options *options);
void evidence_free(struct evidence *e);

/** Returns true if no denominator can be 0 over the region. */
bool evidence_pole_free(const struct evidence *e);

/** Returns true if the computed denominator can neither be 0 over the region nor have another sign than D. */
bool denominator_is_safe(const struct denominator *d);

/** Prints eight test points of the region (of [-1,1] without ranges) with their exact results rounded to nearest, as
 *  rows of a C table "    {in..., out..., bound...},\n". Points where a denominator is 0 are omitted. Returns their
 *  number. */
int evidence_print_points(const struct genome_file *f, const struct program *p, FILE *out);

#endif
