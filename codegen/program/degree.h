/* How a program's values change with the size of a segment. */
#ifndef FOOTPOINT_DEGREE_H
#define FOOTPOINT_DEGREE_H

#include "../genome/segment_kind.h"
#include "program.h"

/** Degree of an operation in lengths: with all nodes moved away from the origin by a factor s, normals kept, its value
 * is s^degree times as large.  False if it is no whole number, or if there is none because lengths meet numbers. */
bool homogeneous_degree(const struct program *p, const struct segment_kind *k, int op, int *degree);

/** The largest |degree| of all operations, halves rounded up.  False if the outputs are not of degree 0, or if lengths
 * meet numbers on the way there: then the program is one for segments of one size. */
bool homogeneous_steepest(const struct program *p, const struct segment_kind *k, int *steepest);

#endif
