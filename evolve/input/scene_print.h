/* An example of a scene, made of the tables of keys. */
#ifndef FOOTPOINT_SCENE_PRINT_H
#define FOOTPOINT_SCENE_PRINT_H

#include "../../codegen/genome/segment_kind.h"

#include <stdio.h>

/** Prints a scene of random segments of that kind, which reads back.  Every key stands there with what it means; those
 *  that may be left out are comments. */
void scene_print(const struct segment_kind *kind, FILE *stream);

#endif
