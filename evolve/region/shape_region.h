/* Segments by their shape: numbers that determine a segment and a slave node up to position, size and orientation, and
 * the region block of genome text that recomputes the nodes. For kinds whose points are polynomials of xi and eta. */
#ifndef FOOTPOINT_SHAPE_REGION_H
#define FOOTPOINT_SHAPE_REGION_H

#include "../../codegen/genome/genome.h"
#include "../surface/sample.h"

enum { SHAPE_NUMBERS = 2 + 3 * 6 + 3 }; /* at most */

struct shape;

/** Returns a shape, which the caller must free(), or NULL if the kind's points are not polynomials. */
struct shape *shape_new(const struct segment_kind *kind);

size_t shape_numbers(const struct shape *p);

/** Returns the region block without ranges of the shape numbers, which are its last inputs. */
struct genome_file *shape_region(const struct shape *p);

/** Computes the shape numbers of a sample, and the sample as the block places it. */
void shape_measure(const struct shape *p, const struct sample *s, double number[SHAPE_NUMBERS], struct sample *placed);

/* ---- shape_requires.c ---- */

/** Adds the kind's region block. The survey then measures the ranges of its numbers on samples, and three requires for
 *  each intermediate value. The value stays within twice its largest distance from a multiple of xi, eta or a value
 *  foot_... of the block; the factor is a power of 2 times a power of 3. If that bounds little, its modulus stays below
 *  twice the largest on the samples. If it has a sign, its modulus stays above half the smallest. Returns NULL, and
 *  adds nothing, if the kind has no such block. */
struct shape_survey *shape_survey_new(struct genome_file *f);
void shape_survey_take(struct shape_survey *s, const struct sample *sample, size_t n);
/** Adds the ranges and requires, and frees the survey. */
void shape_survey_add(struct shape_survey *s);

#endif
