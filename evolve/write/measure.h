/* Errors and regions on held-out samples, which are measured as they are drawn and not stored. */
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
 *  of each genome of two outputs (climb.h) if `most` is SIZE_MAX.
 *  @param[in] most  largest number of samples of a part
 *  @return false with *d filled; m->memory must be freed in either case */
bool measure_genomes(struct genome_file *f, size_t outs, const struct heldout *heldout, size_t most, struct measured *m,
                     struct diag *d);

/** Climbs from the worst samples of each genome of two outputs, as above.
 *  @param[in] single     errors are those in float
 *  @param[in] found, to  as in climb.h
 *  @return false with *d filled */
bool measure_climbed(const struct genome_file *f, struct sampler *p, bool single,
                     void (*found)(void *to, const struct sample *s), void *to, struct diag *d);

#endif
