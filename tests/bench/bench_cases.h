/* Questions with their right answers: a scene's samples, unchanged or turned into the question. */
#ifndef FOOTPOINT_BENCH_CASES_H
#define FOOTPOINT_BENCH_CASES_H

#include "../../evolve/input/scene.h"
#include "../../evolve/surface/sample.h"
#include "bench_methods.h"

/** Input of a method, and the right answer. */
struct bench_case {
    struct bench_input in;
    double xi, eta, gap; /* gap: the distance, for ASK_CLOSEST and ASK_ALONG */
    double size;         /* the square root of the face's area; errors of the gap are divided by it */
};

struct bench_cases {
    struct bench_case *of; /* owned */
    size_t n;
};

/** Returns nodes and slave node of a sample, without a last step's answer. */
struct bench_input bench_input_of(const struct segment_kind *kind, const struct sample *s);

/** Returns at most `most` cases of a question, evenly spread over the set. The last step's answer lies a hundredth of
 *  the segment away; for ASK_FROM_NEAR a thousandth, for ASK_FROM_FAR a tenth.
 *  ASK_OVER: BENCH_OVER consecutive cases share the segment of the first, each with the foot point and the gap,
 *    relative to the size of the face, of its own sample.
 *  ASK_CLOSEST: every other slave node is moved up to an edge beside its face, at a distance below the longest edge;
 *    tests/support/curved_face.h finds the certain closest point.
 *  ASK_ALONG: the slave node lies at the sample's gap from its foot point, in a direction at most 0.3 off the normal
 *    there; only for faces without node normals. */
struct bench_cases bench_cases_new(const struct scene *scene, enum bench_question question,
                                   const struct sample_set *set, size_t most);
void bench_cases_free(struct bench_cases *cases);

/** Computes the errors of xi, of eta, and of the gap or distance over the square root of the face's area. For
 *  ASK_DERIVATIVES, of the derivatives of xi and eta, relative to the largest, and of the gap. Errors are NaN if
 *  nothing was found. */
void bench_errors(const struct segment_kind *kind, enum bench_question question, const struct bench_case *c,
                  const double found[BENCH_FOUND], bench_slopes slope, double error[BENCH_FOUND]);

#endif
