/* Questions with their right answers: a scene's samples as they are, or made into what is asked. */
#ifndef FOOTPOINT_BENCH_CASES_H
#define FOOTPOINT_BENCH_CASES_H

#include "../../evolve/input/scene.h"
#include "../../evolve/surface/sample.h"
#include "bench_methods.h"

/** What a method is given, and what it should find. */
struct bench_case {
    struct bench_input in;
    double xi, eta, gap; /* gap: ASK_CLOSEST, ASK_ALONG: the distance */
    double size;         /* the square root of the face's area, over which errors of the gap are taken */
};

struct bench_cases {
    struct bench_case *of; /* owned */
    size_t n;
};

/** Returns nodes and slave node of a sample; there is no answer of the step before. */
struct bench_input bench_input_of(const struct segment_kind *kind, const struct sample *s);

/** Cases of a question, evenly spread over the set, `most` of them at most.  The answer of the step before lies a
 *  hundredth of the segment away, of ASK_FROM_NEAR a thousandth, of ASK_FROM_FAR a tenth.
 *  ASK_OVER: BENCH_OVER cases after each other have the segment of the first of them, and foot point and gap, over the
 *  size of the face, of their own samples.
 *  ASK_CLOSEST: every other slave node is moved up to an edge beside its face, less far away from it than its longest edge
 *  is long; the closest point is the certain one of tests/support/curved_face.h.
 *  ASK_ALONG: the slave node stands as far as the sample's gap off the sample's foot point in a direction near the
 *  normal there, 0.3 off it at most; of faces without normals. */
struct bench_cases bench_cases_new(const struct scene *scene, enum bench_question question,
                                   const struct sample_set *set, size_t most);
void bench_cases_free(struct bench_cases *cases);

/** Errors of what was found: of xi, of eta, and of the gap or distance over the square root of the face's area; of
 *  ASK_DERIVATIVES those of the derivatives of xi, eta and gap, over the greatest of xi and eta's, and over 1.  Not
 *  numbers where nothing was found. */
void bench_errors(const struct segment_kind *kind, enum bench_question question, const struct bench_case *c,
                  const double found[BENCH_FOUND], bench_slopes slope, double error[BENCH_FOUND]);

#endif
