/* Frames: named values computed from a segment and a slave node, from which the expressions of a tier are made. A frame
 * is genome text without genomes, evolve/frames/<name>.gen. Its lets are the values. */
#ifndef FOOTPOINT_FRAME_H
#define FOOTPOINT_FRAME_H

#include "../common/columns.h"
#include "../input/scene.h"
#include "../surface/sample.h"

/** Joins the frames that the scene's tiers name into one program: inputs, segment, order of corners, and the lets of
 *  each frame in the order of the tiers. The scene's reference point replaces the lets xi0 and eta0. The bounds of its
 *  contact points replace xi_lo, xi_hi, eta_lo and eta_hi. Returns NULL with *d filled if a frame cannot be read, if
 *  two frames define a name differently or have different versions of the format, or if a tier's terminal is not a
 *  value of its frame.
 *  @param[in] path  name of the program, as it will be written */
struct genome_file *frame_program(const char *root, const struct scene *s, const char *path, struct diag *d);

/** Rebinds an expression of `from` to the symbols and constants of `to`: symbols by name, constants by text. Fills
 *  gene[0..e->length-1]. Returns false with *d filled if `to` lacks a symbol. */
bool frame_rebind(const struct genome_file *from, const struct genome_expr *e, struct genome_file *to, int *gene,
                  struct diag *d);

/** Computes the columns of n samples: every symbol of the program, then the true xi and eta. */
struct columns frame_columns(const struct genome_file *program, const struct sample *s, size_t n);
/** Computes the same columns, in float if `single` is set; then the samples' coordinates must be floats. */
struct columns frame_columns_in(const struct genome_file *program, const struct sample *s, size_t n, bool single);
/** Returns the column of the true xi (output 0) or eta (output 1), or for output 2 the first column after them. */
size_t frame_target(const struct genome_file *program, int output);

/** Names of the outputs: "xi", "eta" and "both". */
extern const char *const frame_output[TIER_OUTPUTS];

#endif
