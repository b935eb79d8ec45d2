/* Projection along a direction: PREFIX_along and PREFIX_along_n, which need no genome. */
#ifndef FOOTPOINT_HEADER_ALONG_H
#define FOOTPOINT_HEADER_ALONG_H

#include "../../compile/compiled_file.h"

/** Of all segments without normals; of others nothing. */
void along_print(const struct unit *u, FILE *out);

#endif
