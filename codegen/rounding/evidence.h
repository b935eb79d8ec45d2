/* What is found out about a program beyond its operation counts: poles, rounding errors, test points. */
#ifndef FOOTPOINT_EVIDENCE_H
#define FOOTPOINT_EVIDENCE_H

#include "../region/poles.h"
#include "sampled_errors.h"

/** One denominator of a program (OP_DIV's b; protected quotients have no poles). */
struct denominator {
    int op;     /* its operation */
    char *name; /* owned: as in the text, "t7", "in_x", "xA[0]", or the expression if it is short */
    enum pole_verdict verdict;
    double least;     /* POLE_FREE: |D| >= least > 0 over the region, proved; else 0 */
    int sign;         /* POLE_FREE: D's on the region, 1 or -1; 0: it has both */
    double *witness;  /* owned: POLE_EXISTS: inputs where |D| is 0 or on both sides of which D has opposite signs
                       * (the enclosure of a zero, its centre); else NULL */
    double error;     /* above |computed - exact| over the region; +infinity: unknown */
    bool apart;       /* no computed value is 0 or of another sign: intervals of computed values show it */
    double most;      /* the largest |D| computed at random points */
    double threshold; /* |D| <= threshold is indistinguishable from 0; 0 if unknown, or too large beside `most` */
};

/** Rounding error of one output. */
struct output_error {
    double bound; /* proved over the region, with or without contraction to FMA; +infinity: no bound was found, or none
                      * looked for: of floats that are scaled, where the region does not begin at the origin */
    double sampled; /* the worst at points of the region (sampled_errors.h); -1: not sampled */
};

/** Returns true if a bound is near enough to the worst sample to be worth telling. */
bool output_error_is_bounded(const struct output_error *e);

struct evidence {
    bool region;                     /* the file gives the range of every input that the program reads */
    bool empty;                      /* the requires contradict each other or the ranges: all below means nothing */
    struct denominator *denominator; /* owned */
    size_t denominators;
    char **protected_name; /* owned: divisors of protected quotients, named as denominators are */
    size_t protecteds;
    struct output_error *error; /* owned: by output */
    size_t outputs;
    long samples; /* random points that `sampled` is from */
};

struct evidence_options {
    const struct arithmetic *arithmetic;  /* in which the program computes; NULL: double */
    const struct sampled_errors *sampled; /* not owned: of the program; NULL: none are known */
    long boxes;                           /* work limit of branch and bound, in boxes (same limit, same bytes) */
    unsigned long seed;
    bool poles; /* denominators alone: no bound is looked for of the outputs' errors */
};

/** Never fails; what it cannot show it says. */
struct evidence *evidence_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                              const struct evidence_options *options);
void evidence_free(struct evidence *e);

/** True if no denominator can be 0 over the region (or there is none). */
bool evidence_pole_free(const struct evidence *e);

/** True if the denominator, as it is computed, can neither be 0 over the region nor have another sign than D. */
bool denominator_is_safe(const struct denominator *d);

/** Eight test points of the region (of [-1,1] without ranges) with their exact results rounded to nearest, as rows of a
 * C table "    {in..., out..., bound...},\n"; points at which a denominator is 0 are left out.  Returns their number. */
int evidence_print_points(const struct genome_file *f, const struct program *p, FILE *out);

#endif
