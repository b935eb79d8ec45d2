/* Prints the test points of a header. */
#ifndef FOOTPOINT_POINTS_H
#define FOOTPOINT_POINTS_H

#include "../compile/compiled_file.h"

/** Prints a header with a table NAME_points for each function, which must be in double and not at a place of a face. */
void points_print(const struct unit *u, FILE *out);

#endif
