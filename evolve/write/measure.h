/* What is measured on samples held out, which are drawn one after the other and not kept. */
#ifndef FOOTPOINT_MEASURE_H
#define FOOTPOINT_MEASURE_H

#include "../eval/errors.h"
#include "../samples/sampler.h"

enum { HELDOUT_PIECE = 4096 };
/** Draws the next samples of a part, HELDOUT_PIECE at most, from number *at on, which grows; *n is 0 behind the last one and from
 *  `most` on.  False with *d filled. */
bool heldout_piece(struct sampler *p, size_t most, size_t *at, struct sample *s, size_t *n, struct diag *d);

/** Errors of genomes on the parts held out. */
struct measured {
    struct genes *t; /* owned: outputs of the genomes that have so many, one after the other; genes not owned */
    int *output;     /* owned: 0 xi, 1 eta */
    size_t n;
    struct errors *found[HELDOUT_PARTS]; /* owned, by t; NULL where the scene has no such part */
};

/** Measures the genomes of a file that have `outs` outputs, and adds the file's region.  From the worst samples of a genome of
 *  two outputs it climbs (climb.h), unless samples are left out.
 *  @param[in] most  samples of each part; SIZE_MAX: all
 *  @return false with *d filled; then, too, to be freed */
bool measure_genomes(struct genome_file *f, size_t outs, const struct heldout *heldout, size_t most, struct measured *m,
                     struct diag *d);
void measured_free(struct measured *m);

#endif
