/* Frames: named values computed from a segment and a slave node, which the expressions of a tier are made of.  A frame
 * is genome text without genomes, evolve/frames/<name>.gen: its lets are the values. */
#ifndef FOOTPOINT_FRAME_H
#define FOOTPOINT_FRAME_H

#include "../common/columns.h"
#include "../input/scene.h"
#include "../surface/sample.h"

/** One program of all frames that the scene's tiers name: inputs, segment and corner order, and the lets of each
 *  frame, in the order of the tiers; the scene's reference point takes the place of the lets xi0 and eta0, and the
 *  bounds of its contact points that of xi_lo, xi_hi, eta_lo and eta_hi.  Returns NULL with *d filled if a frame cannot
 *  be read, two frames define one name differently or are of two versions of the format, or a terminal of a tier is no
 *  value of its frame.
 *  @param[in] path  name of the program, as it will be written */
struct genome_file *frame_program(const char *root, const struct scene *s, const char *path, struct diag *d);

/** Genes of an expression of file `from`, expressed in the symbols and constants of `to`: symbols by name, constants by
 *  text.  Fills gene[0..e->length-1]; false with *d filled if `to` lacks a symbol. */
bool frame_rebind(const struct genome_file *from, const struct genome_expr *e, struct genome_file *to, int *gene,
                  struct diag *d);

/** The columns of n samples: every symbol of the program, then the true xi and eta. */
struct columns frame_columns(const struct genome_file *program, const struct sample *s, size_t n);
/** The same in float: of samples whose coordinates are floats. */
struct columns frame_columns_single(const struct genome_file *program, const struct sample *s, size_t n);
/** Column of the true xi (output 0) or eta (output 1); past them for both (output 2). */
size_t frame_target(const struct genome_file *program, int output);

/** Names of the outputs: "xi", "eta", and "both". */
extern const char *const frame_output[TIER_OUTPUTS];

#endif
