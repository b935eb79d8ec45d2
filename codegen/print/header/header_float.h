/* What the search over a segment in float has beyond that in double: coordinates moved and scaled before anything is
 * multiplied, and answers that are checked. */
#ifndef FOOTPOINT_HEADER_FLOAT_H
#define FOOTPOINT_HEADER_FLOAT_H

#include "../../compile/compiled_file.h"

/** The scale of a segment and, if there is a NAME_sure, the check of an answer. */
void single_print_helpers(const struct unit *u, FILE *out);

/** Coordinates as single_inputs() has them, before the statements of a function: those of node A as yA. */
void single_print_inputs(const struct unit *u, const struct function *f, FILE *out);

/** Whether functions of this unit can have a NAME_sure: bilinear segments alone, where there were samples. */
bool single_checks(const struct unit *u);

/** NAME_WORST, in capitals; caller frees. */
char *single_worst_name(const struct function *f);

/** The checked call of NAME_sure: its body, once its head is printed. `vectors` is "xA, xB, ..., xS". */
void single_print_sure(const struct function *f, const char *vectors, FILE *out);

#endif
