/* Prints projection along a direction: PREFIX_along and PREFIX_along_n, which need no genome. */
#ifndef FOOTPOINT_HEADER_ALONG_H
#define FOOTPOINT_HEADER_ALONG_H

#include "../../compile/compiled_file.h"

/** Returns false with *d filled if there is no projection for the segment's number of nodes. */
bool along_check(const struct unit *u, struct diag *d);

/** Prints it for segments without normals, otherwise nothing. */
void along_print(const struct unit *u, FILE *out);

#endif
