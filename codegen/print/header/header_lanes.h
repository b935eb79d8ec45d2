/* Loops over arrays of patches: pairs side by side, in single precision for rough promises. */
#ifndef FOOTPOINT_HEADER_LANES_H
#define FOOTPOINT_HEADER_LANES_H

#include "header_lines.h"

/** Prints the searches' steps, proofs and loops, in both precisions. */
void lanes_print_helpers(const struct unit *u, FILE *out);

/** Returns `f` renamed for single precision; the caller must free the name. */
struct function lanes_single(const struct function *f);

/** Prints the start of searches of pairs side by side, if functions start with f; in single precision
 * lanes_single(f). */
void lanes_print_begin(const struct unit *u, const struct function *f, bool single, FILE *out);

/** Prints NAME_checked_n and NAME_over_n. */
void lanes_print_calls(const struct unit *u, const struct function *f, FILE *out);

#endif
