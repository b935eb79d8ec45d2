/* How a program's values scale with the size of a segment. */
#ifndef FOOTPOINT_DEGREE_H
#define FOOTPOINT_DEGREE_H

#include "../genome/segment_kind.h"
#include "program.h"

/** Finds the degree of an operation in lengths: if all nodes move away from the origin by a factor s, with normals
 *  kept, its value grows by s^degree. Returns false if the degree is not an integer, or undefined because lengths and
 *  numbers are added. */
bool homogeneous_degree(const struct program *p, const struct segment_kind *k, int op, int *degree);

/** Finds the largest |degree| of all operations, halves rounded up. Returns false if the outputs do not have degree 0,
 *  or if lengths and numbers are added on the way: then the program suits segments of a single size. */
bool homogeneous_steepest(const struct program *p, const struct segment_kind *k, int *steepest);

#endif
