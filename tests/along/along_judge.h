/* Draws lines through faces for tests, and intersects them by Newton's method in quadruple precision. */
#ifndef FOOTPOINT_ALONG_JUDGE_H
#define FOOTPOINT_ALONG_JUDGE_H

#include "../support/quad_precision.h"

#include <stdint.h>

/* Counts coordinates of nodes, slave node and direction. */
enum { MOST_ALONG = MOST_COORDINATES + 3 };

typedef double along_vectors[MOST_NODES + 2][3];

double along_uniform(uint64_t *stream);

/** Draws a moved face, `slim` times longer than wide, and a line through a point of it at an angle of about `angle`. */
void along_draw(uint64_t *stream, int nodes, double slim, double angle, along_vectors x);

/** Returns the length of a change of the direction that corresponds to changes of 1 in coordinates. */
double along_length(const double direction[3]);

/** Computes r_xi and r_eta by differences, which are exact for functions of degree at most 2. */
void along_tangents(const struct exact_face *f, const quadruple *y, quadruple xi, quadruple eta, quadruple a[3],
                    quadruple b[3]);

/** Finds {xi, eta, distance} near `from` for nodes, slave node and direction y. */
void along_solve(const struct exact_face *f, const quadruple *y, const double from[3], quadruple at[3]);

#endif
