/* Judges a library's answer by the reference of face.h; see library_judge.c. */
#ifndef FOOTPOINT_LIBRARY_JUDGE_H
#define FOOTPOINT_LIBRARY_JUDGE_H

#include "cases.h"
#include "face.h"

#define LIBRARY_TOLERANCE 1e-4 /* in longest edges, in space */

/** A case with its closest point. */
struct library_truth {
    struct library_case c;
    struct face face;
    struct face_nearest nearest;
};

enum library_verdict { VERDICT_RIGHT, VERDICT_WRONG, VERDICT_REFUSED, VERDICT_NONE /* nothing to judge */ };

/** Finds the closest point. Returns 0 if the reference is not certain, or if tests/hard finds another distance for a
 *  four-node face. */
int library_truth_find(int kind, const struct library_case *c, struct library_truth *t);

/** Judges an answer.
 *  @param[in]  status  LIBRARY_ANSWER or LIBRARY_NONE
 *  @param[out] off     the answer's error, in longest edges; 0 if no answer exists */
enum library_verdict library_judge(enum library_question question, const struct library_truth *t, int status,
                                   const struct library_answer *a, double *off);

/** Returns the worst error of derivatives, relative to the largest derivative of xi, eta or gap, by differences in
 *  extended precision. */
double library_judge_derivatives(const struct library_truth *t, const double d[3][15]);

#endif
