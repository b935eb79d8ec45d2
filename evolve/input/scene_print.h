/* Prints an example scene from the tables of keys. */
#ifndef FOOTPOINT_SCENE_PRINT_H
#define FOOTPOINT_SCENE_PRINT_H

#include "../../codegen/genome/segment_kind.h"

#include <stdio.h>

/** Prints a scene of random segments of a kind, which can be read back. It contains every key with its meaning;
 *  optional keys are comments. */
void scene_print(const struct segment_kind *kind, FILE *stream);

#endif
