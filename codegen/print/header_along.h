/* Projection along a direction in closed form: PREFIX_along and PREFIX_along_n, which need no genome. */
#ifndef FOOTPOINT_HEADER_ALONG_H
#define FOOTPOINT_HEADER_ALONG_H

#include "../compile/compiled_file.h"

/** Whether a kind has them: bilinear segments and flat triangles. */
bool along_exists(const struct segment_kind *k);

/** What they share, and both functions of a header. */
void along_print(const struct unit *u, FILE *out);

#endif
