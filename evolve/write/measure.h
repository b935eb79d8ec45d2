/* Errors and regions on held-out samples, which are measured as they are drawn and not stored; and worst errors between the
 * samples, by a local search uphill from the worst samples. */
#ifndef FOOTPOINT_MEASURE_H
#define FOOTPOINT_MEASURE_H

#include "../eval/errors.h"
#include "../samples/samples.h"

enum { HELDOUT_PIECE = 4096 };
/** Draws the next *n <= HELDOUT_PIECE samples of a part, starting at number *at, and advances *at; *n is 0 after the last
 *  sample or after `most`.  Returns false with *d filled. */
bool heldout_piece(struct sampler *p, size_t most, size_t *at, struct sample *s, size_t *n, struct diag *d);

/** Errors of genomes on the held-out parts. */
struct measured {
    struct arena memory; /* owned; it owns: */
    struct genes *t;     /* the outputs, genome by genome; genes not owned */
    int *output;         /* 0 is xi, 1 is eta */
    size_t n;
    struct errors *found[HELDOUT_PARTS]; /* indexed as t; NULL if the scene lacks the part */
};

/** Measures all genomes of a file that have `outs` outputs and adds the file's region.  Climbs from the worst samples
 *  of each genome of two outputs (climb()) if `most` is SIZE_MAX.
 *  @param[in] most  largest number of samples of a part
 *  @return false with *d filled; m->memory must be freed in either case */
bool measure_genomes(struct genome_file *f, size_t outs, const struct heldout *heldout, size_t most, struct measured *m,
                     struct diag *d);

/** Climbs from the worst samples of each genome of two outputs, as above.
 *  @param[in] single     errors are those in float
 *  @param[in] found, to  as in climb_goal
 *  @return false with *d filled */
bool measure_climbed(const struct genome_file *f, struct sampler *p, bool single,
                     void (*found)(void *to, const struct sample *s), void *to, struct diag *d);

/* ---- climb.c ---- */

/** Climbs from the worst samples of a function, TALLY_WORST in all.  Each climber changes the random numbers that its sample
 *  is drawn from, 60 times on bilinear faces and 30 times on curved ones, by ever smaller steps, and keeps a change if it
 *  makes the larger error of xi and eta larger.  Every change is a sample within the scene's limits with a certain foot
 *  point of its own.  Deterministic in the scene, its run and `first`.
 *  @param[in,out] m         must have taken the samples of p; its tallies are sorted
 *  @param[in] first, outs   the outputs of the function in m, 2 at most
 *  @param[out] worst        worst[outs]: the largest error of each output; at least that of the samples
 *  @param[in] found, to     as in climb_goal */
void climb(struct sampler *p, struct measurement *m, size_t first, size_t outs, double *worst,
           void (*found)(void *to, const struct sample *s), void *to);

/** The function that is climbed. */
struct climb_goal {
    void (*errors)(const void *of, const struct sample *s, size_t n, double **error); /* of each output on n samples */
    const void *of;                                                                   /* not owned */
    size_t outs;                                                                      /* 2 at most */
    void (*found)(void *to, const struct sample *s); /* takes the sample that each climber ends at; or NULL */
    void *to;                                        /* not owned */
};
/** The same from any samples, TALLY_WORST at most.
 *  @param[in] key            of the random numbers
 *  @param[in] start, n       samples with their errors
 *  @param[in,out] worst      raised to the largest error of each output */
void climb_from(struct sampler *p, const struct climb_goal *goal, uint64_t key, const struct largest *start, size_t n,
                double *worst);

/** Returns whether the samples of a part can be climbed from: they are drawn, and from the scene's own distribution. */
bool climb_can(const struct sampler *p);

#endif
