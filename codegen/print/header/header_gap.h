/* Prints the gap from values that the search has computed on its way to xi and eta. */
#ifndef FOOTPOINT_HEADER_GAP_H
#define FOOTPOINT_HEADER_GAP_H

#include "header_lines.h"
#include "header_vectors.h"

/** Prints NAME_detail_gap, if vectors_shared: from the vectors, xi and eta it computes the gap, and an integer whose highest bit is set
 *  unless the answer is good beyond doubt.  It repeats the statements of the search that it needs; a compiler that inlines both
 *  computes them once. */
void gap_print(const struct unit *u, const struct function *f, FILE *out);

/** Adds the words of templates that use the vectors: VECTOR_STATEMENTS, which name them a, b, c and d, SIZE, RATIO, PER and
 *  UNIT.  Returns the printer of the statements, which the caller frees. */
struct printer *gap_add_words(struct words *w, const struct unit *u, const struct function *f,
                              const struct vectors_found *v);

#endif
